// From failures to exit codes, in a process of its own: one of them ends it.

#include "walkthroughs/program/exit_code.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <system_error>

#include "render/file.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/program/program.hpp"

namespace exit_code_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

/// Runs `run` as a program does, in a child. `mebibytes`: of memory that it may have, where more than 0.
Outcome outcome_of(const std::function<int()>& run, rlim_t mebibytes = 0) {
  const Folder folder;
  const std::string err = (folder.path() / "stderr").string();
  const pid_t child = fork();
  if (child == 0) {
    const rlimit no_core{0, 0}, memory{mebibytes << 20, mebibytes << 20};
    ::setrlimit(RLIMIT_CORE, &no_core);
    if (mebibytes > 0) ::setrlimit(RLIMIT_AS, &memory);
    if (std::freopen(err.c_str(), "w", stderr) == nullptr) ::_exit(99);
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE})
      std::signal(signal, SIG_DFL);  // not those of the tests
    ::_exit(exit_code_of("gjkstep", "ask for less", run));
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, "", bytes_of(err)};
}

}  // namespace

TEST_CASE("A crash is told in a sentence and is exit code 1, also where the stack cannot grow") {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) {
    const Outcome outcome = outcome_of([&] { return std::raise(signal); });
    INFO(outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.err.starts_with("gjkstep: crashed ("));
    CHECK(has(outcome.err, ::sigdescr_np(signal)));
    CHECK(has(outcome.err, "report the command"));
    CHECK(lines(outcome.err).size() == 1);
  }
  const Outcome endless = outcome_of([] {
    const std::function<int(int)> deeper = [&](int depth) { return depth < 0 ? 0 : 1 + deeper(depth + 1); };
    return deeper(1);
  });
  CHECK(endless.exit_code == 1);
  CHECK(endless.err.starts_with("gjkstep: crashed (Segmentation fault)"));
}

TEST_CASE("Where memory is limited, a crash and a lack of memory name the limit") {
  const rlim_t plenty = rlim_t{1} << 30;  // MiB: sanitizers reserve a lot
  for (const std::function<int()>& run :
       std::vector<std::function<int()>>{[] { return std::raise(SIGABRT); }, []() -> int { throw std::bad_alloc(); }}) {
    const Outcome outcome = outcome_of(run, plenty);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK(has(outcome.err, "only 1073741824 MiB of memory are allowed (ulimit -v)"));
  }
  CHECK(has(outcome_of([]() -> int { throw std::bad_alloc(); }).err, "out of memory; ask for less\n"));
}

TEST_CASE("A thread that cannot be started is told with what to do, other errors of the system as they are") {
  const auto told = [](std::errc code) {
    return outcome_of([&]() -> int { throw std::system_error(std::make_error_code(code), "as it is"); });
  };
  const Outcome thread = told(std::errc::resource_unavailable_try_again), other = told(std::errc::no_link);
  CHECK(thread.exit_code == 1);
  CHECK(has(thread.err, "a thread cannot be started; allow more processes (ulimit -u)"));
  CHECK(other.exit_code == 1);
  CHECK(has(other.err, "gjkstep: as it is"));
}

}  // namespace exit_code_test
