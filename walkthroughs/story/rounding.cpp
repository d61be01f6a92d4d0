#include "walkthroughs/story/rounding.hpp"

#include <algorithm>
#include <utility>

#include "walkthroughs/story/exact.hpp"

namespace walkthroughs::story {
namespace {

using gjk::Expression;
using gjk::Fraction;
using gjk::NamedVector;

using gjk::detail::Dyadic;
using gjk::detail::sign_of;

int sign_of(double x) { return (x > 0) - (x < 0); }

bool is_zero(const ExactPoint& v) { return v.x.m == 0 && v.y.m == 0 && v.z.m == 0; }

ExactPoint exact_difference(const Vertex& vertex) { return exact(vertex.a.point) - exact(vertex.b.point); }

Fraction fraction(const Dyadic& x) {
  const Fraction m(boost::multiprecision::cpp_int(x.m)), power(boost::multiprecision::cpp_int(1) << std::abs(x.e));
  return x.e < 0 ? m / power : m * power;
}
ExactVector fractions(const ExactPoint& v) { return {fraction(v.x), fraction(v.y), fraction(v.z)}; }

/// Points of round objects and of sums may overflow: then nothing is known.
bool is_finite(const Vertex& vertex) { return vertex.a.point.allFinite() && vertex.b.point.allFinite(); }
bool is_finite(const Simplex& simplex) {
  return std::ranges::all_of(simplex, [](const Vertex& vertex) { return is_finite(vertex); });
}

// -- Expressions ------------------------------------------------------------------------------------------------------

/// Computes what expressions say of the simplex that is processed.
class Exactly {
 public:
  /// `normal_of_edge`: how the normal of an edge is made, where there is one.
  explicit Exactly(const Simplex& simplex, const Expression& normal_of_edge = {})
      : simplex_(simplex), normal_of_edge_(normal_of_edge) {}

  ExactPoint vector(const NamedVector& named) const {
    switch (named.kind) {
      case NamedVector::Kind::to_origin: return -at(gjk::Role::A);
      case NamedVector::Kind::edge: return from_to(named.of[0], named.of[1]);
      case NamedVector::Kind::normal: break;
    }
    if (named.of.size() == 3) return cross(from_to(named.of[0], named.of[1]), from_to(named.of[0], named.of[2]));
    return cross(vector(normal_of_edge_.X), vector(normal_of_edge_.Y));
  }
  /// Requires: the form of a vector.
  ExactPoint vector(const Expression& expression) const {
    const ExactPoint X = vector(expression.X);
    if (expression.form == Expression::Form::negative) return -X;
    return expression.form == Expression::Form::triple ? cross(cross(X, vector(expression.Y)), X) : X;
  }
  Dyadic dot(const Expression& expression) const {
    return gjk::detail::dot(vector(expression.X), vector(expression.Y));
  }

 private:
  ExactPoint at(gjk::Role role) const { return exact_difference(simplex_[role]); }
  ExactPoint from_to(gjk::Role P, gjk::Role Q) const { return at(Q) - at(P); }

  const Simplex& simplex_;
  const Expression normal_of_edge_;
};

// -- Farthest points --------------------------------------------------------------------------------------------------

bool is_farther(const Point& p, const Point& q, const Point& d) {
  return sign_of(dot(exact(p) - exact(q), exact(d))) > 0;
}

/// Returns: the point that reaches farthest along d. Only those are compared exactly that could be it.
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
    if (!(p.dot(d) < enough) && (!farthest || is_farther(p, *farthest, d))) farthest = &p;
  return *farthest;
}

/// Returns: the points of a set that its pose does not move; null of others.
const Points* points_at_rest(const Object& object) {
  return moves(object.pose) ? nullptr : std::get_if<Points>(&object.form);
}

// -- The origin in a simplex ------------------------------------------------------------------------------------------

using ExactSimplex = std::vector<ExactPoint>;

bool is_origin_in(const ExactSimplex& points);

bool is_origin_in_a_face(const ExactSimplex& points) {
  for (std::size_t left_out = 0; left_out < points.size(); ++left_out) {
    ExactSimplex face = points;
    face.erase(face.begin() + static_cast<std::ptrdiff_t>(left_out));
    if (is_origin_in(face)) return true;
  }
  return false;
}

bool is_origin_in_triangle(const ExactPoint& A, const ExactPoint& B, const ExactPoint& C, const ExactPoint& n) {
  return sign_of(dot(n, A)) == 0 && sign_of(dot(n, cross(A, B))) >= 0 && sign_of(dot(n, cross(B, C))) >= 0 &&
         sign_of(dot(n, cross(C, A))) >= 0;
}

int sign_of_volume(const ExactSimplex& p) { return sign_of(dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0]))); }

