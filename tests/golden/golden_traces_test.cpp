// Every search is what was accepted, event by event.

#include <sstream>

#include "tests/golden/store.hpp"
#include "tests/golden/trace_difference.hpp"
#include "tests/kit/catch.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/trace/trace_json.hpp"

using namespace golden;
using walkthroughs::Walkthrough;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = 20 * 1024;  // of one file; a longer trace is continued in a second one, and so on

std::string now(const Walkthrough& w) {
  std::ostringstream out;
  walkthroughs::write_traces(out, w);
  return out.str();
}

std::string name_of_part(const Walkthrough& w, int part) {
  return "traces/" + w.name + (part == 1 ? "" : "." + std::to_string(part)) + ".jsonl";
}

/// Returns: `trace` in parts of whole lines.
std::vector<std::string> parts(const std::string& trace) {
  std::vector<std::string> all = {""};
  std::istringstream lines(trace);
  for (std::string line; std::getline(lines, line);) {
    if (!all.back().empty() && all.back().size() + line.size() + 1 > most_bytes) all.emplace_back();
    all.back() += line + "\n";
  }
  return all;
}

/// Returns: the accepted trace; empty where there is none.
std::string accepted(const Walkthrough& w) {
  std::string trace;
  for (int part = 1; fs::exists(folder() / name_of_part(w, part)); ++part)
    trace += accepted_text(name_of_part(w, part));
  return trace;
}

void accept_trace(const Walkthrough& w, const std::string& trace, const std::string& why) {
  const std::vector<std::string> all = parts(trace);
  for (std::size_t i = 0; i < all.size(); ++i) accept(name_of_part(w, static_cast<int>(i) + 1), all[i], why);
  for (int stale = static_cast<int>(all.size()) + 1; fs::remove(folder() / name_of_part(w, stale)); ++stale) {
  }
}

void check(const Walkthrough& w) {
  const std::string trace = now(w), golden = accepted(w);
  const auto difference = difference_of_traces(golden, trace);
  if (!difference) {
    SUCCEED(w.name);
    return;
  }
  const std::string words = golden.empty() ? "there is no accepted trace" : in_words(*difference);
  if (accepting()) return accept_trace(w, trace, words);
  const fs::path candidate = leave_candidate("traces/" + w.name + ".jsonl", trace);
  FAIL_CHECK(w.name << ": " << words << "\nThe trace of now: " << candidate.string()
                    << "\nTo accept it: " << command_to_accept("golden-tests: traces"));
}

}  // namespace

TEST_CASE("traces of all walkthroughs are the accepted ones") {
  for (const Walkthrough& w : walkthroughs::catalogue())
    if (w.layout != walkthroughs::Layout::diagrams) check(w);
}

TEST_CASE("traces that are accepted belong to walkthroughs that there are and are small") {
  for (const auto& entry : fs::recursive_directory_iterator(folder() / "traces")) {
    if (!entry.is_regular_file()) continue;
    INFO(entry.path());
    CHECK(entry.file_size() <= most_bytes);
    std::string name = fs::relative(entry.path(), folder() / "traces").replace_extension("").string();
    if (const auto dot = name.rfind('.'); dot != std::string::npos) name.resize(dot);  // of a part
    CHECK(walkthroughs::find_walkthrough(name) != nullptr);
  }
}

// -- The comparison itself --------------------------------------------------------------------------------------------

namespace {

std::string changed(std::string trace, const std::string& from, const std::string& to) {
  const std::size_t at = trace.find(from);
  REQUIRE(at != std::string::npos);
  return trace.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("traces differ where a word, an order, a count or a number does, and the first event that does is told") {
  const std::string trace = now(*walkthroughs::find_walkthrough("figure-4-left"));
  REQUIRE_FALSE(difference_of_traces(trace, trace));
  const auto verdict =
      difference_of_traces(trace, changed(trace, "\"verdict\":\"rejected\"", "\"verdict\":\"chosen\""));
  REQUIRE(verdict);
  CHECK(verdict->key == "verdict");
  CHECK(verdict->expected.find("verdict rejected") != std::string::npos);
  CHECK(verdict->actual.find("verdict chosen") != std::string::npos);
  CHECK(verdict->before.size() == 3);
  CHECK(in_words(*verdict).find("region tested") != std::string::npos);

  const std::size_t last = trace.rfind("\n{") + 1;
  const auto shorter = difference_of_traces(trace, trace.substr(0, last));
  REQUIRE(shorter);
  CHECK(shorter->actual == "(no further event)");
  CHECK(difference_of_traces(trace.substr(0, last), trace)->expected == "(no further event)");

  const auto number = difference_of_traces(trace, changed(trace, "[3.75,3.25,0.0]", "[3.75,3.2500001,0.0]"));
  REQUIRE(number);
  CHECK_FALSE(difference_of_traces(trace, changed(trace, "[3.75,3.25,0.0]", "[3.75,3.25000000000001,0.0]")));
  CHECK(difference_of_traces(trace, changed(trace, "[3.75,3.25,0.0]", "[3.75,3.25,1e-300]")));
}
