#include "tests/golden/trace_difference.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace golden {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t events_before = 3;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

// -- Words ------------------------------------------------------------------------------------------------------------

/// Returns: numbers, words and lists without JSON's quotation marks.
std::string plain(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string list;
  for (const Json& each : value) list += (list.empty() ? "" : ", ") + plain(each);
  return "(" + list + ")";
}

/// "scene left, iteration 2, region tested: feature AB, region R3, value 0.78, relation > 0, verdict chosen".
std::string words_of(const std::string& line) {
  const Json event = Json::parse(line);
  if (!event.contains("event")) return "the first line, which describes the scenes";
  std::string name = event["event"];
  std::ranges::replace(name, '-', ' ');
  std::string words = "scene " + plain(event["scene"]) + ", iteration " + plain(event["iteration"]) + ", " + name;
  std::string sign = ": ";
  for (const auto& [key, value] : event.items()) {
    if (key == "event" || key == "scene" || key == "iteration") continue;
    words += sign + key + " " + plain(value);
    sign = ", ";
  }
  return words;
}

// -- Agreement --------------------------------------------------------------------------------------------------------

bool agree(double expected, double actual, double scale) {
  if (expected == 0 || actual == 0) return expected == actual;
  return std::abs(expected - actual) <= relative_bound * scale;
}

double size_of(const Json& numbers) {
  double size = 0;
  for (const Json& each : numbers)
    if (each.is_number()) size = std::max(size, std::abs(each.get<double>()));
  return size;
}

/// Returns: where the two differ first, as a path of keys; nothing where they agree.
std::optional<std::string> first_difference(const Json& expected, const Json& actual, double scale,
                                            const std::string& path) {
  const auto below = [&](const std::string& key) { return path.empty() ? key : path + "/" + key; };
  if (expected.is_number_float() || actual.is_number_float()) {
    if (!expected.is_number() || !actual.is_number()) return path;
    const double x = expected, y = actual;
    return agree(x, y, std::max({scale, std::abs(x), std::abs(y)})) ? std::nullopt : std::optional(path);
  }
  if (expected.type() != actual.type() && !(expected.is_number() && actual.is_number())) return path;
  if (!expected.is_structured()) return expected == actual ? std::nullopt : std::optional(path);
  if (expected.is_array()) {
    if (expected.size() != actual.size()) return path;
    const double own_scale = std::max(size_of(expected), size_of(actual));
    for (std::size_t i = 0; i < expected.size(); ++i)
      if (auto found = first_difference(expected[i], actual[i], own_scale, below(std::to_string(i)))) return found;
    return std::nullopt;
  }
  for (const auto& [key, value] : expected.items()) {
    if (!actual.contains(key)) return below(key);
    if (auto found = first_difference(value, actual[key], 0, below(key))) return found;
  }
  for (const auto& [key, value] : actual.items())
    if (!expected.contains(key)) return below(key);
  return std::nullopt;
}

}  // namespace

std::optional<TraceDifference> difference_of_traces(const std::string& expected, const std::string& actual) {
  const std::vector<std::string> left = lines_of(expected), right = lines_of(actual);
  const auto words = [](const std::vector<std::string>& lines, std::size_t i) {
    return i < lines.size() ? words_of(lines[i]) : "(no further event)";
  };
  for (std::size_t i = 0; i < std::max(left.size(), right.size()); ++i) {
    std::optional<std::string> key;
    if (i >= left.size() || i >= right.size())
      key = "";
    else if (left[i] != right[i])
      key = first_difference(Json::parse(left[i]), Json::parse(right[i]), 0, "");
    if (!key) continue;
    TraceDifference found{i + 1, *key, words(left, i), words(right, i), {}};
    for (std::size_t j = i < events_before ? 0 : i - events_before; j < i; ++j) found.before.push_back(words(left, j));
    return found;
  }
  return std::nullopt;
}

std::string in_words(const TraceDifference& difference) {
  std::string words = "the traces part at line " + std::to_string(difference.line);
  if (!difference.key.empty()) words += " (" + difference.key + ")";
  for (const std::string& event : difference.before) words += "\n  both:     " + event;
  return words + "\n  expected: " + difference.expected + "\n  actual:   " + difference.actual;
}

}  // namespace golden
