// gjkstep query as its users run it.

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <string_view>
#include <thread>

#include "tests/kit/places.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "tests/walkthroughs/query/queries.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

/// Runs a command of the shell in which $program is gjkstep and $folder an empty folder.
Outcome with_program(const std::string& command) {
  const Folder folder;
  return shell("program=" + quoted(kit::program()) + "\nfolder=" + quoted(folder.path()) + "\n" + command);
}

Outcome query(const std::string& input, const std::string& options = "") {
  const Folder folder;
  const std::string file = (folder.path() / "pairs.jsonl").string();
  std::ofstream(file) << input;
  return with_program("$program query " + options + " <" + quoted(file));
}

}  // namespace

TEST_CASE("gjkstep query answers and is exit code 0") {
  const Outcome outcome = query(pair_of(ball, ball_ten_away) + "\n" + pair_of(ball, ball));
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  REQUIRE(lines(outcome.out).size() == 2);
  CHECK(has(lines(outcome.out)[0], "\"separated\""));
  CHECK(has(lines(outcome.out)[1], "\"intersecting\""));
  CHECK(query("").exit_code == 0);
}

TEST_CASE("gjkstep query does as its options say") {
  const std::string line = pair_of(ball, ball_ten_away) + "\n";
  CHECK(has(query(line, "--rules as-printed").out, "\"intersecting\""));
  CHECK(has(query(line, "--rules as-intended").out, "\"separated\""));
  CHECK(has(query(line, "--rules eager").out, R"("separated","iterations":1,)"));
  CHECK(query(line, "--zero-test exact").out == query(line).out);
  const std::string touching =
      pair_of(R"({"points":[[0.1,0.2,0.3],[0.4,0.5,0.6]]})", R"({"points":[[0.4,0.5,0.6],[0.7,0.1,0.2]]})");
  CHECK(has(query(touching, "--zero-test relative").out, "\"intersecting\""));
  CHECK(has(query(line, "--max-iterations 1").out, R"("undecided","iterations":1,"reason":"iteration-limit")"));
  const std::string tenth = pair_of(R"({"points":[[0.1,0,0]]})", R"({"points":[[1,0,0]]})") + "\n";
  CHECK(has(query(tenth, "--scalar float").out, "\"a\":[0.1,0,0]"));
  CHECK(has(query(tenth, "--scalar double").out, "\"a\":[0.1,0,0]"));
  CHECK(has(query(tenth, "--scalar long-double").out, "\"a\":[0.10000000000000000555,0,0]"));
  CHECK(has(query(tenth, "--scalar exact").out, "\"a\":[\"3602879701896397/36028797018963968\",\"0\",\"0\"]"));
}

TEST_CASE("gjkstep query begins a search where it is told") {
  const std::string line = pair_of(R"({"points":[[0,0,0],[0,0,1]]})", R"({"points":[[1,9,0],[2,5,0]]})") + "\n";
  const auto direction = [&](const std::string& options) {
    const std::string out = query(line, "--rules eager " + options).out;
    const std::size_t at = out.find("\"direction\":");
    return at == std::string::npos ? out : out.substr(at + 12, out.find(']', at) - at - 11);
  };
  CHECK(direction("") == "[1.5,7,-0.5]");
  CHECK(direction("--start between") == "[1.5,7,-0.5]");
  CHECK(has(query(line, "--max-iterations 1").out, "\"b\":[1,9,0]"));
  CHECK(has(query(line, "--max-iterations 1 --start between").out, "\"b\":[2,5,0]"));
  CHECK(has(query(line, "--start inside").out, "\"iterations\":1,"));
  for (const char* given : {"--first-direction 0,1.5,0", "--first-direction=0,15e-1,-0"})
    CHECK(has(direction(given), "[0,1.5,"));
  CHECK(has(query(line, "--rules eager --scalar exact --first-direction 0.5,1,0").out, R"(["1/2","1","0"])"));
  CHECK(has(query(line, "--rules eager --scalar float --first-direction 0.1,1,0").out, "[0.1,1,0]"));
  CHECK(query(line, "--first-direction -1,-2,-3").exit_code == 0);
}

