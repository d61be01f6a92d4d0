#include "walkthroughs/steps/told_run.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "walkthroughs/pairs/named_pair.hpp"
#include "walkthroughs/text/document.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace walkthroughs::steps {
namespace {

using Kind = Document::Kind;

/// As many languages write numbers that are none, and JSON has no word for them but null.
std::string with_nulls(std::string_view line) {
  std::string text;
  bool is_key = false;
  for (std::size_t at = 0; at < line.size();) {
    if (line[at] == '"') is_key = !is_key;
    std::size_t end = at;
    while (end < line.size() && std::isalpha(static_cast<unsigned char>(line[end]))) ++end;
    std::string word(line.substr(at, end - at));
    for (char& letter : word) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    if (!is_key && (word == "nan" || word == "inf" || word == "infinity")) {
      if (text.ends_with('-')) text.pop_back();
      word = "null";
    } else {
      end = std::max(end, at + 1);
      word = line.substr(at, end - at);
    }
    text += word;
    at = end;
  }
  return text;
}

Vec vec_in(const Value& value) {
  const std::vector<Value> numbers = value.children();
  if (!value.is(Kind::list) || numbers.size() != 3) value.fail("must be [x, y, z]");
  Vec v = Vec::Zero();
  for (std::size_t i = 0; i < numbers.size() && i < 3; ++i) {
    const bool is_none = numbers[i].is(Kind::null);
    if (!is_none && !numbers[i].is(Kind::number)) numbers[i].fail("must be a number");
    v[static_cast<Eigen::Index>(i)] = is_none ? std::numeric_limits<double>::quiet_NaN() : numbers[i].number();
  }
  return v;
}

Vec point_in(const Value& value) {
  const Vec p = vec_in(value);
  if (p.cwiseAbs().maxCoeff() > scene_limits::magnitude) value.fail("is too far away");
  return p;
}

/// Returns: the direction in numbers whose products with points no double is too small for: only their ratios count.
Vec direction_in(const Value& value) {
  const Vec d = vec_in(value);
  const double most = d.cwiseAbs().maxCoeff();
  return most > scene_limits::magnitude ? Vec(d * std::ldexp(1.0, -std::ilogb(most))) : d;
}

}  // namespace

bool ToldStep::is_of_numbers() const {
  return direction.allFinite() && std::ranges::all_of(simplex, [](const Vec& v) { return v.allFinite(); });
}

bool is_meant_as_step(std::string_view line) {
  const auto has = [line](std::string_view key) { return line.find(key) != std::string_view::npos; };
  constexpr std::size_t longest = 4096;
  return line.size() <= longest && has("\"direction\"") && has("\"simplex\"") && !has("\"status\"");
}

ToldStep read_step(std::string_view line) {
  const Document document = Document::of_line(with_nulls(line));
  require_good(document);
  const auto direction = document.root().member("direction"), simplex = document.root().member("simplex");
  if (!direction || !simplex) throw std::invalid_argument("a step has a \"direction\" and a \"simplex\"");
  ToldStep step{direction_in(*direction), {}};
  const std::vector<Value> points = simplex->children();
  if (!simplex->is(Kind::list) || points.empty() || points.size() > 4)
    simplex->fail("must be a list of one to four points [x, y, z]");
  for (const Value& point : points) step.simplex.push_back(point_in(point));
  require_good(document);
  return step;
}

}  // namespace walkthroughs::steps
