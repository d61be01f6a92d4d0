#include "tests/study/truth/linear_program.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/study/truth/linear_program_simplex.hpp"

namespace study {
namespace {

// -- In floating point ------------------------------------------------------------------------------------------------

/// Both sets, scaled and moved together so that A's first point is the origin and the largest coordinate is between 1/2
/// and 1.
struct InUnitCube {
  Points a, b;
  /// The coordinates differ from exact ones by at most u, from the move alone: scaling lost nothing.
  bool close = true;
};

void scale_to_one(InUnitCube& sets) {
  double largest = 0;
  for (const Points* points : {&sets.a, &sets.b})
    for (const Vec& p : *points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  if (largest == 0) return;
  const int exponent = std::ilogb(largest) + 1;
  for (Points* points : {&sets.a, &sets.b})
    for (Vec& p : *points)
      for (double& coordinate : p) {
        const double scaled = std::ldexp(coordinate, -exponent);
        if (std::ldexp(scaled, exponent) != coordinate)
          sets.close = false;  // its last bits fell below the least double
        coordinate = scaled;
      }
}

InUnitCube in_unit_cube(const Points& a, const Points& b) {
  InUnitCube sets{a, b};
  scale_to_one(sets);
  const Vec origin = sets.a[0];
  for (Points* points : {&sets.a, &sets.b})
    for (Vec& p : *points) p -= origin;
  scale_to_one(sets);
  return sets;
}

/// Where the simplex method ends in floating point: most often at the answer, always near it.
struct Guess {
  Basis basis;
  Vec d;  ///< the direction with the widest gap
};

Guess guess(const InUnitCube& sets) {
  constexpr int enough_steps = 100;
  constexpr double tolerance = 1e-13;  // of a guess: too small or too large, it costs time
  Simplex<double> simplex(columns<double>(sets.a, sets.b), tolerance);
  if (simplex.start_at(first_basis(sets.a, sets.b)))
    for (int i = 0; i < enough_steps && simplex.value() > tolerance && simplex.step(Entering::most_wrong); ++i) {
    }
  const Five<double> y = simplex.prices();
  return {simplex.basis(), {-y[0], -y[1], -y[2]}};
}

// -- Bounds on the error of floating point ----------------------------------------------------------------------------

constexpr double u = std::numeric_limits<double>::epsilon() / 2;  // the largest relative error of one operation

/// Is min_A a·d - max_B b·d above 0 for sure? No coordinate of the points is above 1, so a product a·d, three products
/// and two sums, is wrong by at most 4 u |d|₁, and by what falls below the least double, far below u |d|₁ where |d|₁ is not
/// tiny; a's own coordinates, each wrong by at most u, add u |d|₁. Two products and their difference: below 14 u |d|₁.
bool separates_for_sure(const Vec& d, const InUnitCube& sets) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Vec& p : sets.a) least = std::min(least, p.dot(d));
  for (const Vec& p : sets.b) most = std::max(most, p.dot(d));
  const double length = d.cwiseAbs().sum();
  return length > 1e-100 && least - most > 16 * u * length;
}

double row_norm(const Matrix<double>& m) {
  double largest = 0;
  for (const Five<double>& row : m) {
    double sum = 0;
    for (const double entry : row) sum += std::abs(entry);
    largest = std::max(largest, sum);
  }
  return largest;
}

/// Are all five weights of the basis above 0 for sure, and all five columns points? With R the computed inverse of the
/// basis B, x = R r the computed weights for the right side r, and norms the largest absolute sum of a row: where
/// |I - R B| <= δ < 1, B⁻¹ is at most |R|/(1 - δ), so that the weights are wrong by at most |R| |r - B x|/(1 - δ).
/// I - R B and r - B x are sums of six terms, computed with an error of at most 7 u times the sum of the absolute terms;
/// B's own entries, at most 1, are each wrong by at most u: in the norms, 8 u (5 |R| + 1) and 8 u (5 |x| + 1).
bool meets_for_sure(const Basis& basis, const InUnitCube& sets) {
  const Columns<double> all = columns<double>(sets.a, sets.b);
  const std::size_t points = sets.a.size() + sets.b.size();
  if (std::ranges::any_of(basis, [&](std::size_t column) { return column >= points; })) return false;
  const auto R = inverse(all, basis);
  if (!R) return false;
  Five<double> x;
  for (std::size_t i = 0; i < rows; ++i) x[i] = (*R)[i][3] + (*R)[i][4];

  Matrix<double> I_minus_RB{};
  Five<double> residual{0, 0, 0, 1, 1};
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < rows; ++j) {
      I_minus_RB[i][j] = i == j ? 1 : 0;
      for (std::size_t k = 0; k < rows; ++k) I_minus_RB[i][j] -= (*R)[i][k] * all[basis[j]][k];
      residual[i] -= all[basis[j]][i] * x[j];
    }
  double largest_x = 0, largest_residual = 0;
  for (const double weight : x) largest_x = std::max(largest_x, std::abs(weight));
  for (const double r : residual) largest_residual = std::max(largest_residual, std::abs(r));
  const double delta = row_norm(I_minus_RB) + 8 * u * (rows * row_norm(*R) + 1);
  if (!(delta < 0.5)) return false;
  const double error = 2 * row_norm(*R) * (largest_residual + 8 * u * (rows * largest_x + 1));
  return std::ranges::all_of(x, [&](double weight) { return weight > 2 * error; });
}

