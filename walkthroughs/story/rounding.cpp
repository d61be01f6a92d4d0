#include "walkthroughs/story/rounding.hpp"

#include <algorithm>
#include <utility>

#include "core/certified/check.hpp"
#include "walkthroughs/story/exact.hpp"

namespace walkthroughs::story {
namespace {

using gjk::Expression;
using gjk::Fraction;
using gjk::NamedVector;

int sign_of(double x) { return (x > 0) - (x < 0); }
int sign_of(const Fraction& x) { return x.sign(); }

bool is_zero(const ExactVector& v) { return v.x() == 0 && v.y() == 0 && v.z() == 0; }

ExactVector exact_difference(const Vertex& vertex) { return exact(vertex.a.point) - exact(vertex.b.point); }

/// Points of round objects and of sums may overflow: then nothing is known.
bool is_finite(const Vertex& vertex) { return vertex.a.point.allFinite() && vertex.b.point.allFinite(); }
bool is_finite(const Simplex& simplex) {
  return std::ranges::all_of(simplex, [](const Vertex& vertex) { return is_finite(vertex); });
}

ExactVector cross(const ExactVector& u, const ExactVector& v) {
  return {u.y() * v.z() - u.z() * v.y(), u.z() * v.x() - u.x() * v.z(), u.x() * v.y() - u.y() * v.x()};
}

// -- Expressions ------------------------------------------------------------------------------------------------------

/// Computes what expressions say of the simplex that is processed.
class Exactly {
 public:
  /// `normal_of_edge`: how the normal of an edge is made, where there is one.
  explicit Exactly(const Simplex& simplex, const Expression& normal_of_edge = {})
      : simplex_(simplex), normal_of_edge_(normal_of_edge) {}

  ExactVector vector(const NamedVector& named) const {
    switch (named.kind) {
      case NamedVector::Kind::to_origin: return -at(gjk::Role::A);
      case NamedVector::Kind::edge: return from_to(named.of[0], named.of[1]);
      case NamedVector::Kind::normal: break;
    }
    if (named.of.size() == 3) return cross(from_to(named.of[0], named.of[1]), from_to(named.of[0], named.of[2]));
    return cross(vector(normal_of_edge_.X), vector(normal_of_edge_.Y));
  }
  /// Requires: the form of a vector.
  ExactVector vector(const Expression& expression) const {
    const ExactVector X = vector(expression.X);
    if (expression.form == Expression::Form::negative) return -X;
    return expression.form == Expression::Form::triple ? cross(cross(X, vector(expression.Y)), X) : X;
  }
  Fraction dot(const Expression& expression) const { return vector(expression.X).dot(vector(expression.Y)); }

 private:
  ExactVector at(gjk::Role role) const { return exact_difference(simplex_[role]); }
  ExactVector from_to(gjk::Role P, gjk::Role Q) const { return at(Q) - at(P); }

  const Simplex& simplex_;
  const Expression normal_of_edge_;
};

// -- Farthest points --------------------------------------------------------------------------------------------------

/// Returns: how far the farthest point reaches along d, and which it is. Only those are compared exactly that could be it.
const Point& farthest(const Points& points, const Point& d) {
  double most = points[0].dot(d), size = 0;
  for (const Point& p : points) {
    most = std::max(most, p.dot(d));
    size = std::max(size, p.cwiseAbs().dot(d.cwiseAbs()));
  }
  constexpr double more_than_roundings = 1e-14, more_than_underflow = 1e-300;
  const double enough = most - (more_than_roundings * size + more_than_underflow);
  const Point* farthest = nullptr;
  for (const Point& p : points)
    if (!(p.dot(d) < enough) && (!farthest || exact(p).dot(exact(d)) > exact(*farthest).dot(exact(d)))) farthest = &p;
  return *farthest;
}

/// Returns: the points of a set that its pose does not move; null of others.
const Points* points_at_rest(const Object& object) {
  return moves(object.pose) ? nullptr : std::get_if<Points>(&object.form);
}

// -- Events -----------------------------------------------------------------------------------------------------------

struct ExactFinding {
  const Moment& now;
  const Scene& scene;
  const Names& names;
  using Finding = std::optional<std::string>;

