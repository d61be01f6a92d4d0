#include "walkthroughs/judge/run_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <system_error>
#include <utility>

#include "walkthroughs/text/printable.hpp"

namespace walkthroughs::judge {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t longest_line = std::size_t{1} << 20, most_said = 2000;

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

/// An open file that closes itself.
class File {
 public:
  explicit File(int descriptor = -1) : descriptor_(descriptor) {}
  File(File&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  File& operator=(File&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~File() { close(); }
  void close() {
    if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
  }
  int get() const { return descriptor_; }
  bool is_open() const { return descriptor_ >= 0; }

 private:
  int descriptor_;
};

/// Where this process has closed a standard stream, a pipe would take its number.
File above_standard(int descriptor) {
  File file(descriptor);
  if (descriptor > STDERR_FILENO) return file;
  File moved(::fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  if (!moved.is_open()) fail("a pipe cannot be made");
  return moved;
}

struct Pipe {
  File read, write;
  Pipe() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) fail("a pipe cannot be made");
    read = above_standard(ends[0]);
    write = above_standard(ends[1]);
  }
};

/// A program that has closed its standard input must not end this one.
class NoSigpipe {
 public:
  NoSigpipe() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~NoSigpipe() { std::signal(SIGPIPE, before_); }

 private:
  void (*before_)(int);
};

/// Somebody may end this process while it waits. Then what it has started is ended first: such signals are kept back until then.
class KeptBack {
 public:
  KeptBack() {
    ::sigemptyset(&kept_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::sigaddset(&kept_, signal);
    ::pthread_sigmask(SIG_BLOCK, &kept_, &before_);
  }
  ~KeptBack() { restore(); }  // and they arrive
  void restore() const { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  bool has_some() const {
    sigset_t pending;
    ::sigpending(&pending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
      if (::sigismember(&pending, signal) == 1 && ::sigismember(&before_, signal) == 0) return true;
    return false;
  }

 private:
  sigset_t kept_, before_;
};

// -- Starting ---------------------------------------------------------------------------------------------------------

struct Streams {
  Pipe in, out, err, failure;
};

/// Never returns. Where SIGKILL ends this process nothing of it is run any more: so another waits for that, and then ends its
/// group, which is the program's.
///
/// Requires: SIGTERM is blocked.
[[noreturn]] void watch(pid_t parent) {
  ::close_range(0, ~0U, 0);  // a copy would keep the program's streams open
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  sigset_t end_of_parent;
  ::sigemptyset(&end_of_parent);
  ::sigaddset(&end_of_parent, SIGTERM);
  for (int ignored = 0; ::getppid() == parent;) ::sigwait(&end_of_parent, &ignored);
  ::kill(0, SIGKILL);
  ::_exit(0);
}

/// Returns: the process that watches, and its group.
pid_t start_watching() {
  const pid_t parent = ::getpid(), watcher = ::fork();
  if (watcher < 0) fail("a process cannot be started");
  if (watcher > 0) {
    ::setpgid(watcher, watcher);  // whichever comes first
    return watcher;
  }
  ::setpgid(0, 0);
  watch(parent);
}

/// Never returns. Requires: nothing but this thread is needed, as no other is in the copy of the process.
[[noreturn]] void become(const std::vector<char*>& words, const Streams& streams, pid_t parent, pid_t group,
                         const KeptBack& signals) {
  ::setpgid(0, group);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it was ended before it could have been noticed
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_DFL);
  signals.restore();
  ::dup2(streams.in.read.get(), STDIN_FILENO);
  ::dup2(streams.out.write.get(), STDOUT_FILENO);
  ::dup2(streams.err.write.get(), STDERR_FILENO);
  ::execvp(words[0], words.data());
  const int reason = errno;
  if (::write(streams.failure.write.get(), &reason, sizeof reason) < 0) ::_exit(126);
  ::_exit(127);
}

/// Returns: the process. Errors: CannotStart.
pid_t start(const std::vector<std::string>& words, Streams& streams, pid_t group, const KeptBack& signals) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  const pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) fail("a process cannot be started");
  if (child == 0) become(pointers, streams, parent, group, signals);
  streams.in.read.close();
  for (Pipe* const pipe : {&streams.out, &streams.err, &streams.failure}) pipe->write.close();
  int reason = 0;
  ssize_t count = 0;
  while ((count = ::read(streams.failure.read.get(), &reason, sizeof reason)) < 0 && errno == EINTR) continue;
  if (count != sizeof reason) return child;
  ::kill(group, SIGKILL);
  for (const pid_t each : {child, group}) ::waitpid(each, nullptr, 0);
  throw CannotStart("the program " + in_quotes(words[0]) + " cannot be started: " + std::strerror(reason) +
                    "; write its path after --, and make it executable");
}

// -- Ending -----------------------------------------------------------------------------------------------------------

/// Returns: the processes that this one has to wait for.
std::vector<pid_t> own_children() {
  std::vector<pid_t> all;
  std::error_code ignored;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task", ignored)) {
    std::ifstream list(thread.path() / "children");
    for (pid_t child; list >> child;) all.push_back(child);
  }
  return all;
}

/// What a process has started becomes this one's when it ends (PR_SET_CHILD_SUBREAPER): so that, killed again and again,
/// there is none left but those that were here before.
void kill_all_that_is_left(pid_t group, const std::vector<pid_t>& before) {
  ::kill(-group, SIGKILL);
  const auto left = [&] {
    std::vector<pid_t> children = own_children();
    std::erase_if(children, [&](pid_t child) { return std::ranges::find(before, child) != before.end(); });
    return children;
  };
  for (std::vector<pid_t> now = left(); !now.empty(); now = left())
    for (const pid_t child : now) {
      ::kill(child, SIGKILL);
      while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
    }
}

std::string words_of_status(int status) {
  if (!WIFSIGNALED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
  const char* const words = ::sigdescr_np(WTERMSIG(status));
  return "signal " + std::to_string(WTERMSIG(status)) + (words ? " (" + std::string(words) + ")" : "");
}

// -- Talking ----------------------------------------------------------------------------------------------------------

/// Writes, and reads, what can be without waiting.
class Talk {
 public:
  using Counts = std::function<bool(std::string_view)>;

  Talk(Streams&& streams, std::span<const std::string> questions, const Counts& counts, const AlsoKept& also)
      : streams_(std::move(streams)), questions_(questions), counts_(counts), also_(also) {
    for (const File* const file : {&streams_.in.write, &streams_.out.read, &streams_.err.read})
      ::fcntl(file->get(), F_SETFL, O_NONBLOCK);
    take_question();
  }

  /// Waits until something can be done, but not longer.
  void wait(std::chrono::milliseconds longest) {
    std::array<pollfd, 3> polled{pollfd{streams_.in.write.get(), POLLOUT, 0},
                                 pollfd{streams_.out.read.get(), POLLIN, 0},
                                 pollfd{streams_.err.read.get(), POLLIN, 0}};  // -1 is passed over
    ::poll(polled.data(), polled.size(), static_cast<int>(longest.count()));
  }

  /// Returns: how many lines came. The last may lack its line feed, unless the program was ended while it wrote it.
  std::size_t go_on(RunOfProgram& run, bool may_lack_line_feed = true) {
    write();
    const std::size_t before = lines_seen_;
    read(streams_.out.read, [&](std::string_view text) { add(text, run); });
    read(streams_.err.read, [&](std::string_view text) {
      run.said.append(text);
      if (run.said.size() > most_said) run.said.erase(0, run.said.size() - most_said);
    });
    if (may_lack_line_feed && !streams_.out.read.is_open() && !line_.empty()) add("\n", run);
    return lines_seen_ - before;
  }

  bool output_is_open() const { return streams_.out.read.is_open(); }
  bool input_was_refused() const { return input_was_refused_; }
  bool has_too_many_lines() const { return lines_seen_ > questions_.size() || has_too_many_others_; }
  bool has_long_line() const { return line_.size() > longest_line; }
  bool is_flooded() const { return has_too_many_lines() || has_long_line(); }

 private:
  void take_question() {
    if (next_ < questions_.size())
      unwritten_ = questions_[next_++] + "\n";
    else
      streams_.in.write.close();
  }

  void write() {
    while (streams_.in.write.is_open()) {
      const ssize_t count = ::write(streams_.in.write.get(), unwritten_.data(), unwritten_.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0 && errno == EAGAIN) return;
      if (count < 0) {  // it does not want to know more
        input_was_refused_ = true;
        return streams_.in.write.close();
      }
      unwritten_.erase(0, static_cast<std::size_t>(count));
      if (unwritten_.empty()) take_question();
    }
  }

  template <class Use>
  void read(File& file, const Use& use) {
    std::array<char, 1 << 16> block;
    while (file.is_open() && !is_flooded()) {
      const ssize_t count = ::read(file.get(), block.data(), block.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0 && errno == EAGAIN) return;
      if (count <= 0) return file.close();
      use(std::string_view(block.data(), static_cast<std::size_t>(count)));
    }
  }

  void add(std::string_view text, RunOfProgram& run) {
    for (const char letter : text) {
      if (letter != '\n') {
        line_ += letter;
        continue;
      }
      take_line(run);
      line_.clear();
    }
  }

  void take_line(RunOfProgram& run) {
    if (counts_(line_)) {
      if (++lines_seen_ > questions_.size()) return;
      ++run.answers;
      return run.lines.push_back(line_);
    }
    if (also_.counts(line_)) {
      has_too_many_others_ = ++also_seen_ > also_.most * questions_.size();
      return run.lines.push_back(line_);
    }
    if (run.others++ == 0) run.first_other = line_;
    has_too_many_others_ = has_too_many_others_ || run.others > most_others * (questions_.size() + 10);
  }

  static constexpr std::uint64_t most_others = 100;  // for each question
  Streams streams_;
  std::span<const std::string> questions_;
  const Counts& counts_;
  const AlsoKept& also_;
  std::size_t next_ = 0, lines_seen_ = 0, also_seen_ = 0;
  bool has_too_many_others_ = false;
  std::string unwritten_, line_;
  bool input_was_refused_ = false;
};

/// Whether that process, which is still there, has closed its standard input: what is written into a pipe is not missed.
bool has_no_input(pid_t process) {
  std::error_code error;  // whatever it leads to, such as a pipe, which has no name
  const auto kind = std::filesystem::symlink_status("/proc/" + std::to_string(process) + "/fd/0", error).type();
  return kind == std::filesystem::file_type::not_found;
}

/// Returns: its status, once it has ended.
std::optional<int> status_of(pid_t child) {
  int status = 0;
  return ::waitpid(child, &status, WNOHANG) == child ? std::optional(status) : std::nullopt;
}

}  // namespace

RunOfProgram run_program(const std::vector<std::string>& words, std::span<const std::string> questions,
                         std::chrono::milliseconds limit, const std::function<bool(std::string_view)>& counts,
                         const AlsoKept& also) {
  const KeptBack signals;
  const NoSigpipe no_sigpipe;
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  // What this process was before, a shell that became it, may have started some, and they are its own.
  const std::vector<pid_t> before = own_children();
  Streams streams;
  const pid_t group = start_watching(), child = start(words, streams, group, signals);
  Talk talk(std::move(streams), questions, counts, also);
  RunOfProgram run;
  std::optional<int> status;
  for (Clock::time_point late = Clock::now() + limit;
       !status && !talk.is_flooded() && !signals.has_some() && Clock::now() < late;) {
    // Its end is seen by looking: the streams may stay open in what it has started.
    talk.wait(talk.output_is_open() ? std::min(limit, std::chrono::milliseconds(20)) : std::chrono::milliseconds(1));
    status = status_of(child);
    if (talk.go_on(run) > 0) late = Clock::now() + limit;
  }
  run.closed_input = talk.input_was_refused() || (!status && has_no_input(child));
  run.closed_output = !status && !talk.output_is_open();
  kill_all_that_is_left(group, before);
  talk.go_on(run, status.has_value());
  if (status) {
    run.how = words_of_status(*status);
    run.was_killed_by_signal = WIFSIGNALED(*status);
    run.failed = *status != 0;
  }
  if (talk.has_too_many_lines())
    run.end = End::flooding;
  else if (talk.has_long_line())
    run.end = End::long_line;
  else if (run.answers < questions.size())
    run.end = status ? End::ended : End::late;
  else
    run.outlives_its_input = !status;
  return run;
}

}  // namespace walkthroughs::judge
