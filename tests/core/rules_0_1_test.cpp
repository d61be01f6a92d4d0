/// Algorithms 2 and 3: a single vertex, and a segment.
#include "tests/core/rules_support.hpp"

namespace gjk::test {
namespace {

const Points elsewhere{{3, 0, 0}, {0, -2, 0}, {1, -2, 3}, {-5, 4, 1}};

TEMPLATE_TEST_CASE("Algorithm 2: from a vertex elsewhere the search goes straight toward the origin", "[rules]", float,
                   double, long double, Rational) {
  for (const auto& frame : frames<TestType>())
    for (const Point& p : elsewhere) {
      INFO(frame.name);
      const std::vector<Vec3<TestType>> vertex{frame(p)};
      const auto told = ask_rules(vertex);
      REQUIRE(told.skipped.empty());
      REQUIRE(told.decided == "A: yes");
      REQUIRE(told.regions[0].expression == "AO");
      REQUIRE(told.regions[0].relation == Relation::not_zero);
      REQUIRE(std::get<Vec3<TestType>>(told.regions[0].value) == Vec3<TestType>(-vertex[0]));
      REQUIRE(told.next == "A");
      REQUIRE(told.expression == "AO");
      REQUIRE(told.direction == Vec3<TestType>(-vertex[0]));
    }
}

TEMPLATE_TEST_CASE("Algorithm 2: a vertex at the origin contains it", "[rules]", float, double, long double, Rational) {
  const auto told = ask_rules<TestType>({vec<TestType>({0, 0, 0})});
  REQUIRE(told.decided == "A: yes");
  REQUIRE(told.regions[0].relation == Relation::zero);
  REQUIRE_FALSE(told.direction.has_value());
}

// The middle of the segment is a lattice point, and so are places beside it in all directions.
const Points segment{{0, 0, 0}, {4, 2, -2}};
const Points both_orders[] = {segment, {segment[1], segment[0]}};

const std::string skipped_by_algorithm_3 = "B R1, A R2";

template <class S>
void require_beside_segment(const std::vector<Vec3<S>>& BA) {
  const auto told = ask_rules(BA);
  REQUIRE(told.skipped == skipped_by_algorithm_3);
  REQUIRE(told.decided == "AB R3 or R4: yes");
  const auto& region = told.region("AB");
  REQUIRE(region.expression == "AB×AO×AB");
  REQUIRE(region.relation == Relation::not_zero);
  REQUIRE(std::get<Vec3<S>>(region.value) == told.direction);
  REQUIRE(told.next == "BA");
  REQUIRE(told.expression == "AB×AO×AB");
  require_search_from_kept_feature_to_origin(told, BA);
}

template <class S>
void require_on_segment(const std::vector<Vec3<S>>& BA) {
  const auto told = ask_rules(BA);
  REQUIRE(told.skipped == skipped_by_algorithm_3);
  REQUIRE(told.decided == "AB: yes");
  REQUIRE(told.region("AB").relation == Relation::zero);
  REQUIRE_FALSE(told.direction.has_value());
}

TEMPLATE_TEST_CASE("Algorithm 3: beside a segment (R3 or R4) the search leaves it at a right angle", "[rules]", float,
                   double, long double, Rational) {
  const Points beside{{2, 1, 1}, {2, 1, -3}, {3, 0, 1}, {1, 2, -1}, {1, 0, -3}, {2, 4, 2}};
  for (const auto& frame : frames<TestType>())
    for (const Points& BA : both_orders)
      for (const Point& origin : beside) {
        INFO(frame.name);
        require_beside_segment(seen_from(origin, BA, frame));
      }
}

TEMPLATE_TEST_CASE("Algorithm 3: a segment through the origin contains it", "[rules]", float, double, long double,
                   Rational) {
  const Points on{{0, 0, 0}, {2, 1, -1}, {4, 2, -2}};  // one end, the middle, the other end
  for (const auto& frame : frames_without_rounding<TestType>())
    for (const Points& BA : both_orders)
      for (const Point& origin : on) {
        INFO(frame.name);
        require_on_segment(seen_from(origin, BA, frame));
      }
}

TEST_CASE("Algorithm 3 agrees with linear equations wherever the origin is beyond neither end", "[rules]") {
  int beside = 0, on = 0;
  for (const auto& frame : frames<Rational>())
    for (const Points& BA : both_orders)
      for (int x = -2; x <= 6; ++x)
        for (int y = -2; y <= 4; ++y)
          for (int z = -4; z <= 2; ++z) {
            const auto simplex = seen_from({x, y, z}, BA, frame);
            const auto coordinates = coordinates_of_origin(exact(simplex));
            if (coordinates[0] < 0 || coordinates[1] < 0) continue;
            INFO(frame.name << ", origin at " << x << " " << y << " " << z);
            const bool is_on = toward_origin(exact(simplex)) == ExactVec(ExactVec::Zero());
            ++(is_on ? on : beside);
            is_on ? require_on_segment(simplex) : require_beside_segment(simplex);
          }
  REQUIRE(on == 3 * 6 * 2);
  REQUIRE(beside > 1000);
}

TEST_CASE("Algorithm 3 searches at a right angle where AO itself would nearly run back along the segment (ping-pong)",
          "[rules]") {
  // A mistake that the report names: the direction taken from a vertex in place of the feature.
  const std::vector<Vec3<double>> BA{{-1000, 1, 0}, {1000, 1, 0}};
  const auto told = ask_rules(BA);
  REQUIRE(told.direction->dot(BA[1] - BA[0]) == 0);
  REQUIRE(told.direction->y() < 0);
}

}  // namespace
}  // namespace gjk::test
