/// Which points of a set can be the farthest, by direction: for large sets that are asked often.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace gjk::detail {

/// The directions on the surface of a cube, in squares. Each has a list of points: those that are the farthest along one
/// of its directions, or may be so by rounding. What is found among these is what is found among all. Squares with long
/// lists are divided into four.
///
/// A point is left out where another one, q, reaches farther along the directions at all four corners of the square.
/// Directions within are sums of those with positive factors. So q reaches farther along each of them, and by more than
/// the slack. That covers all that rounding can change: what the two reach, in which square a direction falls, and this
/// very comparison. Sixteen times the least number cover what products lose below it, where points are so near to the
/// origin.
template <class S>
class DirectionCells {
 public:
  using Vector = Eigen::Matrix<S, 3, 1>;

  /// Takes n log n time and memory for 32 n numbers at most. Lists stay long where that is not enough: of many points in
  /// one line, all are as far along what is across. `extent`: the largest |x|, |y| and |z|.
  DirectionCells(const std::vector<Vector>& points, const Vector& extent)
      : extent_(extent.maxCoeff()),
        slack_(32 * std::numeric_limits<S>::epsilon() * extent.sum() + 16 * std::numeric_limits<S>::denorm_min()),
        cells_(faces) {
    std::vector<std::uint32_t> all(points.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<Open> open;
    for (std::size_t face = 0; face < faces; ++face) open.push_back({face, {face}, farthest_in({face}, all, points)});
    int divisions = 2;  // as many squares as points, and some more where points are dense
    for (std::size_t left = points.size(); left > 1; left /= 4) ++divisions;
    for (; !open.empty(); --divisions) open = divided(open, divisions > 0, points);
  }

  /// Returns: the places of these points in the list, in order. Empty where all points should be looked at. Most
  /// of them may then be the farthest. Or products would be so large or small that rounding is not relative to them.
  /// Requires: d is not zero.
  std::span<const std::uint32_t> along(const Vector& d) const {
    Eigen::Index axis;
    const S largest = d.cwiseAbs().maxCoeff(&axis), reach = largest * extent_;
    constexpr S epsilon = std::numeric_limits<S>::epsilon(),
                least = std::numeric_limits<S>::min() / (epsilon * epsilon);
    if (!(reach > least && reach < std::numeric_limits<S>::max() * epsilon)) return {};
    S u = d[(axis + 1) % 3] / largest, v = d[(axis + 2) % 3] / largest;
    const Cell* cell = &cells_[static_cast<std::size_t>(2 * axis + (d[axis] < 0))];
    while (cell->is_divided) {
      const bool is_right = u >= 0, is_upper = v >= 0;
      u = 2 * u + (is_right ? -1 : 1);  // within the quarter, from -1 to 1
      v = 2 * v + (is_upper ? -1 : 1);
      cell = &cells_[cell->first + is_right + 2 * is_upper];
    }
    return {listed_.data() + cell->first, cell->count};
  }

 private:
  static constexpr std::size_t faces = 6;
  static constexpr std::size_t enough = 12;         // points; a shorter list takes no less time
  static constexpr std::size_t most_of_point = 32;  // lists that hold it, on average

  /// A square: its list, or its four quarters.
  struct Cell {
    std::size_t first = 0, count = 0;
    bool is_divided = false;
  };

  /// Part of a face of the cube from -1 to 1; face 2 i looks along axis i, face 2 i + 1 the other way.
  struct Square {
    std::size_t face;
    S u = 0, v = 0, half = 1;  // its middle, and half of its side

    /// `du`, `dv`: from -1 to 1 within the square.
    Vector direction(S du, S dv) const {
      const auto axis = static_cast<Eigen::Index>(face / 2);
      Vector d;
      d[axis] = face % 2 == 0 ? 1 : -1;
      d[(axis + 1) % 3] = u + du * half;
      d[(axis + 2) % 3] = v + dv * half;
      return d;
    }
    Square quarter(bool is_right, bool is_upper) const {
      return {face, u + (is_right ? half : -half) / 2, v + (is_upper ? half : -half) / 2, half / 2};
    }
  };

  struct Open {
    std::size_t cell;
    Square square;
    std::vector<std::uint32_t> list;
  };

  /// Returns: the quarters of those whose lists are long, as long as there is room; the others are closed.
  std::vector<Open> divided(const std::vector<Open>& open, bool may_divide, const std::vector<Vector>& points) {
    std::vector<Open> quarters;
    std::size_t held = listed_.size();
    for (const Open& each : open) held += each.list.size();
    for (const Open& each : open) {
      if (!may_divide || each.list.size() <= enough || held > most_of_point * points.size()) {
        close(each, points.size());
        continue;
      }
      cells_[each.cell] = {cells_.size(), 0, true};
      held -= each.list.size();
      for (int i = 0; i < 4; ++i) {
        const Square square = each.square.quarter(i % 2 != 0, i / 2 != 0);
        quarters.push_back({cells_.size(), square, farthest_in(square, each.list, points)});
        held += quarters.back().list.size();
        cells_.emplace_back();
      }
    }
    return quarters;
  }

  void close(const Open& open, std::size_t points) {
    if (4 * open.list.size() > points) return;  // all of them are looked at sooner, in blocks
    cells_[open.cell] = {listed_.size(), open.list.size(), false};
    listed_.insert(listed_.end(), open.list.begin(), open.list.end());
  }

  std::vector<std::uint32_t> farthest_in(const Square& square, const std::vector<std::uint32_t>& list,
                                         const std::vector<Vector>& points) const {
    const Vector middle = square.direction(0, 0);
    const std::uint32_t q = *std::ranges::max_element(list, {}, [&](std::uint32_t i) { return points[i].dot(middle); });
    Vector corners[4];
    S least[4];
    for (int k = 0; k < 4; ++k) {
      corners[k] = square.direction(k % 2 == 0 ? -1 : 1, k / 2 == 0 ? -1 : 1);
      least[k] = points[q].dot(corners[k]) - slack_;
    }
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t i : list) {
      bool reaches = false;
      for (int k = 0; k < 4; ++k) reaches |= !(points[i].dot(corners[k]) < least[k]);
      if (reaches) kept.push_back(i);
    }
    return kept;
  }

  S extent_, slack_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> listed_;
};

}  // namespace gjk::detail
