/// The simplex method for the program of linear_program.hpp, in any number type.
///
/// Columns are A's points, B's points and the coordinates of p - q, each once upward and once downward. Five rows:
///
///   Σ λ_i a_i - Σ μ_j b_j + up - down = 0   (three)      Σ λ_i = 1      Σ μ_j = 1      all of them >= 0
///
/// so at every vertex of the program at most five columns differ from zero: its basis.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tests/study/pairs/pair.hpp"

namespace study {

inline constexpr std::size_t rows = 5;

template <class N>
using Five = std::array<N, rows>;
template <class N>
using Matrix = Five<Five<N>>;  ///< row by row

using Basis = Five<std::size_t>;  ///< the numbers of its columns

template <class N>
using Columns = std::vector<Five<N>>;

template <class N>
Columns<N> columns(const Points& a, const Points& b) {
  Columns<N> all;
  all.reserve(a.size() + b.size() + 6);
  for (const Vec& p : a) all.push_back({N(p[0]), N(p[1]), N(p[2]), N(1), N(0)});
  for (const Vec& p : b) all.push_back({N(-p[0]), N(-p[1]), N(-p[2]), N(0), N(1)});
  for (std::size_t k = 0; k < 3; ++k)
    for (const int sign : {1, -1}) {
      all.push_back({N(0), N(0), N(0), N(0), N(0)});
      all.back()[k] = N(sign);
    }
  return all;
}

/// The first point of each, and the coordinates of their difference.
inline Basis first_basis(const Points& a, const Points& b) {
  const std::size_t slacks = a.size() + b.size();
  Basis basis{0, a.size()};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    basis[2 + k] = slacks + 2 * k + (a[0][axis] > b[0][axis] ? 1 : 0);
  }
  return basis;
}

/// Gauss and Jordan, by the largest pivot. Returns: nothing where the columns depend on each other.
template <class N>
std::optional<Matrix<N>> inverse(const Columns<N>& columns, const Basis& basis) {
  using std::abs;
  Matrix<N> left, right;
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < rows; ++j) {
      left[i][j] = columns[basis[j]][i];
      right[i][j] = N(i == j ? 1 : 0);
    }
  for (std::size_t k = 0; k < rows; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < rows; ++i)
      if (N(abs(left[i][k])) > N(abs(left[best][k]))) best = i;
    if (left[best][k] == 0) return {};
    std::swap(left[k], left[best]);
    std::swap(right[k], right[best]);
    const N pivot = left[k][k];
    for (std::size_t j = 0; j < rows; ++j) left[k][j] /= pivot, right[k][j] /= pivot;
    for (std::size_t i = 0; i < rows; ++i) {
      const N factor = left[i][k];
      if (i == k || factor == 0) continue;
      for (std::size_t j = k; j < rows; ++j) left[i][j] -= factor * left[k][j];
      for (std::size_t j = 0; j < rows; ++j) right[i][j] -= factor * right[k][j];
    }
  }
  return right;
}

/// Which column enters the basis: the one whose price is the most wrong is quick; the first of those whose price is wrong
/// cannot go on for ever (Bland 1977).
enum class Entering { most_wrong, first_wrong };

template <class N>
class Simplex {
 public:
  /// `least`: what counts as more than zero; 0 for exact numbers.
  Simplex(Columns<N> columns, N least) : columns_(std::move(columns)), least_(std::move(least)) {}

  /// Returns: whether `basis` is that of a vertex; only then is the method there.
  bool start_at(const Basis& basis) {
    auto found = inverse(columns_, basis);
    if (!found) return false;
    basis_ = basis;
    inverse_ = std::move(*found);
    const Five<N> w = weights();
    return std::all_of(w.begin(), w.end(), [&](const N& weight) { return weight >= -least_; });
  }

  const Basis& basis() const { return basis_; }

  /// Of the basis's columns.
  Five<N> weights() const {
    Five<N> w;
    for (std::size_t i = 0; i < rows; ++i) w[i] = inverse_[i][3] + inverse_[i][4];
    return w;
  }

  /// |p - q|₁ at this vertex.
  N value() const {
    N sum(0);
    for (std::size_t i = 0; i < rows; ++i)
      if (cost(basis_[i])) sum += inverse_[i][3] + inverse_[i][4];
    return sum;
  }

  /// What each row is worth. At the least value, the first three with their signs turned are the direction with the
  /// widest gap.
  Five<N> prices() const {
    Five<N> y{N(0), N(0), N(0), N(0), N(0)};
    for (std::size_t i = 0; i < rows; ++i)
      if (cost(basis_[i]))
        for (std::size_t j = 0; j < rows; ++j) y[j] += inverse_[i][j];
    return y;
  }

  /// To a neighboring vertex whose value is not larger. Returns: false where there is none, so that the value is the least.
  bool step(Entering rule) {
    const std::optional<std::size_t> entering = column_to_enter(rule);
    if (!entering) return false;
    const Five<N> change = times_inverse(columns_[*entering]);
    const std::optional<std::size_t> leaving = row_to_leave(change);
    if (!leaving) return false;  // which only rounding can bring about: no value is less than 0
    exchange(*leaving, *entering, change);
    return true;
  }

 private:
  bool cost(std::size_t column) const { return column + 6 >= columns_.size(); }

  N reduced_cost(std::size_t column, const Five<N>& y) const {
    const Five<N>& c = columns_[column];
    N r(cost(column) ? 1 : 0);
    for (std::size_t i = 0; i < rows; ++i)
      if (c[i] != 0) r -= y[i] * c[i];
    return r;
  }

  std::optional<std::size_t> column_to_enter(Entering rule) const {
    const Five<N> y = prices();
    std::optional<std::size_t> best;
    N most_wrong = -least_;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      const N r = reduced_cost(j, y);
      if (!(r < most_wrong)) continue;
      best = j;
      if (rule == Entering::first_wrong) break;
      most_wrong = r;
    }
    return best;
  }

  /// The row whose weight first falls to zero; of several the one whose column has the least number.
  std::optional<std::size_t> row_to_leave(const Five<N>& change) const {
    const Five<N> w = weights();
    std::optional<std::size_t> first;
    N shortest(0);
    for (std::size_t i = 0; i < rows; ++i) {
      if (!(change[i] > least_)) continue;
      const N length = w[i] / change[i];
      if (first && (length > shortest || (length == shortest && basis_[i] > basis_[*first]))) continue;
      first = i;
      shortest = length;
    }
    return first;
  }

  Five<N> times_inverse(const Five<N>& column) const {
    Five<N> product{N(0), N(0), N(0), N(0), N(0)};
    for (std::size_t i = 0; i < rows; ++i)
      for (std::size_t j = 0; j < rows; ++j)
        if (column[j] != 0) product[i] += inverse_[i][j] * column[j];
    return product;
  }

  void exchange(std::size_t leaving, std::size_t entering, const Five<N>& change) {
    for (N& entry : inverse_[leaving]) entry /= change[leaving];
    for (std::size_t i = 0; i < rows; ++i)
      if (i != leaving && change[i] != 0)
        for (std::size_t j = 0; j < rows; ++j) inverse_[i][j] -= change[i] * inverse_[leaving][j];
    basis_[leaving] = entering;
  }

  Columns<N> columns_;
  N least_;
  Basis basis_{};
  Matrix<N> inverse_{};
};

}  // namespace study
