// What a trace may say of an expression: its value to rounding, and 0 where it is small beside the lengths in it.
#include "walkthroughs/trace/trace_expression.hpp"

#include "tests/kit/catch.hpp"

using namespace walkthroughs;

namespace {

gjk::Simplex<double> simplex_of(const std::vector<Point>& oldest_first) {
  gjk::Simplex<double> simplex;
  for (const Point& w : oldest_first) {
    gjk::Vertex<double> vertex;
    vertex.w = w;
    vertex.a = {Point(w + Point(5, 0, 0))};
    vertex.b = {Point(5, 0, 0)};
    simplex.add(vertex);
  }
  return simplex;
}

}  // namespace

TEST_CASE("The size of an expression is the product of the lengths in it, AO as long as both points together") {
  const gjk::Simplex<double> abc = simplex_of({Point(2, 0, 7), Point(1, 3, -2), Point(1, 2, 3)});  // C, B, A
  const double AB = 0 + 1 + 5, AC = 1 + 2 + 4, AO = (6 + 2 + 3) + 5;
  CHECK(size_of("AB×AO", abc) == AB * AO);
  CHECK(size_of("AC×AO×AC", abc) == AC * AO * AC);
  CHECK(size_of("ABCn", abc) == AB * AC);
}

TEST_CASE("What is 16 roundings of its size may count as 0, a little more may not") {
  const double size = 6 * 16;
  for (const auto& [scalar, epsilon] : {std::pair{Scalar::binary64, 0x1p-52}, std::pair{Scalar::binary32, 0x1p-23}})
    for (const double sign : {1.0, -1.0}) {
      CHECK(may_count_as_zero(sign * 16 * epsilon * size, size, scalar));
      CHECK_FALSE(may_count_as_zero(sign * 16.02 * epsilon * size, size, scalar));
    }
}
