/// Programs, as a shell runs them.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"
#include "tests/kit/text.hpp"

namespace kit {

/// Returns: one word of the shell.
inline std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

struct Outcome {
  int exit_code;  ///< -1 where a signal ended it
  std::string out, err;
};

/// Runs a script of the shell, which reads nothing unless it says so, in the folder of the tests' own.
inline Outcome shell(const std::string& script) {
  const Folder folder;
  write(folder / "script", script + "\n");
  const std::string command = "sh " + quoted(folder / "script") + " >" + quoted(folder / "out") + " 2>" +
                              quoted(folder / "err") + " </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(folder / "out"), bytes_of(folder / "err")};
}

/// Checks that it failed with that code, said each of `expected` on standard error, and nothing on standard output.
inline void check_failed(const Outcome& outcome, int exit_code, const std::vector<std::string>& expected) {
  INFO(outcome.err);
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.out.empty());
  for (const std::string& part : expected) CHECK(has(outcome.err, part));
  CHECK(lines(outcome.err).size() <= 2);
}

}  // namespace kit
