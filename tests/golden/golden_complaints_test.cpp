// What is said about damaged scenes, traces and queries, and what is answered where nothing is wrong with them.

#include <limits>

#include "tests/core/support.hpp"
#include "tests/golden/checksum.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/trace/random_scene_files.hpp"
#include "tests/walkthroughs/trace/traces.hpp"
#include "walkthroughs/query/query.hpp"
#include "walkthroughs/text/scene_file.hpp"

using namespace golden;
using namespace walkthroughs;
using namespace walkthroughs::test;
using gjk::test::Dice;
using Json = nlohmann::ordered_json;

namespace {

constexpr int documents = 500, damages = 12;

// -- Damage -----------------------------------------------------------------------------------------------------------

/// Returns: all values in a document, itself first.
void collect(Json& value, std::vector<Json*>& found) {
  found.push_back(&value);
  if (value.is_structured())
    for (auto& each : value) collect(each, found);
}

Json other_value(Dice& dice) {
  static const std::array<Json, 12> values{nullptr,          true, -1,    0,      1, 1e300, 0.1, "separated",
                                           "no \u202e word", "",   "ABC", Json{1}};
  return values[static_cast<std::size_t>(dice.between(0, 11))];
}

/// A little more, less, the other sign, or something else.
Json near(const Json& value, Dice& dice) {
  if (!value.is_number() || dice.between(0, 2) == 0) return other_value(dice);
  const double number = value.get<double>();
  switch (dice.between(0, 3)) {
    case 0: return -number;
    case 1: return std::nextafter(number, std::numeric_limits<double>::infinity());
    case 2: return number + 1;
    default: return value.is_number_integer() ? Json(value.get<int>() - 1) : Json(number * 1.001);
  }
}

void damage(Json& document, Dice& dice) {
  std::vector<Json*> all;
  collect(document, all);
  Json& one = *all[static_cast<std::size_t>(dice.between(0, static_cast<int>(all.size()) - 1))];
  Json& other = *all[static_cast<std::size_t>(dice.between(0, static_cast<int>(all.size()) - 1))];
  const bool is_filled = one.is_structured() && !one.empty();
  switch (dice.between(0, 4)) {
    case 0: one = Json(other); break;  // which may be a part of it
    case 1:
      if (one.is_object()) one["unknown"] = other_value(dice);
      if (is_filled && one.is_array()) one.push_back(Json(one.back()));
      break;
    case 2:
      if (is_filled) one.erase(one.begin());
      break;
    default: one = near(one, dice);
  }
}

void damage_text(std::string& text, Dice& dice) {
  if (text.empty()) return;
  const auto at = static_cast<std::size_t>(dice.between(0, static_cast<int>(text.size()) - 1));
  switch (dice.between(0, 2)) {
    case 0: text.resize(at); break;
    case 1: text[at] = "\"{}[],:-0e. \n\xFF"[dice.between(0, 13)]; break;
    default: text.erase(at, 1);
  }
}

void damage_lines(std::vector<Json>& lines, Dice& dice) {
  const auto at = static_cast<std::ptrdiff_t>(dice.between(0, static_cast<int>(lines.size()) - 1));
  const auto other = static_cast<std::ptrdiff_t>(dice.between(0, static_cast<int>(lines.size()) - 1));
  const Json copy = lines[static_cast<std::size_t>(other)];
  switch (dice.between(0, 9)) {
    case 0: lines.erase(lines.begin() + at); break;
    case 1: lines.insert(lines.begin() + at, copy); break;
    case 2: std::iter_swap(lines.begin() + at, lines.begin() + other); break;
    default: damage(lines[static_cast<std::size_t>(at)], dice);
  }
}

// -- What is said -----------------------------------------------------------------------------------------------------

std::string complaint_about_scene(const std::string& text) {
  try {
    return parse_scene(text, "scene.json").walkthrough.title;
  } catch (const SceneError& error) {
    return error.what();
  }
}

void scenes(Checksum& sum, const Json& scene, Dice& dice) {
  for (int i = 0; i < damages; ++i) {
    Json damaged = scene;
    damage(damaged, dice);
    std::string text = damaged.dump(i % 2 == 0 ? -1 : 2, ' ', false, Json::error_handler_t::replace);
    if (i % 4 == 3) damage_text(text, dice);
    sum.add(complaint_about_scene(text) + "\n");
  }
}

void traces(Checksum& sum, const Json& scene, Dice& dice) {
  const std::vector<Json> sound = json_lines(trace_text(parse_scene(scene.dump(), "scene.json").walkthrough));
  for (int i = 0; i < damages; ++i) {
    std::vector<Json> lines = sound;
    damage_lines(lines, dice);
    if (lines.empty()) continue;
    std::string text = text_of(lines);
    if (i % 6 == 5) damage_text(text, dice);
    sum.add(complaint_about_trace(text) + "\n");
  }
}

QueryOptions query_options(Dice& dice) {
  QueryOptions options;
  if (const int scalar = dice.between(0, 3); scalar > 1)  // a long double is another number on other machines
    options.scalar = scalar == 2 ? QueryScalar::binary32 : QueryScalar::exact;
  options.rules = static_cast<RuleSet>(dice.between(0, 3));
  options.zero_test = static_cast<ZeroTest>(dice.between(0, 1));
  options.iteration_limit = dice.between(1, 20);
  if (dice.between(0, 2) == 0) options.start = static_cast<QueryStart>(dice.between(0, 1));
  if (dice.between(0, 3) == 0) options.first_direction = Point(1, dice.between(-2, 2), 1e-9);
  if (options.scalar != QueryScalar::exact) options.evidence = static_cast<QueryEvidence>(dice.between(0, 2));
  return options;
}

void queries(Checksum& sum, const Json& scene, Dice& dice) {
  const Json sound{{"a", scene["a"]}, {"b", scene["b"]}, {"dimension", scene.value("dimension", 3)}};
  for (int i = 0; i < damages; ++i) {
    Json query = sound;
    if (i % 3 != 0) damage(query, dice);
    std::string text = query.dump();
    if (i % 4 == 3) damage_text(text, dice);
    std::string answer;
    answer_line(text, static_cast<std::size_t>(i) + 1, query_options(dice), answer);
    sum.add(answer);
  }
}

std::string line_of(const std::string& name, void (*part)(Checksum&, const Json&, Dice&)) {
  RandomSceneFiles files(19);
  Dice dice(47);
  Checksum sum;
  for (int i = 0; i < documents; ++i) part(sum, Json::parse(files.next_without_sines().text), dice);
  return sum.text() + " " + name;
}

}  // namespace

TEST_CASE("complaints about damaged input, and answers to what is sound, are as accepted") {
  const std::vector<std::string> now{line_of("scenes", scenes), line_of("traces", traces), line_of("queries", queries)};
  check_lines("complaints.txt", now, "complaints",
              [&](std::size_t i, const std::string&) { return now[i].substr(9) + " are told otherwise"; });
}
