#include "walkthroughs/judge/asking.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

namespace walkthroughs::judge {
namespace asking_test {

using test::Folder;

std::vector<std::string> numbered(int count) {
  std::vector<std::string> questions;
  for (int i = 0; i < count; ++i) questions.push_back(std::to_string(i));
  return questions;
}

AskedProgram shell(const std::string& script, int milliseconds = 60000) {
  return {.words = {"sh", "-c", script}, .limit = std::chrono::milliseconds(milliseconds)};
}

Replies ask_shell(const std::string& script, int count, int milliseconds = 60000) {
  return ask_all(shell(script, milliseconds), numbered(count));
}

int count_of(const Replies& replies, Reply::Kind kind) {
  return static_cast<int>(std::ranges::count(replies.all, kind, &Reply::kind));
}

/// Whether all but these have the line that echoes them.
void check_echo_but(const Replies& replies, const std::vector<std::size_t>& but) {
  for (std::size_t i = 0; i < replies.all.size(); ++i) {
    INFO(i);
    if (std::ranges::count(but, i) > 0)
      CHECK(replies.all[i].kind != Reply::line);
    else
      CHECK((replies.all[i].kind == Reply::line && replies.all[i].text == "got " + std::to_string(i)));
  }
}

const std::string echo = "while read x; do ";

TEST_CASE("Asking: each question has the line that answers it, whether output is kept back or not") {
  check_echo_but(ask_shell(echo + "echo got $x; done", 100), {});
  check_echo_but(ask_shell("sed 's/^/got /'", 100), {});               // all at the end
  const Replies last = ask_all(shell("printf 'got 0'"), numbered(1));  // without a line feed
  check_echo_but(last, {});
  std::vector<std::string> long_ones(50, std::string(100000, 'x'));
  const Replies replies = ask_all(shell("cat"), long_ones);
  CHECK(std::ranges::all_of(replies.all, [](const Reply& reply) { return reply.text.size() == 100000; }));
}

TEST_CASE("Asking: who crashes at one question is blamed for that one, whether output is kept back or not", "[full]") {
  const auto python = [](const std::string& flush) {
    const std::string script =
        "import os, sys\nfor x in sys.stdin:\n  if int(x) == 41: os.kill(os.getpid(), 11)\n"
        "  print('got', x.strip(), flush=" +
        flush + ")\n";
    return ask_all({.words = {"python3", "-c", script}, .limit = std::chrono::seconds(60)}, numbered(60));
  };
  for (const std::string flush : {"True", "False"}) {
    const Replies replies = python(flush);
    check_echo_but(replies, {41});
    CHECK(replies.all[41].kind == Reply::ended);
    CHECK(replies.crashes_in_company == 0);
  }
  const Replies replies = ask_shell(echo + "[ $x = 3 ] && exit 7; echo got $x; done", 6);
  check_echo_but(replies, {3});
  CHECK(replies.all[3].text == "exit code 7");
}

TEST_CASE("Asking: a crash after so many questions, whichever they are, is counted and blamed on none") {
  const Replies replies = ask_shell("n=0; " + echo + "n=$((n+1)); [ $n = 17 ] && kill -SEGV $$; echo got $x; done", 60);
  check_echo_but(replies, {});
  CHECK(replies.crashes_in_company >= 1);
  CHECK(replies.first_crash == "signal 11 (Segmentation fault)");
  CHECK(replies.answers_before_first_crash == 16);
  const Replies by_exit_code = ask_shell("n=0; " + echo + "n=$((n+1)); [ $n = 17 ] && exit 1; echo got $x; done", 60);
  check_echo_but(by_exit_code, {});
  CHECK(by_exit_code.crashes_in_company >= 1);
  CHECK(by_exit_code.first_crash == "exit code 1");
  const Replies in_the_end = ask_shell(echo + "echo got $x; done; kill -ABRT $$", 5);
  check_echo_but(in_the_end, {});
  CHECK(in_the_end.crashes_in_company == 1);
  const Replies after_the_last = ask_shell(echo + "echo got $x; done; exit 3", 5);  // which says something else
  CHECK(after_the_last.crashes_in_company == 0);
}

TEST_CASE("Asking: who answers one question and ends is started again for each, which is counted") {
  const Replies replies = ask_shell("read x; echo got $x", 20);
  check_echo_but(replies, {});
  CHECK(replies.early_ends >= 10);
  CHECK(replies.crashes_in_company == 0);
}

TEST_CASE("Asking: who answers a few questions and then hangs is given up", "[full]") {
  const Replies replies = ask_shell("read x; echo got $x; sleep 100", 100, 100);
  CHECK(replies.was_given_up);
  CHECK(count_of(replies, Reply::line) == 20);
  CHECK(count_of(replies, Reply::not_asked) == 80);
}

TEST_CASE("Asking: who hangs after so many questions, whichever they are, is told as late, blamed on none and given up",
          "[full]") {
  const std::string hangs_at_4 = "n=0; " + echo + "n=$((n+1)); [ $n = 4 ] && sleep 100; echo got $x; done";
  const Replies few = ask_shell(hangs_at_4, 12, 300);
  check_echo_but(few, {});
  CHECK(few.late_in_company > 1);
  CHECK(few.answers_before_first_late == 3);
  CHECK(few.crashes_in_company == 0);
  const Replies many = ask_shell(hangs_at_4, 500, 100);
  CHECK(many.was_given_up);
  CHECK(count_of(many, Reply::late) == 0);
  CHECK(ask_shell("sed 's/^/got /'; sleep 100", 12, 300).late_in_company == 0);
}

TEST_CASE("Asking: a line that was not ended in time is no answer") {
  const Replies replies = ask_shell("read x; while :; do printf t; sleep 0.05; done", 1, 300);
  CHECK(replies.all[0].kind == Reply::late);
}

TEST_CASE("Asking: who is late at one question is late for that one, and started again", "[full]") {
  const Replies replies = ask_shell(echo + "[ $x = 5 ] && sleep 100; echo got $x; done", 30, 2000);
  check_echo_but(replies, {5});
  CHECK(replies.all[5].kind == Reply::late);
  CHECK(replies.all[5].text == "no answer within 2 s");
}

TEST_CASE("Asking: who is late and has closed its output or its input is told as that", "[full]") {
  CHECK(ask_shell("exec >&-; sleep 100", 1, 500).all[0].text == "no answer within 0.5 s; it had closed its output");
  for (const std::size_t length : {std::size_t{1} << 20, std::size_t{60}}) {  // more than a pipe holds, and less
    const Replies refused = ask_all(shell("exec <&-; sleep 100", 500), {std::string(length, 'x')});
    CHECK(refused.all[0].text == "no answer within 0.5 s; it had closed its input");
  }
  CHECK(ask_shell("read x; echo got $x; exec <&-; sleep 100", 3, 300).closes_its_input);
  CHECK_FALSE(ask_shell("sed 's/^/got /'; exec <&-; sleep 100", 3, 300).closes_its_input);  // it had answered them all
}

TEST_CASE("Asking: who never answers is given up", "[full]") {
  const Replies late = ask_shell("sleep 100", 40, 100);
  CHECK(late.was_given_up);
  CHECK(count_of(late, Reply::late) == 5);
  CHECK(count_of(late, Reply::not_asked) == 35);
  const Replies ended = ask_shell("echo oh no >&2; exit 3", 100);
  CHECK(ended.was_given_up);
  CHECK(count_of(ended, Reply::ended) == 50);
  CHECK(ended.all[0].text == "exit code 3");
  CHECK(ended.said == "oh no\n");
}

TEST_CASE("Asking: who closes its input, or does not read it, may answer all the same") {
  check_echo_but(ask_shell("exec <&-; for i in 0 1 2 3 4 5; do echo got $i; done", 6), {});
  const Replies replies = ask_all(shell("exec <&-; for i in 1 2 3; do echo no; done"),
                                  std::vector<std::string>(3, std::string(1 << 20, 'x')));
  CHECK(count_of(replies, Reply::line) == 3);
}

TEST_CASE("Asking: who writes without end is stopped, by lines and without") {
  const Replies lines = ask_shell("yes got 0", 1);
  CHECK(lines.floods > 0);
  check_echo_but(lines, {});
  const Replies one_line = ask_shell("cat /dev/zero", 3);
  CHECK(count_of(one_line, Reply::flooding) == 3);
  CHECK(one_line.all[0].text == "a line longer than 1 MB");
  CHECK((one_line.floods == 0 && one_line.long_lines > 0));
}

TEST_CASE("Asking: who writes several lines for a pair is given up soon, whether output is kept back or not") {
  for (const std::string& script :
       {echo + "echo asked; echo got $x; done", std::string("exec <&-; yes got 0 | head -1000")}) {
    INFO(script);
    const Replies replies = ask_shell(script, 40);
    CHECK(replies.was_given_up);
    CHECK(replies.floods >= 3);
    CHECK(count_of(replies, Reply::not_asked) == 37);
  }
}

/// A process that has ended has no program.
bool is_running(const std::string& process) {
  std::error_code error;
  return !std::filesystem::read_symlink("/proc/" + process + "/exe", error).empty();
}

TEST_CASE("Asking: of a program that starts others nothing is left, wherever these have gone", "[full]") {
  const Folder folder;
  const std::string pids = (folder.path() / "pids").string(), tell = " & echo $! >>" + pids + "; ";
  for (const std::string& start :
       {"sleep 1000" + tell, "setsid sleep 1000" + tell, "(setsid sh -c 'sleep 1000" + tell + "wait' &); ",
        "trap '' TERM HUP; sleep 1000" + tell})
    for (const std::string& then : {echo + "echo got $x; done", std::string("exit 1"), std::string("sleep 100")}) {
      INFO(start << then);
      std::filesystem::remove(pids);
      ask_shell(start + "until [ -s " + pids + " ]; do :; done; " + then, 2, 2000);
      std::ifstream list(pids);
      int count = 0;
      for (std::string pid; list >> pid; ++count) CHECK_FALSE(is_running(pid));
      CHECK(count > 0);
    }
}

TEST_CASE("Asking: what this process had started before is left alone") {
  const pid_t before = ::fork();
  if (before == 0) {
    ::pause();
    ::_exit(0);
  }
  check_echo_but(ask_shell(echo + "echo got $x; done", 3), {});
  CHECK(::waitpid(before, nullptr, WNOHANG) == 0);
  ::kill(before, SIGKILL);
  CHECK(::waitpid(before, nullptr, 0) == before);
}

TEST_CASE("Asking: a program is told that its reader has left as anywhere else") {
  const Replies replies = ask_shell("trap - PIPE; (yes; echo $? >&2) | head -1; read x; echo got 1", 2);
  CHECK(count_of(replies, Reply::line) == 2);
}

TEST_CASE("Asking: a program that is not there cannot be started") {
  for (const std::string name : {"/nowhere/at/all", "", "/"}) {
    INFO(name);
    CHECK_THROWS_AS(ask_all({.words = {name}}, numbered(3)), CannotStart);
  }
}

}  // namespace asking_test
}  // namespace walkthroughs::judge