/// The origin in the place of any vertex leaves the volume its sign, or nothing of it.
bool is_origin_in_tetrahedron(const ExactSimplex& points, int volume) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    ExactSimplex with_origin = points;
    with_origin[i] = {0, 0, 0};
    if (sign_of_volume(with_origin) * volume < 0) return false;
  }
  return true;
}

/// What is flat is covered by its faces.
bool is_origin_in(const ExactSimplex& p) {
  switch (p.size()) {
    case 0: return false;
    case 1: return is_zero(p[0]);
    case 2: return is_zero(cross(p[0], p[1])) && sign_of(dot(p[0], p[1])) <= 0;
    case 3: {
      const ExactPoint n = cross(p[1] - p[0], p[2] - p[0]);
      return is_zero(n) ? is_origin_in_a_face(p) : is_origin_in_triangle(p[0], p[1], p[2], n);
    }
    default: {
      const int volume = sign_of_volume(p);
      return volume == 0 ? is_origin_in_a_face(p) : is_origin_in_tetrahedron(p, volume);
    }
  }
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
    const ExactPoint d = exact(e.direction), taken = exact_difference(e.vertex),
                     right = exact(farthest(*a, e.direction)) - exact(farthest(*b, -e.direction));
    if (sign_of(dot(right - taken, d)) <= 0) return std::nullopt;
    const Fraction reach = fraction(dot(taken, d)), farther = fraction(dot(right - taken, d));
    const std::string found = names.of(e.vertex.w) + "·d = " + number(reach),
                      largest = number(Fraction(reach + farther)),
                      other = vector(fractions(right), scene.dimension) + "·d";
    return found + ", but " + other + (number(reach) != largest ? " = " + largest : " is larger by " + number(farther));
  }
  Finding operator()(const gjk::CrossingTested<double>& e) const {
    if (!e.value) return std::nullopt;
    const Dyadic reach = dot(exact_difference(*now.found), exact(now.direction->value));
    if (sign_of(reach) == sign_of(*e.value)) return std::nullopt;
    return names.of(now.found->w) + "·d = " + number(fraction(reach));
  }
  Finding operator()(const gjk::RegionTested<double>& e) const {
    const Exactly exactly(now.processed, e.formula);
    if (const double* value = std::get_if<double>(&e.value))
      if (const Dyadic right = exactly.dot(e.expression); sign_of(right) != sign_of(*value))
        return told(e.expression, number(fraction(right)));
    if (const Point* value = std::get_if<Point>(&e.value))
      if (const ExactPoint right = exactly.vector(e.expression); is_zero(right) != value->isZero(0))
        return told(e.expression, vector(fractions(right), scene.dimension));
    if (says_to_hold_origin(e) && !holds_origin_exactly(now.processed.only(e.feature)))
      return names.sorted(e.feature) + " does not hold the origin";
    return std::nullopt;
  }
  Finding operator()(const gjk::DirectionChosen<double>& e) const {
    const ExactPoint right = Exactly(now.processed).vector(e.expression);
    const bool leads_there = gjk::is_usable_direction(e.direction) && sign_of(dot(right, exact(e.direction))) > 0;
    return leads_there ? std::nullopt : told(e.expression, vector(fractions(right), scene.dimension));
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
  ExactSimplex points;
  for (const Vertex& vertex : simplex) points.push_back(exact_difference(vertex));
  return is_origin_in(points);
}

}  // namespace walkthroughs::story