  Finding operator()(const gjk::SupportFound<double>& e) const {
    const Points *a = points_at_rest(scene.a), *b = points_at_rest(scene.b);
    if (!a || !b || !gjk::is_usable_direction(e.direction)) return std::nullopt;
    const ExactVector d = exact(e.direction), taken = exact_difference(e.vertex),
                      right = exact(farthest(*a, e.direction)) - exact(farthest(*b, -e.direction));
    const Fraction reach = taken.dot(d), farther = right.dot(d) - reach;
    if (!(farther > 0)) return std::nullopt;
    const std::string found = names.of(e.vertex.w) + "·d = " + number(reach),
                      largest = number(Fraction(reach + farther)), other = vector(right, scene.dimension) + "·d";
    return found + ", but " + other + (number(reach) != largest ? " = " + largest : " is larger by " + number(farther));
  }
  Finding operator()(const gjk::CrossingTested<double>& e) const {
    if (!e.value) return std::nullopt;
    const Fraction reach = exact_difference(*now.found).dot(exact(now.direction->value));
    if (sign_of(reach) == sign_of(*e.value)) return std::nullopt;
    return names.of(now.found->w) + "·d = " + number(reach);
  }
  Finding operator()(const gjk::RegionTested<double>& e) const {
    const Exactly exactly(now.processed, e.formula);
    if (const double* value = std::get_if<double>(&e.value))
      if (const Fraction right = exactly.dot(e.expression); sign_of(right) != sign_of(*value))
        return told(e.expression, number(right));
    if (const Point* value = std::get_if<Point>(&e.value))
      if (const ExactVector right = exactly.vector(e.expression); is_zero(right) != value->isZero(0))
        return told(e.expression, vector(right, scene.dimension));
    if (says_to_hold_origin(e) && !holds_origin_exactly(now.processed.only(e.feature)))
      return names.sorted(e.feature) + " does not hold the origin";
    return std::nullopt;
  }
  Finding operator()(const gjk::DirectionChosen<double>& e) const {
    const ExactVector right = Exactly(now.processed).vector(e.expression);
    const bool leads_there = gjk::is_usable_direction(e.direction) && right.dot(exact(e.direction)) > 0;
    return leads_there ? std::nullopt : told(e.expression, vector(right, scene.dimension));
  }
  Finding operator()(const auto&) const { return std::nullopt; }

 private:
  /// Without the crossing test the ends of a segment are not ruled out, and nothing is said of it.
  bool says_to_hold_origin(const gjk::RegionTested<double>& e) const {
    if (e.verdict != gjk::Verdict::chosen) return false;
    if (e.feature.size() == 2 && scene.rules != RuleSet::complete)
      return e.simplex_size == 2 && e.relation == gjk::Relation::zero &&
             scene.options.crossing_test == gjk::CrossingTest::on;
    return e.feature.size() == 4 || e.relation == gjk::Relation::zero;
  }
  Finding told(const Expression& expression, const std::string& value) const {
    return names.translate(expression) + " = " + value;
  }
};

}  // namespace

std::optional<std::string> exact_otherwise(const gjk::Event<double>& event, const Moment& now, const Scene& scene,
                                           const Names& names) {
  if (scene.mistake || now.in_exact_fallback || scene.leaves_truth_out) return std::nullopt;
  if (!is_finite(now.processed) || (now.found && !is_finite(*now.found))) return std::nullopt;
  return std::visit(ExactFinding{now, scene, names}, event);
}

bool holds_origin_exactly(const Simplex& simplex) {
  if (!is_finite(simplex)) return false;
  std::vector<ExactVector> differences;
  for (const Vertex& vertex : simplex) differences.push_back(exact_difference(vertex));
  using Set = gjk::PointSet<Fraction>;
  const Set origin({ExactVector::Zero()});
  for (unsigned chosen = (1U << differences.size()) - 1; chosen > 0; --chosen) {
    gjk::CommonSimplex some;
    for (int i = 0; i < simplex.size(); ++i)
      if (chosen >> i & 1U) some.of.add({i, 0});
    if (gjk::holds(some, Set(differences), origin)) return true;
  }
  return false;
}

}  // namespace walkthroughs::story