TEST_CASE("gjkstep query --certified proves its answers about points, balls and other shapes") {
  const std::string far = pair_of(dot, R"({"points":[[1.7976931348623157e308,0,0]]})");
  const std::string can = R"({"cylinder":{"center":[0,0,5],"axis":[0,0,1],"radius":1,"height":8}})";
  const Outcome outcome =
      query(far + "\n" + pair_of(ball, dot) + "\n" + pair_of(dot, dot) + "\n" + pair_of(ball, can), "--certified");
  CHECK(outcome.exit_code == 0);
  REQUIRE(lines(outcome.out).size() == 4);
  CHECK(has(lines(outcome.out)[0], R"("certificate":{"nearest":[[0,0]]}})"));
  CHECK(lines(outcome.out)[1] == R"({"status":"intersecting","proof":"distance"})");
  CHECK(has(lines(outcome.out)[2], R"("certificate":{"simplex":[[0,0]]}})"));
  CHECK(has(lines(outcome.out)[3], R"({"status":"undecided")"));
  CHECK(has(lines(outcome.out)[3], R"("gap":)"));
  CHECK(has(query(pair_of(dot, dot), "--certified --fractions").out, R"("weights":["1"],"point":["0","0","0"])"));
  for (const char* options : {"--scalar float", "--rules eager", "--rules as-printed --zero-test relative",
                              "--start between", "--start inside", "--first-direction 1,2,3", "--max-iterations 1"})
    CHECK(has(query(far, std::string("--certified ") + options).out, "\"separated\"") ==
          !has(options, "float"));  // which has no such number
}

TEST_CASE("A bad line of gjkstep query is exit code 3 and the others are answered") {
  const Outcome outcome = query("x\n" + pair_of(dot, dot) + "\n\n");
  CHECK(outcome.exit_code == 3);
  REQUIRE(lines(outcome.out).size() == 3);
  CHECK(has(lines(outcome.out)[1], "\"intersecting\""));
  CHECK(outcome.err == "gjkstep: 2 of 3 lines are not answered; the first is line 1, and its \"error\" says why\n");
}

TEST_CASE("Input that cannot be read is exit code 3") {
  const Outcome outcome = with_program("$program query </");
  CHECK(outcome.exit_code == 3);
  CHECK(has(outcome.err, "standard input cannot be read: Is a directory"));
  CHECK(with_program("$program query <&-").exit_code == 3);
}

TEST_CASE("Output that cannot be written is exit code 5, also where its reader leaves") {
  const std::string many = "yes " + quoted(pair_of(dot, dot)) + " | head -n 20000 | ";
  const Outcome full = with_program(many + "$program query >/dev/full");
  CHECK(full.exit_code == 5);
  CHECK(has(full.err, "cannot write to standard output: No space left on device; make room"));
  const Outcome left =
      with_program("{ " + many + "$program query; echo $? >$folder/code; } | head -n 1; cat $folder/code");
  REQUIRE(lines(left.out).size() == 2);
  CHECK(lines(left.out)[1] == "5");
  CHECK(has(left.err, "Broken pipe; who reads it has left before the end"));
  const Outcome closed = with_program("echo x | $program query >&-");
  CHECK(closed.exit_code == 5);
  CHECK(has(closed.err, "Bad file descriptor; check where the output goes"));
}

TEST_CASE("gjkstep query answers one pair while it waits for the next") {
  const Outcome outcome = with_program(
      "mkfifo $folder/in $folder/out\n"
      "$program query <$folder/in >$folder/out &\n"
      "exec 3>$folder/in 4<$folder/out\n"
      "for pair in 1 2 3; do\n"
      "  echo " +
      quoted(pair_of(dot, dot)) +
      " >&3\n"
      "  read -r answer <&4 && echo \"$pair $answer\"\n"
      "done\n"
      "exec 3>&-\n"
      "wait $!");
  CHECK(outcome.exit_code == 0);
  REQUIRE(lines(outcome.out).size() == 3);
  CHECK(lines(outcome.out)[2].starts_with("3 {\"status\":\"intersecting\""));
}

namespace {

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
    REQUIRE(query.write(pair_of(dot, dot) + "\n"));
    REQUIRE(has(query.read(), "intersecting"));
  }
  CHECK(query.close_and_wait() == 0);
}

