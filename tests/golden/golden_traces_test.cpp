// Every search is what was accepted, event by event: traces, as gjkstep trace prints them.

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tests/golden/store.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"
#include "tests/kit/json.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace golden_traces_test {

using namespace golden;
using kit::Json;
using walkthroughs::model::Walkthrough;

namespace {

/// Numbers agree when they differ by at most this share of the larger one; the numbers of a vector, when they differ by at most
/// this share of its largest coordinate. A zero agrees with a zero only, because signs decide. Everything is computed by
/// + - × ÷ and sqrt, so runs on one machine agree in every bit; the bound leaves room for another sin and cos (a pose given by
/// an angle), carried through products of four lengths.
constexpr double relative_bound = 1e-11;

double size_of(const Json& numbers) {
  double size = 0;
  for (const Json& each : numbers)
    if (each.is_number()) size = std::max(size, std::abs(each.get<double>()));
  return size;
}

bool agree(const Json& expected, const Json& actual, double scale = 0) {
  if (expected.is_number() && actual.is_number()) {
    const double x = expected, y = actual;
    return (x == 0) == (y == 0) && std::abs(x - y) <= relative_bound * std::max({scale, std::abs(x), std::abs(y)});
  }
  if (expected.type() != actual.type() || expected.size() != actual.size()) return false;
  if (!expected.is_structured()) return expected == actual;
  if (expected.is_array()) {
    const double own_scale = std::max(size_of(expected), size_of(actual));
    return std::ranges::equal(expected, actual,
                              [&](const Json& one, const Json& other) { return agree(one, other, own_scale); });
  }
  for (const auto& [key, value] : expected.items())
    if (!actual.contains(key) || !agree(value, actual[key])) return false;
  return true;
}

/// Returns: where two traces part, and what came just before; empty where they do not.
std::string difference(const std::string& expected, const std::string& actual) {
  const std::vector<std::string> left = kit::lines(expected), right = kit::lines(actual);
  const auto line = [](const std::vector<std::string>& lines, std::size_t i) {
    return i < lines.size() ? lines[i] : "(no line)";
  };
  for (std::size_t i = 0; i < std::max(left.size(), right.size()); ++i) {
    if (i < left.size() && i < right.size() && agree(Json::parse(left[i]), Json::parse(right[i]))) continue;
    return "the traces part at line " + std::to_string(i + 1) + "\n  both:     " + (i > 0 ? left[i - 1] : "") +
           "\n  expected: " + line(left, i) + "\n  actual:   " + line(right, i);
  }
  return "";
}

void check(const Walkthrough& w) {
  std::ostringstream now;
  walkthroughs::trace::write_traces(now, w);
  const std::string name = "traces/" + w.name + ".jsonl", words = difference(accepted_text(name), now.str());
  if (words.empty()) {
    SUCCEED(w.name);
    return;
  }
  if (accepting()) return accept(name, now.str(), words);
  FAIL_CHECK(w.name << ": " << words << "\nThe trace of now: " << leave_candidate(name, now.str()).string()
                    << "\nTo accept it: " << command_to_accept("traces"));
}

}  // namespace

TEST_CASE("traces of all walkthroughs are the accepted ones") {
  for (const Walkthrough& w : walkthroughs::catalogue::whole_catalogue())
    if (w.layout != walkthroughs::model::Layout::diagrams) check(w);
}

TEST_CASE("traces that are accepted belong to walkthroughs that there are") {
  for (const std::string& file : kit::listing(folder() / "traces")) {
    INFO(file);
    CHECK(walkthroughs::catalogue::find_walkthrough(file.substr(0, file.find('.'))) != nullptr);
  }
}

}  // namespace golden_traces_test
