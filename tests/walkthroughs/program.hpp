/// The program as its users run it. GJKSTEP_PROGRAM is its path, given by the build.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/walkthroughs/support.hpp"

namespace walkthroughs::test {

inline std::string quoted(const std::string& text) { return "'" + text + "'"; }  // no test needs a ' inside

struct Outcome {
  int exit_code;
  std::string out, err;
};

/// Where standard output and standard error go.
struct Streams {
  std::string out, err;  ///< files; where empty, to be read back
};

inline Outcome run(const std::string& arguments, const std::string& environment = "", const Streams& streams = {}) {
  const Folder folder;
  const std::string out = (folder.path() / "stdout").string(), err = (folder.path() / "stderr").string();
  const std::string command = "env " + environment + " " + quoted(GJKSTEP_PROGRAM) + " " + arguments + " >" +
                              quoted(streams.out.empty() ? out : streams.out) + " 2>" +
                              quoted(streams.err.empty() ? err : streams.err);
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(out), bytes_of(err)};
}

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    list.push_back(text.substr(at, end - at));
  return list;
}

/// Checks that the command fails with that code, says each of `expected` on standard error and nothing on standard output.
inline void check_failure(const std::string& arguments, int exit_code, const std::vector<std::string>& expected,
                          const std::string& environment = "") {
  INFO(environment << " gjkstep " << arguments);
  const Outcome outcome = run(arguments, environment);
  INFO(outcome.err);
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.out.empty());
  for (const std::string& part : expected) CHECK(has(outcome.err, part));
  CHECK(lines(outcome.err).size() <= 2);
}

}  // namespace walkthroughs::test