TEST_CASE("gjkstep query waits where its pipes do not, for who reads its answers") {
  const NoBrokenPipes guard;
  NeverWaiting query;
  constexpr int pairs = 1000;  // which one pipe holds, but not their answers
  std::string text;
  for (int i = 0; i < pairs; ++i) text += pair_of(dot, dot) + "\n";
  REQUIRE(query.write(text + "the end\n"));
  query.until_it_sleeps();
  std::string said;
  for (std::string part; !said.ends_with(",\"line\":1001}\n") && !(part = query.read()).empty();) said += part;
  CHECK(lines(said).size() == pairs + 1);
  CHECK(query.close_and_wait() == 3);
}

TEST_CASE("What gjkstep query does not know is exit code 2 with the word that was probably meant") {
  check_failure("query --scalar duoble", 2, {"--scalar 'duoble' is not known", "did you mean 'double'"});
  check_failure("query --rules as-print", 2, {"did you mean 'as-printed'"});
  check_failure("query --start inbetween", 2, {"--start 'inbetween' is not known", "did you mean 'between'"});
  check_failure("query pairs.jsonl", 2, {"pairs.jsonl"});
}

TEST_CASE("Options of gjkstep query that do not go together are exit code 2") {
  check_failure("query --certified --scalar exact", 2,
                {"--certified is for --scalar float and double; exact does not"});
  check_failure("query --scalar long-double --certified", 2, {"--certified is for --scalar float and double, whose"});
  check_failure("query --fractions", 2, {"--fractions requires --certified"});
  for (const char* start : {"between", "inside"})
    check_failure(std::string("query --start ") + start + " --first-direction 1,0,0", 2,
                  {"--start excludes --first-direction"});
}

TEST_CASE("A first direction is three finite numbers in decimal, not all 0") {
  for (const char* const given : {"",         " ",      "1",          "1,0",     "1,0,0,",  "1,0,0,0",   ",,",
                                  "1,,0",     "0,0,0",  "-0,0.0,0e5", "nan,0,0", "1,inf,0", "1e400,0,0", "1,0,1e-400",
                                  "0x10,0,0", "+1,0,0", "1, 0, 0",    "1;0;0",   "[1,0,0]", "x,y,z"})
    check_failure("query --first-direction " + quoted(given), 2,
                  {"--first-direction: expected three finite numbers x,y,z, not all 0, found " + quoted(given)});
  for (const char* const given : {"1e39,0,0", "0,1e-60,0"}) {
    check_failure("query --scalar float --first-direction " + quoted(given), 2,
                  {"--first-direction " + quoted(given) + " is infinite or 0 in floats"});
    CHECK(query(pair_of(dot, dot), "--first-direction " + quoted(given)).exit_code == 0);
  }
}

TEST_CASE("gjkstep query --help tells what goes in and what comes out") {
  const std::string help = with_program("$program query --help").out;
  for (const char* part : {"--scalar",
                           "--rules",
                           "--max-iterations",
                           "\"points\"",
                           "\"sphere\"",
                           "\"cylinder\"",
                           "\"sum\"",
                           "\"evidence\"",
                           "\"error\"",
                           "16 MiB",
                           "1e±75",
                           "Exit codes",
                           "--start",
                           "--first-direction",
                           "--certified",
                           "\"certificate\"",
                           "\"nearest\"",
                           "\"weights\"",
                           "a·d < b·d",
                           "\"gap\"",
                           "\"surface\"",
                           "--start inside",
                           "index -1 is the mean"})
    CHECK(has(help, part));
}

TEST_CASE("What the README shows of gjkstep query is what the program prints") {
  const std::vector<std::string> readme = lines(bytes_of(kit::source("README.md")));
  const std::string named = "build/gjkstep query";
  int shown = 0;
  for (std::size_t i = 0; i + 1 < readme.size(); ++i) {
    if (!readme[i].starts_with("$ ") || !has(readme[i], named)) continue;
    std::string command = readme[i].substr(2);
    command.replace(command.find(named), named.size(), "$program query");
    INFO(command);
    CHECK(with_program(command).out == readme[i + 1] + "\n");
    ++shown;
  }
  CHECK(shown >= 2);
}
