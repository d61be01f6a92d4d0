#include "walkthroughs/story/truth_told.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "core/certified/check_grown.hpp"
#include "walkthroughs/story/exact.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

/// What is searched otherwise than the truth is found.
std::string searched(const Scene& scene) {
  if (scene.rules == RuleSet::as_printed) return "as printed";
  return scene.scalar == Scalar::binary32 ? "in floats" : "in doubles";
}

ExactVector vector_of(const gjk::detail::Fractions& v) { return {v[0], v[1], v[2]}; }

/// Two objects that are decided exactly, and the point of the difference of their cores that is nearest to the origin.
struct Decided {
  gjk::Grown a, b;
  gjk::IndexPairs nearest;
  gjk::NearestPoint point;
};

/// Returns: nothing of others.
std::optional<Decided> decided(const ExactAnswer& answer, const Scene& scene) {
  if (answer.nearest.size() == 0) return std::nullopt;
  auto a = exact_shape(a_as_read(scene).form, a_as_read(scene).pose),
       b = exact_shape(b_as_read(scene).form, b_as_read(scene).pose);
  if (!a || !b) return std::nullopt;
  auto point = gjk::nearest_point_of(answer.nearest, *a, *b);
  if (!point) return std::nullopt;
  return Decided{std::move(*a), std::move(*b), answer.nearest, std::move(*point)};
}

/// Returns: how far apart the cores of two objects are that touch.
gjk::Fraction reach_of(const Decided& decided) {
  return gjk::detail::sum_of_radii(decided.a) + gjk::detail::sum_of_radii(decided.b);
}

/// Returns: the point of a that the nearest point of the difference comes from.
ExactVector point_of_a(const Decided& decided) {
  ExactVector point = ExactVector::Zero();
  for (int k = 0; k < decided.nearest.size(); ++k)
    point += vector_of(gjk::detail::core_point(decided.a, decided.nearest[k].a).value()) *
             decided.point.weights[static_cast<std::size_t>(k)];
  return point;
}

/// Of sets of points where they touch or how far they are apart, of round objects how far without their radii.
std::string why_told(const Decided& decided, gjk::Status answer, Dimension dimension) {
  const ExactVector v = vector_of(decided.point.v);
  const gjk::Fraction reach = reach_of(decided);
  if (reach > 0) {
    const gjk::Fraction excess = (v.dot(v) - reach * reach) / (2 * reach);  // of |v|, where that is near the reach
    const bool looks_equal = length(v) == number(reach) && excess != 0;
    return "in truth they are " + length(v) + " apart without their radii, which add up to " +
           (looks_equal ? number(gjk::Fraction(abs(excess))) + (excess > 0 ? " less" : " more") : number(reach));
  }
  if (answer == gjk::Status::intersecting)
    return "in truth both objects hold the point " + vector(point_of_a(decided), dimension, place);
  return "in truth a − b is nearest to the origin at v = " + vector(v, dimension) + ", " + length(v) + " away";
}

/// "v lies between a[0] − b[2] and a[1] − b[2]": the certificate.
std::string place_told(const Decided& decided) {
  const ExactVector v = vector_of(decided.point.v);
  const char* const what = v.isZero() ? "the origin" : reach_of(decided) > 0 ? "the point nearest to the origin" : "v";
  std::vector<std::string> differences = differences_told(decided.nearest);
  const std::string last = std::move(differences.back());
  differences.pop_back();
  if (differences.empty()) return what + (" is " + last);
  const char* const where[] = {" lies between ", " lies in the triangle of ", " lies in the tetrahedron of "};
  return what + (where[differences.size() - 1] + joined(differences, ", ")) + " and " + last;
}

}  // namespace

std::string words_for_answer(gjk::Status answer) {
  return answer == gjk::Status::intersecting ? "together" : answer == gjk::Status::separated ? "apart" : "no answer";
}

std::string in_truth(gjk::Status answer) { return answer == gjk::Status::intersecting ? "intersect" : "are apart"; }

TruthTold truth_told(const Truth& truth, const Scene& scene, gjk::Status shown) {
  TruthTold told;
  const auto tell = [&](const std::string& fact) { told.facts.push_back({Fact::Mark::truth, fact}); };
  const auto note = [&](const std::string& sentence) { told.note += (told.note.empty() ? "" : " ") + sentence; };
  const auto tell_and_note = [&](const std::string& clause) {
    tell(clause);
    note(as_sentence(clause) + ".");
  };
  if (is_otherwise(truth, shown)) {
    const std::string by_matrix = truth.by_rounded_turn ? ", by the matrix to which a turn was rounded" : "";
    told.predicate = in_truth(truth.answer.status) + by_matrix;
    note((shown == gjk::Status::undecided ? "No answer"
                                          : as_sentence(searched(scene)) + ": " + words_for_answer(shown)) +
         ". In truth: " + words_for_answer(truth.answer.status) + by_matrix + ".");
    if (const std::optional<Decided> certificate = decided(truth.answer, scene)) {
      tell(why_told(*certificate, truth.answer.status, scene.dimension));
      tell(place_told(*certificate));
    }
    if ((scene.a_as_read || scene.b_as_read) && exact_answer(scene.a, scene.b).status != truth.answer.status)
      tell("this is the truth about the numbers as read: rounding them to floats has moved the objects");
  }
  if (is_open(truth))
    tell_and_note("nothing is proven" + (std::isfinite(truth.answer.gap)
                                             ? ": they are nearer to contact than " + short_number(truth.answer.gap)
                                             : " of so large numbers"));
  if (truth.of_decimals == gjk::Status::undecided)
    tell_and_note("whether that is so of the decimals, too, is not known: they have too many digits");
  else if (truth.of_decimals)
    tell_and_note("as the decimals are written, before they are rounded to doubles, they " +
                  in_truth(*truth.of_decimals));
  if (truth.by_rounded_turn)
    tell_and_note("they are so near to contact that rounding the matrix of a turn may have decided");
  if (truth.exchanged)
    tell_and_note("with a and b exchanged the search answers: " + words_for_answer(*truth.exchanged));
  return told;
}

}  // namespace walkthroughs::story