std::optional<Truth> within_bounds(const InUnitCube& sets, const Guess& guess) {
  if (!sets.close) return {};
  if (separates_for_sure(guess.d, sets)) return Truth::separated;
  if (meets_for_sure(guess.basis, sets)) return Truth::intersecting;
  return {};
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

CommonPoint common_point(const Simplex<Rational>& simplex, std::size_t a_size, std::size_t b_size) {
  CommonPoint common;
  const Five<Rational> weights = simplex.weights();
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t column = simplex.basis()[i];
    if (column < a_size)
      common.of_a.push_back({column, weights[i]});
    else if (column < a_size + b_size)
      common.of_b.push_back({column - a_size, weights[i]});
  }
  return common;
}

Certificate solve_exactly(const Points& a, const Points& b, const Guess& guess) {
  const SeparatingDirection guessed{exact(guess.d)};
  if (guess.d.allFinite() && holds(guessed, a, b)) return guessed;

  Simplex<Rational> simplex(columns<Rational>(a, b), 0);
  if (!simplex.start_at(guess.basis) && !simplex.start_at(first_basis(a, b)))
    throw std::logic_error("the linear program has no first vertex");
  constexpr int quick_steps = 100;  // after which the method makes sure that it ends
  for (int i = 0; simplex.value() != 0; ++i)
    if (!simplex.step(i < quick_steps ? Entering::most_wrong : Entering::first_wrong)) {
      const Five<Rational> y = simplex.prices();
      return SeparatingDirection{{-y[0], -y[1], -y[2]}};
    }
  return common_point(simplex, a.size(), b.size());
}

void require_points(const Points& points) {
  if (points.empty()) throw std::invalid_argument("the oracle needs at least one point in each set");
  for (const Vec& p : points)
    if (!p.allFinite()) throw std::invalid_argument("the oracle needs finite coordinates");
}

/// Errors: std::logic_error where the certificate does not hold.
Judgement judged_by(const Certificate& certificate, const Points& a, const Points& b) {
  const bool proven = std::visit([&](const auto& proof) { return holds(proof, a, b); }, certificate);
  if (!proven) throw std::logic_error("the certificate of the linear program does not hold");
  return {std::holds_alternative<CommonPoint>(certificate) ? Truth::intersecting : Truth::separated, Proof::fractions};
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

Certificate solve_exactly(const Points& a, const Points& b) { return solve_exactly(a, b, guess(in_unit_cube(a, b))); }

std::optional<Truth> solve_within_bounds(const Points& a, const Points& b) {
  const InUnitCube sets = in_unit_cube(a, b);
  return within_bounds(sets, guess(sets));
}

Judgement judged_by_linear_program(const Points& a, const Points& b) {
  require_points(a);
  require_points(b);
  const InUnitCube sets = in_unit_cube(a, b);
  const Guess guessed = guess(sets);
  if (const auto found = within_bounds(sets, guessed)) return {*found, Proof::error_bounds};
  return judged_by(solve_exactly(a, b, guessed), a, b);
}

Judgement judged_in_fractions(const Points& a, const Points& b) {
  require_points(a);
  require_points(b);
  return judged_by(solve_exactly(a, b), a, b);
}

}  // namespace study
