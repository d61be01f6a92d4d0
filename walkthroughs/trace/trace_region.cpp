#include "walkthroughs/trace/trace_region.hpp"

#include "core/gjk.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/trace/trace_contradiction.hpp"
#include "walkthroughs/trace/trace_expression.hpp"
#include "walkthroughs/trace/trace_mistakes.hpp"

namespace walkthroughs {
namespace {

using gjk::Relation;
using gjk::Verdict;
using Simplex = gjk::Simplex<double>;

/// A number that is none stands in no relation but `not zero`, `not negative` and, after "zero" and "positive" did not hold
/// either, `negative`: so does the last `else` of Algorithm 4.
bool stands(double value, Relation relation) {
  switch (relation) {
    case Relation::positive: return value > 0;
    case Relation::negative: return !(value >= 0);
    case Relation::zero: return value == 0;
    case Relation::not_zero: return value != 0;
    case Relation::not_negative: return !(value < 0);
  }
  return false;
}

bool stands(const Point& value, Relation relation) {
  return gjk::is_zero(value) ? relation == Relation::zero : relation == Relation::not_zero;
}

/// Returns: the row that the event's feature and relation choose.
const RuleRow& row_of(const gjk::RegionTested<double>& event, const std::vector<RuleRow>& rows) {
  const RuleRow* row = nullptr;
  bool is_feature = false;
  for (const RuleRow& each : rows) {
    is_feature = event.feature == each.feature && event.face == each.face;
    if (!row || each.relation == event.relation) row = &each;
  }
  const std::string of_face = row->face.empty() ? "" : " of face " + in_quotes(row->face);
  require(is_feature,
          "'feature' and 'face' are not those that are looked at here: " + in_quotes(row->feature) + of_face);
  const bool has_value = !row->expression.empty();
  require(!has_value || row->relation == event.relation,
          "'relation' cannot be " + in_quotes(words_of::of(event.relation)) + " for " + in_quotes(row->expression));
  const auto require_word = [&](std::string_view found, std::string_view expected, const char* key) {
    require(found == expected, in_quotes(key) + " is " + in_quotes(found) + "; expected " + in_quotes(expected) +
                                   " for the feature " + in_quotes(row->feature) + " and its relation");
  };
  require_word(event.label, row->label, "region");
  require_word(event.expression, row->expression, "expression");
  require_word(event.formula, row->formula, "formula");
  return *row;
}

void check_value(const gjk::RegionTested<double>& event, const Simplex& simplex, const Scene& scene) {
  const bool is_scalar = event.expression.find("·") != std::string::npos;
  const bool has_right_kind = event.expression.empty() ? std::holds_alternative<std::monostate>(event.value)
                              : is_scalar              ? std::holds_alternative<double>(event.value)
                                                       : std::holds_alternative<Point>(event.value);
  require(has_right_kind, "'value' is not of the kind that 'expression' has");
  require(event.normal.has_value() == !event.formula.empty(), "'normal' and 'formula' belong together");
  if (event.normal) {
    const std::string formula =
        scene.mistake ? with_reversed_normals(event.formula, *scene.mistake, simplex.size()) : event.formula;
    const RoundedVector normal = evaluate(formula, simplex, scene.scalar);
    require(agrees(*event.normal, normal),
            "'normal' is " + written(*event.normal) + ", but " + event.formula + " is " + written(normal.value));
  }
  if (const double* value = std::get_if<double>(&event.value)) {
    const RoundedScalar expected = dot({*event.normal}, evaluate("AO", simplex, scene.scalar), scene.scalar);
    require(agrees(*value, expected),
            "'value' is " + number_text(*value) + ", but " + event.expression + " is " + number_text(expected.value));
  }
  if (const Point* value = std::get_if<Point>(&event.value)) {
    const RoundedVector expected = evaluate(event.expression, simplex, scene.scalar);
    require(agrees(*value, expected),
            "'value' is " + written(*value) + ", but " + event.expression + " is " + written(expected.value));
  }
}

/// Returns: whether its value may count as zero, though it may not be zero.
bool counts_as_zero(const gjk::RegionTested<double>& event, const Simplex& simplex, const Scene& scene) {
  if (scene.zero_test == ZeroTest::exact) return false;
  if (const Point* value = std::get_if<Point>(&event.value))
    return may_count_as_zero(*value, size_of(event.expression, simplex), scene.scalar);
  const double size = size_of(event.formula, simplex) * size_of("AO", simplex);
  return may_count_as_zero(std::get<double>(event.value), size, scene.scalar);
}

/// Whether a face is told not to see the origin that lies in it, where this mistake sees it.
bool overlooks_origin(const gjk::RegionTested<double>& event, double value, const Scene& scene) {
  return scene.mistake == Mistake::origin_in_face_seen_outside && event.verdict == Verdict::rejected &&
         event.simplex_size == 4 && event.face.empty() && value == 0;
}

/// Checks that the verdict follows from the value, where there is one.
void check_verdict(const gjk::RegionTested<double>& event, const Simplex& simplex, const Scene& scene) {
  const bool has_value = !std::holds_alternative<std::monostate>(event.value);
  if (!has_value || event.verdict == Verdict::skipped) return;
  const bool is_yes = event.verdict != Verdict::rejected;
  const double* value = std::get_if<double>(&event.value);
  const bool holds = value ? stands(*value, event.relation) || overlooks_origin(event, *value, scene)
                           : stands(std::get<Point>(event.value), event.relation);
  const bool is_as_zero = counts_as_zero(event, simplex, scene) && stands(0.0, event.relation) == is_yes;
  require(is_as_zero || holds == is_yes, "'verdict' is " + in_quotes(words_of::of(event.verdict)) +
                                             ", but 'value' is " + written(event.value) + " and " +
                                             (holds ? "stands" : "does not stand") + " in the relation " +
                                             in_quotes(words_of::of(event.relation)));
}

}  // namespace

RuleStep step_after(const gjk::RegionTested<double>& event, const Simplex& simplex, const std::vector<RuleRow>& rows,
                    const Scene& scene) {
  require(event.simplex_size == simplex.size(), "'simplex_size' is " + std::to_string(event.simplex_size) +
                                                    ", but the simplex has " + std::to_string(simplex.size()) +
                                                    " vertices");
  const RuleRow& row = row_of(event, rows);
  check_value(event, simplex, scene);
  check_verdict(event, simplex, scene);
  const std::optional<RuleStep>& step = event.verdict == Verdict::chosen     ? row.chosen
                                        : event.verdict == Verdict::rejected ? row.rejected
                                        : event.verdict == Verdict::possible ? row.possible
                                                                             : row.skipped;
  require(step.has_value(), "'verdict' is " + in_quotes(words_of::of(event.verdict)) +
                                ", which is not possible for the feature " + in_quotes(row.feature) + " here");
  return *step;
}

}  // namespace walkthroughs
