// Traces of proofs and of second searches: what was written is taken, and nothing that was changed by hand.
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/trace/traces.hpp"

using namespace walkthroughs;
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

/// Where nothing follows from a number.
bool is_free(const OrderedJson& line, const std::string& key) {
  const bool is_zero = line.contains("value") && line["value"] == 0;
  const bool is_near = key == "value" && line.contains("exact");  // and may lie anywhere within the error
  return line["event"] == "sign-taken" && (key == "error" || is_near || (key == "power" && is_zero));
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
        if (!other || is_free(lines[i], key)) continue;
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

TEST_CASE("A certificate that holds, but is not of what the search has kept, is refused", "[trace]") {
  std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("certified/coplanar-askew")));
  OrderedJson& certificate = lines.back()["certificate"];
  const OrderedJson other = OrderedJson::parse(R"({"simplex":[[0,0],[1,1],[2,1]]})");  // which holds the origin, too
  REQUIRE(certificate["simplex"].size() == 3);
  REQUIRE(certificate["simplex"] != other["simplex"]);
  certificate["simplex"] = other["simplex"];
  CHECK_THAT(complaint_about_trace(text_of(lines)),
             kit::contains("'certificate' is not of the simplex that was found"));
}

TEST_CASE("What contradicts a certified trace is named", "[trace]") {
  const std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("certified/one-step-apart")));
  const auto complaint = [&](const std::string& event, const std::string& key, const OrderedJson& value,
                             const std::string& only_with = "scene") {
    std::vector<OrderedJson> altered = lines;
    for (OrderedJson& line : altered)
      if (line.value("event", "") == event && line.contains(only_with)) {
        line[key] = value;
        return complaint_about_trace(text_of(altered));
      }
    return std::string("there is no such line");
  };
  const auto check = [](const std::string& complaint, const std::string& words) {
    INFO(complaint);
    CHECK(complaint.find(words) != std::string::npos);
  };
  check(complaint("proof-tried", "holds", true), "'holds' is true, but the numbers say otherwise");
  check(complaint("proof-tried", "bound", 1), "'bound' is 1; expected");
  check(complaint("sign-taken", "sign", 1), "'sign' is 1, but that of 'AO.x' is -1");
  check(complaint("sign-taken", "value", -1.25), "is farther from 'value' -1.25 than 'error' says");
  check(complaint("sign-taken", "error", 9), "'exact' is missing: 0 lies within 'error' of 'value'");
  check(complaint("sign-taken", "exact", "1/3", "exact"), "'exact' is '1/3'; expected '0'");
  check(complaint("sign-taken", "expression", "AC·AO"), "'expression' is 'AC·AO'; expected 'AO.x'");
  check(complaint("feature-kept", "kept", "BA"), "'kept' is 'BA'; expected 'A'");
  check(complaint("feature-kept", "contains_origin", true), "'contains_origin' is not true of what is kept");
  check(complaint("certified", "status", "intersecting"), "'status' is 'intersecting'; expected 'separated'");
  check(complaint("certified", "certificate", {{"nearest", {{2, 1}}}}), "'certificate' does not hold");
  check(complaint("certified", "certificate", {{"nearest", {{2, 99}}}}), "'certificate' does not hold");
  check(complaint("certified", "certificate", {{"simplex", {{2, 1}}}}),
        "'certificate' is of another answer than 'status'");
  check(complaint("certified", "second_iterations", 7), "'second_iterations' are to be 5 and 2");
}

TEST_CASE("A vertex that is not the one found is named, even where it is one of the difference", "[trace]") {
  const std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("certified/one-step-apart")));
  const auto with = [&](const std::string& event, const std::string& key) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].value("event", "") == event && lines[i].contains(key)) found.push_back(i);
    return found;
  };
  const OrderedJson left_behind = lines[with("vertex-added", "simplex").front()]["simplex"][0];
  std::vector<OrderedJson> offered = lines, added = lines;
  offered[with("sign-taken", "vertex").front()]["vertex"] = left_behind;
  CHECK_THAT(complaint_about_trace(text_of(offered)), kit::contains("'vertex' is not one of the first search"));
  added[with("vertex-added", "simplex").back()]["simplex"][1] = left_behind;
  CHECK_THAT(complaint_about_trace(text_of(added)),
             kit::contains("the newest vertex is not the one that reaches across the origin"));
}

TEST_CASE("A formula that is another is named, and the one that follows", "[trace]") {
  std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("certified/cycle-separated")));
  const auto sign = std::ranges::find_if(lines, [](const OrderedJson& line) {
    return line.value("event", "") == "sign-taken" && line.contains("formula");
  });
  REQUIRE(sign != lines.end());
  const std::string follows = (*sign)["formula"];
  (*sign)["formula"] = "AB·AO";
  CHECK_THAT(complaint_about_trace(text_of(lines)), kit::contains("'formula' is 'AB·AO'; expected '" + follows + "'"));
}

TEST_CASE("Only scenes that say so have proofs", "[trace]") {
  std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("certified/tetrahedron")));
  lines[0]["scenes"][0].erase("certified");
  CHECK(complaint_about_trace(text_of(lines)).find("nothing may follow") != std::string::npos);
  std::vector<OrderedJson> plain = json_lines(trace_text(walkthrough("figure-4-right")));
  plain[0]["scenes"][0]["certified"] = true;
  CHECK(complaint_about_trace(text_of(plain)).find("'proof-tried'") != std::string::npos);
}
