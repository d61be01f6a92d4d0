// gjkstep query between pipes that are set to wait for nothing.

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <string_view>
#include <thread>

#include "tests/walkthroughs/program/program.hpp"

using namespace walkthroughs::test;

namespace {

constexpr const char* touching = R"({"a":{"points":[[0,0,0]]},"b":{"points":[[0,0,0]]}})"
                                 "\n";

/// gjkstep query at the other end of two pipes that are set to wait for nothing.
class NeverWaiting {
 public:
  NeverWaiting() {
    int in[2], out[2];
    REQUIRE((pipe2(in, O_CLOEXEC) == 0 && pipe2(out, O_CLOEXEC) == 0));
    fcntl(in[0], F_SETFL, O_NONBLOCK);
    fcntl(out[1], F_SETFL, O_NONBLOCK);
    if ((child_ = fork()) == 0) {
      dup2(in[0], STDIN_FILENO);
      dup2(out[1], STDOUT_FILENO);
      dup2(::open("/dev/null", O_WRONLY), STDERR_FILENO);
      execl(kit::program().c_str(), kit::program().c_str(), "query", nullptr);
      _exit(127);
    }
    close(in[0]);
    close(out[1]);
    to_ = in[1];
    from_ = out[0];
  }
  ~NeverWaiting() { close(from_); }
  NeverWaiting(const NeverWaiting&) = delete;
  NeverWaiting& operator=(const NeverWaiting&) = delete;

  /// Returns: whether the whole text could be handed over.
  bool write(std::string_view text) const {
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t count = ::write(to_, text.data() + done, text.size() - done);
      if (count <= 0) return false;
      done += static_cast<std::size_t>(count);
    }
    return true;
  }
  /// Returns: what there is, after at least one byte; empty at the end.
  std::string read() const {
    std::string text(1 << 16, ' ');
    const ssize_t count = ::read(from_, text.data(), text.size());
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
  }
  /// Returns when it waits for something, or has ended: what /proc tells behind its name, "(gjkstep) S".
  void until_it_sleeps() const {
    std::string told;
    do {
      std::getline(std::ifstream("/proc/" + std::to_string(child_) + "/stat"), told);
      std::this_thread::yield();
    } while (!has(told, "(gjkstep) S") && !has(told, ") Z"));
  }
  int close_and_wait() {
    close(to_);
    int status = 0;
    waitpid(child_, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t child_ = 0;
  int to_ = -1, from_ = -1;
};

/// While it lives, writing to a pipe that nobody reads is an error and no signal.
struct NoBrokenPipes {
  void (*before)(int) = std::signal(SIGPIPE, SIG_IGN);
  ~NoBrokenPipes() { std::signal(SIGPIPE, before); }
};

}  // namespace

TEST_CASE("gjkstep query waits where its pipes do not, for pairs") {
  const NoBrokenPipes guard;
  NeverWaiting query;
  for (int i = 0; i < 3; ++i) {
    query.until_it_sleeps();
    REQUIRE(query.write(touching));
    REQUIRE(has(query.read(), "intersecting"));
  }
  CHECK(query.close_and_wait() == 0);
}

TEST_CASE("gjkstep query waits where its pipes do not, for who reads its answers") {
  const NoBrokenPipes guard;
  NeverWaiting query;
  constexpr int pairs = 1000;  // which one pipe holds, but not their answers
  std::string text;
  for (int i = 0; i < pairs; ++i) text += touching;
  REQUIRE(query.write(text + "the end\n"));
  query.until_it_sleeps();
  std::string said;
  for (std::string part; !said.ends_with(",\"line\":1001}\n") && !(part = query.read()).empty();) said += part;
  CHECK(lines(said).size() == pairs + 1);
  CHECK(query.close_and_wait() == 3);
}
