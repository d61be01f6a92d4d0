// Traces of proofs and of second searches: what was written is taken, and nothing that was changed by hand.
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/trace/traces.hpp"

namespace trace_certified_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

/// Returns: the value changed so that it says something else, or nothing where there is no such.
std::optional<OrderedJson> changed(const OrderedJson& value) {
  if (value.is_boolean()) return !value.get<bool>();
  if (value.is_number_integer()) return value.get<int>() == 0 ? 1 : -value.get<int>();
  if (value.is_number()) return value.get<double>() == 0 ? 1.0 : -8 * value.get<double>();
  if (value.is_string()) return value.get<std::string>() + "1";
  if (value.is_array() && !value.empty()) {
    OrderedJson list = value;
    if (const auto first = changed(list[0])) return list[0] = *first, list;
  }
  if (value.is_object()) {
    OrderedJson object = value;
    for (auto& [key, member] : object.items())
      if (const auto other = changed(member)) return member = *other, object;
  }
  return std::nullopt;
}

/// Returns: the first line behind the first search.
std::size_t first_of_proof(const std::vector<OrderedJson>& lines) {
  const auto first = std::ranges::find_if(lines, [](const OrderedJson& line) {
    return line.value("event", "") == "proof-tried" || line.value("event", "") == "sign-taken";
  });
  return static_cast<std::size_t>(first - lines.begin());
}

}  // namespace

TEST_CASE("No field of a certified trace can be changed", "[trace]") {
  int tried = 0;
  for (const char* const name : {"certified/one-step-apart", "certified/cycle-separated", "certified/tetrahedron",
                                 "certified/vanished-product", "certified/beyond-an-edge"}) {
    const std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough(name)));
    REQUIRE(complaint_about_trace(text_of(lines)) == "read");
    for (std::size_t i = first_of_proof(lines); i < lines.size(); ++i) {
      for (const auto& [key, value] : lines[i].items()) {
        const auto other = changed(value);
        if (!other) continue;
        std::vector<OrderedJson> altered = lines;
        altered[i][key] = *other;
        INFO(name << ", line " << i + 1 << ", " << key << ": " << lines[i].dump());
        CHECK(complaint_about_trace(text_of(altered)) != "read");
        ++tried;
      }
    }
  }
  CHECK(tried > 400);
}

TEST_CASE("No event of a second search can be left out or told twice", "[trace]") {
  const std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("certified/cycle-separated")));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::vector<OrderedJson> less = lines, more = lines;
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
    more.insert(more.begin() + static_cast<std::ptrdiff_t>(i), lines[i]);
    INFO("line " << i + 1 << ": " << lines[i].dump());
    CHECK(complaint_about_trace(text_of(less)) != "read");
    CHECK(complaint_about_trace(text_of(more)) != "read");
  }
}

TEST_CASE("What contradicts a certified trace is named, and what is right", "[trace]") {
  std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("certified/one-step-apart")));
  lines.back()["certificate"] = {{"nearest", {{2, 1}}}};
  CHECK_THAT(complaint_about_trace(text_of(lines)),
             kit::contains("'certificate.nearest' is [[2,1]], but the search says"));
}

TEST_CASE("Only scenes that say so have proofs", "[trace]") {
  std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("certified/tetrahedron")));
  lines[0]["scenes"][0].erase("certified");
  CHECK(complaint_about_trace(text_of(lines)).find("nothing may follow") != std::string::npos);
  std::vector<OrderedJson> plain = json_lines(trace_text(walkthrough("figure-4-right")));
  plain[0]["scenes"][0]["certified"] = true;
  CHECK(complaint_about_trace(text_of(plain)).find("'proof-tried'") != std::string::npos);
}

}  // namespace trace_certified_test
