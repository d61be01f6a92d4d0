#include "tests/study/truth/linear_program.hpp"

#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>

namespace study {
namespace {

// -- The program, and its solver --------------------------------------------------------------------------------------

using Number = CGAL::Gmpzf;  // a whole number of any length, times a power of two
using Solution = CGAL::Quadratic_program_solution<Number>;
using Pricing = CGAL::Quadratic_program_pricing_strategy;

constexpr int rows = 5;
using Column = std::array<double, rows>;

std::vector<Column> columns(const Points& a, const Points& b) {
  std::vector<Column> all;
  all.reserve(a.size() + b.size());
  for (const Vec& p : a) all.push_back({p[0], p[1], p[2], 1, 0});
  for (const Vec& p : b) all.push_back({-p[0], -p[1], -p[2], 0, 1});
  return all;
}

Solution solution(const Points& a, const Points& b, Pricing pricing) {
  const std::vector<Column> all = columns(a, b);
  std::vector<const double*> first_rows;
  for (const Column& column : all) first_rows.push_back(column.data());
  const Column right_sides{0, 0, 0, 1, 1};
  const auto program = CGAL::make_nonnegative_linear_program_from_iterators(
      static_cast<int>(all.size()), rows, first_rows.begin(), right_sides.begin(),
      CGAL::Const_oneset_iterator<CGAL::Comparison_result>(CGAL::EQUAL), CGAL::Const_oneset_iterator<double>(0));
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(pricing);
  return CGAL::solve_nonnegative_linear_program(program, Number(), options);
}

// -- Its certificates -------------------------------------------------------------------------------------------------

Rational fraction(const Number& x) {
  using Whole = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
  const Whole mantissa(x.man()), power = Whole(1) << std::abs(x.exp());
  return x.exp() < 0 ? Rational(mantissa, power) : Rational(Whole(mantissa * power));
}

CommonPoint common_point(const Solution& solution, std::size_t a_size) {
  CommonPoint common;
  const Rational denominator = fraction(solution.variables_common_denominator());
  std::for_each(solution.basic_variable_indices_begin(), solution.basic_variable_indices_end(), [&](int variable) {
    const Rational weight = fraction(*(solution.variable_numerators_begin() + variable)) / denominator;
    const auto index = static_cast<std::size_t>(variable);
    if (index < a_size)
      common.of_a.push_back({index, weight});
    else
      common.of_b.push_back({index - a_size, weight});
  });
  return common;
}

/// The solver's y has y·(column) >= 0 for every column and y·(right sides) < 0: so that a·d >= -y₃ > y₄ >= b·d.
SeparatingDirection separating_direction(const Solution& solution) {
  const auto y = solution.infeasibility_certificate_begin();
  return {{fraction(*y), fraction(*(y + 1)), fraction(*(y + 2))}};
}

Certificate certificate_of(const Solution& solution, std::size_t a_size) {
  if (solution.is_infeasible()) return separating_direction(solution);
  return common_point(solution, a_size);
}

bool holds(const Certificate& certificate, const Points& a, const Points& b) {
  return std::visit([&](const auto& proof) { return study::holds(proof, a, b); }, certificate);
}

// -- In fractions -----------------------------------------------------------------------------------------------------

RationalVec exact(const Vec& v) { return {Rational(v[0]), Rational(v[1]), Rational(v[2])}; }

Rational dot(const RationalVec& u, const RationalVec& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

/// Returns: the point, or nothing where these are not the weights of a convex combination.
std::optional<RationalVec> combined(const std::vector<Weight>& weights, const Points& points) {
  RationalVec sum{0, 0, 0};
  Rational total = 0;
  for (const auto& [index, weight] : weights) {
    if (index >= points.size() || weight < 0) return {};
    const RationalVec p = exact(points[index]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * p[k];
    total += weight;
  }
  if (total != 1) return {};
  return sum;
}

// -- Other programs of the same kind ----------------------------------------------------------------------------------

/// Returns: whether weights >= 0 of the columns make the right side. By Bland's rule, which is exact.
bool is_feasible(const std::vector<std::vector<Number>>& all, const std::vector<Number>& right_sides) {
  std::vector<std::vector<Number>::const_iterator> first_rows;
  for (const auto& column : all) first_rows.push_back(column.begin());
  const auto program = CGAL::make_nonnegative_linear_program_from_iterators(
      static_cast<int>(all.size()), static_cast<int>(right_sides.size()), first_rows.begin(), right_sides.begin(),
      CGAL::Const_oneset_iterator<CGAL::Comparison_result>(CGAL::EQUAL),
      CGAL::Const_oneset_iterator<Number>(Number(0)));
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);
  return !CGAL::solve_nonnegative_linear_program(program, Number(), options).is_infeasible();
}

Number number(const boost::multiprecision::mpz_int& whole) { return Number(CGAL::Gmpz(whole.backend().data())); }

void require_points(const Points& points) {
  if (points.empty()) throw std::invalid_argument("the oracle needs at least one point in each set");
  for (const Vec& p : points)
    if (!p.allFinite()) throw std::invalid_argument("the oracle needs finite coordinates");
}

}  // namespace

bool holds(const CommonPoint& common, const Points& a, const Points& b) {
  const auto of_a = combined(common.of_a, a), of_b = combined(common.of_b, b);
  return of_a && of_b && *of_a == *of_b;
}

bool holds(const SeparatingDirection& separating, const Points& a, const Points& b) {
  Rational least = dot(separating.d, exact(a[0]));
  for (const Vec& p : a) least = std::min(least, dot(separating.d, exact(p)));
  return std::ranges::all_of(b, [&](const Vec& p) { return dot(separating.d, exact(p)) < least; });
}

/// The quick way to choose columns compares in doubles first. Where products of coordinates leave the range of doubles it
/// can end too early, with a certificate that does not hold. Bland's rule is exact, always ends, and takes twice as long.
Certificate certificate(const Points& a, const Points& b) {
  require_points(a);
  require_points(b);
  for (const Pricing pricing : {CGAL::QP_PARTIAL_FILTERED_DANTZIG, CGAL::QP_BLAND}) {
    Certificate found = certificate_of(solution(a, b, pricing), a.size());
    if (holds(found, a, b)) return found;
  }
  throw std::logic_error("the certificate of the linear program does not hold");
}

Truth truth_by_linear_program(const Points& a, const Points& b) {
  return std::holds_alternative<CommonPoint>(certificate(a, b)) ? Truth::intersecting : Truth::separated;
}

/// Σ λ_i (q a_i) = q·point and Σ λ_i = 1, times the common denominator q of the point.
bool hull_contains(const Points& points, const RationalVec& point) {
  require_points(points);
  boost::multiprecision::mpz_int q = 1;
  for (const Rational& x : point) q = lcm(q, boost::multiprecision::mpz_int(denominator(x)));
  std::vector<std::vector<Number>> all;
  for (const Vec& p : points) {
    std::vector<Number> column;
    for (const double x : p) column.push_back(number(q) * Number(x));
    column.emplace_back(1);
    all.push_back(std::move(column));
  }
  std::vector<Number> right_sides;
  for (const Rational& x : point)
    right_sides.push_back(number(boost::multiprecision::mpz_int(numerator(Rational(x * Rational(q))))));
  right_sides.emplace_back(1);
  return is_feasible(all, right_sides);
}

/// Some multiple of A - B has t inside, for each corner t of a tetrahedron about the origin: Σ α_i a_i - Σ β_j b_j = t,
/// Σ α_i = Σ β_j.
bool hulls_only_touch(const Points& a, const Points& b) {
  require_points(a);
  require_points(b);
  std::vector<std::vector<Number>> all;
  for (const Vec& p : a) all.push_back({Number(p[0]), Number(p[1]), Number(p[2]), Number(1)});
  for (const Vec& p : b) all.push_back({-Number(p[0]), -Number(p[1]), -Number(p[2]), Number(-1)});
  constexpr std::array<std::array<int, 3>, 4> corners{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  return !std::ranges::all_of(corners, [&](const std::array<int, 3>& t) {
    return is_feasible(all, {Number(t[0]), Number(t[1]), Number(t[2]), Number(0)});
  });
}

}  // namespace study
