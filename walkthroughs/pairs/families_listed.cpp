/// Pairs that can all be listed, and lists of points with repetitions.
#include <algorithm>
#include <array>
#include <cstdint>

#include "walkthroughs/pairs/families_recipes.hpp"

namespace walkthroughs::pairs {
namespace {

// -- Small grids of whole numbers, all of them ------------------------------------------------------------------------

struct Grid {
  std::uint64_t x, y, z;

  std::uint64_t size() const { return x * y * z; }
  Vec operator()(std::uint64_t index) const {
    return {static_cast<double>(index % x), static_cast<double>(index / x % y), static_cast<double>(index / x / y)};
  }
};

std::uint64_t power(std::uint64_t base, int exponent) {
  std::uint64_t product = 1;
  for (int i = 0; i < exponent; ++i) product *= base;
  return product;
}

/// A walk through 0 … size - 1 that jumps about, so that the first pairs of a family are unlike each other.
///
/// Requires: size < 10^12 and not a multiple of the stride, a prime.
std::uint64_t strided(std::uint64_t index, std::uint64_t size) {
  constexpr std::uint64_t stride = 1'000'003;
  return index * stride % size;
}

Points next_points(std::uint64_t& code, const Grid& grid, int count) {
  Points points;
  for (int i = 0; i < count; ++i) {
    points.push_back(grid(code % grid.size()));
    code /= grid.size();
  }
  return points;
}

/// Every list of `count` points of the grid, repetitions and all orders among them, against every other.
Family all_on_grid(std::string name, std::string what, Grid grid, int count) {
  const std::uint64_t size = power(grid.size(), 2 * count);
  return {std::move(name), std::move(what), size, [=](std::uint64_t, std::uint64_t index) {
            std::uint64_t code = strided(index, size);
            Points a = next_points(code, grid, count);
            return Pair{std::move(a), next_points(code, grid, count)};
          }};
}

/// Every choice of four corners of the cube, in one order.
std::vector<Points> four_of_the_cube() {
  constexpr Grid cube{2, 2, 2};
  std::vector<Points> all;
  for (unsigned chosen = 0; chosen < 256; ++chosen) {
    Points points;
    for (unsigned i = 0; i < 8; ++i)
      if (chosen >> i & 1) points.push_back(cube(i));
    if (points.size() == 4) all.push_back(points);
  }
  return all;
}

/// The same, there or up to one step along each axis; none twice.
std::vector<Points> four_of_the_cube_nearby() {
  constexpr Grid places{2, 2, 2};
  std::vector<Points> all;
  for (std::uint64_t i = 0; i < places.size(); ++i)
    for (const Points& four : four_of_the_cube()) {
      const Points there = moved(four, places(i));
      if (std::ranges::find(all, there) == all.end()) all.push_back(there);
    }
  return all;
}

Family grid_tetrahedra() {
  const std::vector<Points> a = four_of_the_cube(), b = four_of_the_cube_nearby();
  const std::uint64_t size = a.size() * b.size();
  return {"grid-tetrahedra",
          "every four corners of {0, 1}³ against every four, there or up to one step along each axis", size,
          [=](std::uint64_t, std::uint64_t index) {
            const std::uint64_t code = strided(index, size);
            return Pair{a[code % a.size()], b[code / a.size()]};
          }};
}

// -- Cycles -----------------------------------------------------------------------------------------------------------

/// One pair apart, one that meets: from each, keeping only the feature last left brings back an earlier simplex for ever,
/// in exact arithmetic too.
const std::array<Pair, 2>& cycling_pairs() {
  static const std::array<Pair, 2> pairs{
      Pair{Points{{-2, 3, 3}, {1, 3, 1}, {3, -2, -1}, {-4, -5, -2}}, Points{{-1, 3, 2}, {0, 10, 4}, {8, 9, 0}}},
      Pair{Points{{274, -351, 0}, {95, -20, 0}, {104, 344, 0}, {346, 81, -2}},
           Points{{70, 207, -1}, {-168, -26, 0}, {144, -198, -1}, {112, 1, 0}}}};
  return pairs;
}

/// Returns: the points in their order number `code`, of size()! many.
Points in_order(Points points, std::uint64_t code) {
  for (std::size_t i = points.size(); i > 1; --i) {
    std::swap(points[i - 1], points[code % i]);
    code /= i;
  }
  return points;
}

/// Moving both sets alike would make no other pair: GJK sees their difference, which stays.
Pair cycle(std::uint64_t index) {
  const Pair& pair = cycling_pairs()[index % 2];
  return {in_order(std::get<Points>(pair.a), 23 - index / 2), pair.b};  // order 23 of 24 is the listed one
}

/// A turn or reflection of the cube: which coordinate goes where, and which are reversed.
Points turned_with_cube(Points points, std::uint64_t code) {
  std::array<Eigen::Index, 3> order{0, 1, 2};
  std::swap(order[2], order[code % 3]);
  std::swap(order[1], order[code / 3 % 2]);
  for (Vec& p : points) {
    const Vec from = p;
    for (std::size_t k = 0; k < 3; ++k) p[static_cast<Eigen::Index>(k)] = (code / 6 >> k & 1 ? -1 : 1) * from[order[k]];
  }
  return points;
}

/// Exchanging A and B would make no other pair: it reflects their difference, which is one of the turns.
Pair cycle_turned(std::uint64_t index) {
  const Pair& pair = cycling_pairs()[index % 2];
  return {turned_with_cube(std::get<Points>(pair.a), index / 2), turned_with_cube(std::get<Points>(pair.b), index / 2)};
}

// -- Repetitions ------------------------------------------------------------------------------------------------------

/// Each point listed once to three times, in any order.
Points repeated(Dice& dice, const Points& points) {
  Points list;
  for (const Vec& p : points) list.insert(list.end(), static_cast<std::size_t>(dice.whole(1, 3)), p);
  dice.shuffle(list);
  return list;
}

Pair duplicates(Dice& dice) {
  Points a = points_in_ball(dice, dice.whole(1, 4));
  Points b = points_in_ball(dice, dice.whole(1, 4));
  if (dice.coin()) b[0] = a[0];
  a = repeated(dice, a);
  return {std::move(a), repeated(dice, b)};
}

}  // namespace

std::vector<Family> listed_families() {
  return {
      all_on_grid("grid-segments", "every two points of {0, 1, 2}³ against every two", {3, 3, 3}, 2),
      all_on_grid("grid-triangles", "every three points of {0, 1}³ against every three", {2, 2, 2}, 3),
      all_on_grid("grid-triangles-flat", "every three points of {0, 1, 2}² against every three", {3, 3, 1}, 3),
      grid_tetrahedra(),
      {"cycles", "two pairs on which GJK cycles, with A's points in every order", 2 * 24,
       [](std::uint64_t, std::uint64_t index) { return cycle(index); }},
      {"cycles-turned", "these two pairs turned and reflected with the cube", 2 * 48,
       [](std::uint64_t, std::uint64_t index) { return cycle_turned(index); }},
      thrown("duplicates", "1 to 4 points, each listed up to three times; half of the pairs share one", duplicates),
  };
}

}  // namespace walkthroughs::pairs
