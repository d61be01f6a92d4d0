#include "walkthroughs/story/number_line.hpp"

#include <algorithm>
#include <cmath>

#include "walkthroughs/story/exact.hpp"

namespace walkthroughs::story {
namespace {

NumberLine line_of(const gjk::FilterTried<double>& proof, const Names& names) {
  NumberLine line{.numbers = {},
                  .low = -proof.bound,
                  .high = proof.bound,
                  .meaning = "±" + short_number(proof.bound) + ": so much may be rounding"};
  for (const gjk::FilterValue& each : proof.numbers)
    line.numbers.push_back({name_of(each, names), short_number(each.value), each.value});
  return line;
}

NumberLine line_of(const gjk::SignTaken<double>& sign, const Names& names) {
  NumberLine line{.numbers = {{name_of(sign, names), short_number(sign.value), sign.value}},
                  .low = sign.value - sign.error,
                  .high = sign.value + sign.error,
                  .meaning = "±" + short_number(sign.error) + ": it lies somewhere here"};
  if (!sign.exact.empty())
    line.numbers.push_back({"exactly", short_fraction(sign.exact), nearest_double(sign.exact), true});
  return line;
}

bool is_drawable(const NumberLine& line) {
  const auto is_finite = [](const NumberLine::Number& each) { return std::isfinite(each.value); };
  return !line.numbers.empty() && std::ranges::all_of(line.numbers, is_finite) && std::isfinite(line.low) &&
         std::isfinite(line.high);
}

}  // namespace

std::string NumberLine::Number::equation() const { return name + (text.starts_with("≈") ? " " : " = ") + text; }

std::optional<NumberLine> number_line(const Moment& now, Focus focus, const Names& names) {
  std::optional<NumberLine> line;
  if (focus == Focus::proof) line = line_of(*now.proof, names);
  if (focus == Focus::sign && !now.signs.back().power) line = line_of(now.signs.back(), names);
  return line && is_drawable(*line) ? line : std::nullopt;
}

std::string name_of(const gjk::SignTaken<double>& sign, const Names& names) {
  if (sign.expression.form == gjk::Expression::Form::largest_reach) return "the largest P·d";
  const std::string w = sign.vertex ? names.of(sign.vertex->w) : "";
  if (sign.expression.form == gjk::Expression::Form::reach) return (w.empty() ? "P" : w) + "·d";
  const std::string name = names.translate(sign.expression);
  return sign.face.empty() ? name : name + " of " + names.sorted(sign.face);
}

std::string name_of(const gjk::FilterValue& number, const Names& names) {
  return number.expression.form == gjk::Expression::Form::gap ? "−P·d" : names.translate(number.expression);
}

std::string in_words(const NumberLine& line) {
  std::string text = "A number line shows ";
  for (std::size_t i = 0; i < line.numbers.size(); ++i) text += (i == 0 ? "" : ", ") + line.numbers[i].equation();
  return text + " and, to scale, " + line.meaning + ".";
}

}  // namespace walkthroughs::story
