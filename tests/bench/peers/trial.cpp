#include "tests/bench/peers/trial.hpp"

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <span>
#include <system_error>

namespace peers {
namespace {

/// Answers in memory that a child process writes and its parent reads.
class SharedAnswers {
 public:
  explicit SharedAnswers(std::size_t count)
      : size_(count + sizeof(std::size_t)),
        memory_(mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
    next() = 0;
    for (std::size_t i = 0; i < count; ++i) (*this)[i] = Answer::not_asked;
  }
  ~SharedAnswers() { munmap(memory_, size_); }
  SharedAnswers(const SharedAnswers&) = delete;
  SharedAnswers& operator=(const SharedAnswers&) = delete;

  /// The pair that is being asked.
  volatile std::size_t& next() { return *static_cast<std::size_t*>(memory_); }
  Answer& operator[](std::size_t i) { return reinterpret_cast<Answer*>(static_cast<std::size_t*>(memory_) + 1)[i]; }

 private:
  std::size_t size_;
  void* memory_;
};

[[noreturn]] void ask_in_child(Batch& batch, std::size_t pairs, SharedAnswers& answers) {
  const itimerval limit{.it_interval = {}, .it_value = {.tv_sec = seconds_for_a_pair, .tv_usec = 0}};
  for (std::size_t i = answers.next(); i < pairs; ++i) {
    answers.next() = i;
    setitimer(ITIMER_VIRTUAL, &limit, nullptr);  // SIGVTALRM ends this process
    answers[i] = batch.ask(i);
  }
  answers.next() = pairs;
  _exit(0);
}

int status_of_child(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  return status;
}

}  // namespace

std::vector<Answer> tried(Batch& batch, std::size_t pairs) {
  SharedAnswers answers(pairs);
  for (int failures = 0; answers.next() < pairs && failures < failures_before_giving_up; ++failures) {
    const pid_t child = fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (child == 0) ask_in_child(batch, pairs, answers);
    const int status = status_of_child(child);
    if (answers.next() == pairs) break;
    const bool late = WIFSIGNALED(status) && WTERMSIG(status) == SIGVTALRM;
    answers[answers.next()] = late ? Answer::timed_out : Answer::crashed;
    answers.next() = answers.next() + 1;
  }
  return {&answers[0], &answers[0] + pairs};
}

}  // namespace peers
