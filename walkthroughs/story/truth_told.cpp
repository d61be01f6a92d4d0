#include "walkthroughs/story/truth_told.hpp"

#include <vector>

#include "core/certified/check.hpp"
#include "walkthroughs/story/exact.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

constexpr const char* words_for_answer(gjk::Status answer) {
  return answer == gjk::Status::intersecting ? "together" : answer == gjk::Status::separated ? "apart" : "no answer";
}

/// What is searched otherwise than the truth is found.
std::string searched(const Scene& scene) {
  if (scene.rules == RuleSet::as_printed) return "as printed";
  return scene.scalar == Scalar::binary32 ? "in floats" : "in doubles";
}

/// Returns: point `i` of a set of points, exactly where the matrix of its pose puts it.
ExactVector exact_point(const Object& object, int i) {
  const ExactVector p = exact(std::get<Points>(object.form)[static_cast<std::size_t>(i)]),
                    t = exact(object.pose.translation);
  ExactVector moved;
  for (int row = 0; row < 3; ++row) moved[row] = exact(Point(object.pose.rotation.row(row))).dot(p) + t[row];
  return moved;
}

/// The points that a certificate names, numbered anew in its order.
struct NamedPoints {
  std::vector<ExactVector> a, b;
  gjk::IndexPairs of;

  NamedPoints(const gjk::IndexPairs& pairs, const Scene& scene) {
    for (const gjk::IndexPair pair : pairs) {
      of.add({static_cast<int>(a.size()), static_cast<int>(a.size())});
      a.push_back(exact_point(a_as_read(scene), pair.a));
      b.push_back(exact_point(b_as_read(scene), pair.b));
    }
  }
};

/// Requires: a certificate of this scene.
std::string certificate_told(const ExactAnswer& answer, const Scene& scene) {
  const NamedPoints named(answer.nearest, scene);
  const gjk::PointSet<gjk::Fraction> a(named.a), b(named.b);
  if (answer.status == gjk::Status::separated) {
    const gjk::detail::Fractions d = gjk::direction_of(gjk::SeparatingFeature{named.of}, a, b).value();
    const ExactVector v(-d[0], -d[1], -d[2]);
    return "in truth a − b is nearest to the origin at v = " + vector(v, scene.dimension) + ", " + length(v) + " away";
  }
  const gjk::detail::Fractions weights = gjk::weights_of(gjk::CommonSimplex{named.of}, a, b).value();
  ExactVector point = ExactVector::Zero();
  for (std::size_t i = 0; i < weights.size(); ++i) point += named.a[i] * weights[i];
  return "in truth both objects hold the point " + vector(point, scene.dimension, place);
}

/// "a[0] − b[2], a[1] − b[2]", by the places of the points in their sets.
std::string differences_told(const gjk::IndexPairs& pairs) {
  return joined(pairs, ", ", [](const gjk::IndexPair& pair) {
    return "a[" + std::to_string(pair.a) + "] − b[" + std::to_string(pair.b) + "]";
  });
}

bool have_points(const Scene& scene) {
  return std::holds_alternative<Points>(scene.a.form) && std::holds_alternative<Points>(scene.b.form);
}

}  // namespace

std::string in_truth(gjk::Status answer) {
  return answer == gjk::Status::intersecting ? "they intersect" : "they are apart";
}

TruthTold truth_told(const Truth& truth, const Scene& scene, gjk::Status shown) {
  TruthTold told;
  const auto tell = [&](const std::string& fact) { told.facts.push_back({Fact::Mark::truth, fact}); };
  const auto note = [&](const std::string& sentence) { told.note += (told.note.empty() ? "" : " ") + sentence; };
  const auto tell_and_note = [&](const std::string& clause) {
    tell(clause);
    note(as_sentence(clause) + ".");
  };
  if (is_otherwise(truth, shown)) {
    const std::string in_truth_they = in_truth(truth.answer.status);
    told.sentence = "in truth " + in_truth_they;
    note((shown == gjk::Status::undecided ? "No answer"
                                          : as_sentence(searched(scene)) + ": " + words_for_answer(shown)) +
         ". In truth: " + in_truth_they + ".");
    if (truth.answer.nearest.size() > 0 && have_points(scene)) {
      tell(certificate_told(truth.answer, scene));
      tell("the certificate is " + differences_told(truth.answer.nearest));
    }
    if ((scene.a_as_read || scene.b_as_read) && exact_answer(scene.a, scene.b).status != truth.answer.status)
      tell("this is the truth about the numbers as read: rounding them to floats has moved the objects");
  }
  if (truth.of_decimals) tell_and_note("the decimals as typed say otherwise: " + in_truth(*truth.of_decimals));
  if (truth.exchanged)
    tell_and_note("with a and b exchanged the search answers: " + std::string(words_for_answer(*truth.exchanged)));
  return told;
}

}  // namespace walkthroughs::story
