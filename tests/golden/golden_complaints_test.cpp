// What is said about damaged scenes, traces and queries: each sentence, how often it is said, and of what first.

#include <limits>
#include <regex>

#include "tests/golden/sentences.hpp"
#include "tests/golden/store.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/walkthroughs/trace/random_scene_files.hpp"
#include "tests/walkthroughs/trace/traces.hpp"
#include "walkthroughs/query/query.hpp"
#include "walkthroughs/text/scene_file.hpp"

namespace golden_complaints_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using golden::Sentences;
using kit::Dice, kit::Json;

namespace {

constexpr int documents = 250, damages = 12;

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

/// Returns: what was done.
std::string damage_text(std::string& text, Dice& dice) {
  if (text.empty()) return "";
  const auto at = static_cast<std::size_t>(dice.between(0, static_cast<int>(text.size()) - 1));
  const std::string place = " after " + std::to_string(at) + " bytes";
  switch (dice.between(0, 2)) {
    case 0: text.resize(at); return "cut off" + place;
    case 1:
      text[at] = "\"{}[],:-0e. \n\xFF"[dice.between(0, 13)];
      return Json(std::string(1, text[at])).dump(-1, ' ', true, Json::error_handler_t::replace) + place;
    default: text.erase(at, 1); return "one byte missing" + place;
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

/// Returns: what was changed, as a JSON Patch.
std::string change(const Json& sound, const Json& damaged) {
  constexpr std::size_t most = 100;
  const std::string patch = Json::diff(sound, damaged).dump(-1, ' ', true, Json::error_handler_t::replace);
  return patch.size() <= most ? patch : patch.substr(0, most) + " …";
}

/// Counts a complaint, whatever it is about and whatever was found there.
void add(Sentences& said, const std::string& complaint, const std::string& change) {
  static const std::regex place("^[^ ]*:[0-9]+: (?:[^ ]*: )?"), found("found .*");
  said.add(complaint, change, std::regex_replace(std::regex_replace(complaint, place, ""), found, "found"));
}

std::string complaint_about_scene(const std::string& text) {
  try {
    parse_scene(text, "scene.json");
    return "read";
  } catch (const InputError& error) {
    return error.what();
  }
}

void scenes(Sentences& said, const Json& scene, Dice& dice) {
  for (int i = 0; i < damages; ++i) {
    Json damaged = scene;
    damage(damaged, dice);
    std::string text = damaged.dump(i % 2 == 0 ? -1 : 2, ' ', false, Json::error_handler_t::replace);
    const std::string changed = i % 4 == 3 ? damage_text(text, dice) : change(scene, damaged);
    add(said, complaint_about_scene(text), changed);
  }
}

void traces(Sentences& said, const Json& scene, Dice& dice) {
  const std::vector<Json> sound = json_lines(trace_text(parse_scene(scene.dump(), "scene.json").walkthrough));
  for (int i = 0; i < damages; ++i) {
    std::vector<Json> lines = sound;
    damage_lines(lines, dice);
    if (lines.empty()) continue;
    std::string text = text_of(lines);
    const std::string changed = i % 6 == 5 ? damage_text(text, dice) : change(sound, lines);
    add(said, complaint_about_trace(text), changed);
  }
}

void queries(Sentences& said, const Json& scene, Dice& dice) {
  const Json sound{{"a", scene["a"]}, {"b", scene["b"]}, {"dimension", scene.value("dimension", 3)}};
  for (int i = 0; i < damages; ++i) {
    Json query = sound;
    damage(query, dice);
    std::string text = query.dump(), answer;
    const std::string changed = i % 4 == 3 ? damage_text(text, dice) : change(sound, query);
    const QueryOptions options{.scalar =
                                   static_cast<QueryScalar>(std::array{0, 1, 3}[static_cast<std::size_t>(i % 3)])};
    if (!answer_line(text, 1, options, answer))
      add(said, "line:1: " + Json::parse(answer)["error"].get<std::string>(), changed);
  }
}

std::string said_of(void (*part)(Sentences&, const Json&, Dice&)) {
  RandomSceneFiles files(19);
  Dice dice(47);
  Sentences said;
  for (int i = 0; i < documents; ++i) part(said, Json::parse(files.next_without_sines().text), dice);
  return said.text("\n        ");
}

}  // namespace

TEST_CASE("complaints about damaged input are as accepted") {
  golden::check_text(
      "complaints.txt",
      "== Scenes\n" + said_of(scenes) + "\n== Traces\n" + said_of(traces) + "\n== Queries\n" + said_of(queries),
      "complaints");
}

}  // namespace golden_complaints_test
