#include "tests/study/methods/mistakes.hpp"

#include <bit>

#include "tests/study/methods/wrong_rules.hpp"

namespace study {
namespace {

using Vec3 = gjk::Vec3<double>;
using Set = gjk::PointSet<double>;

/// A set that notes in which directions it was asked.
class Noting {
 public:
  explicit Noting(const Set& inner) : inner_(inner) {}
  gjk::SupportPoint<double> support(const Vec3& d) const {
    for (const double x : d) way_ = (way_ ^ std::bit_cast<std::uint64_t>(x)) * 0x100000001b3;
    return inner_.support(d);
  }
  std::uint64_t way() const { return way_; }

 private:
  const Set& inner_;
  mutable std::uint64_t way_ = 0xcbf29ce484222325;
};

template <class AllRules>
Run ask(const Set& a, const Set& b) {
  const Noting noting(a);
  const auto result = gjk::collision<double, AllRules>(noting, b);
  return {result.status, result.iterations, noting.way()};
}

/// Eq. 8 with support(B, d) in place of support(B, -d).
struct Backward {
  const Set& inner;
  gjk::SupportPoint<double> support(const Vec3& d) const { return inner.support(-d); }
};

Run ask_for_the_wrong_side_of_B(const Set& a, const Set& b) {
  const Noting noting(a);
  const auto result = gjk::collision<double>(noting, Backward{b});
  return {result.status, result.iterations, noting.way()};
}

/// Eq. 9 asked of the first point too; apart from that the run is the right one.
Run test_the_first_point(const Set& a, const Set& b) {
  const Vec3 first = gjk::Options<double>{}.first_direction;
  const Noting noting(a);
  const bool stops = gjk::MinkowskiDifference<double, Noting, Set>(noting, b).vertex(first).w.dot(first) < 0;
  return stops ? Run{gjk::Status::separated, 1, noting.way()} : ask_faithfully(a, b);
}

template <class Details>
constexpr auto with = &ask<Rules<Details>>;

}  // namespace

Run ask_faithfully(const Set& a, const Set& b) { return ask<gjk::AsIntended>(a, b); }

const std::vector<Mistake>& mistakes() {
  using namespace mistake;
  static const std::vector<Mistake> all{
      {"support(B, d) in place of support(B, −d) (Eq. 8)", "2.4", ask_for_the_wrong_side_of_B},
      {"the crossing test is applied to the first point, too", "3.1.3", test_the_first_point},
      {"<= in place of < in Eq. 9", "3.1.3", ask<StopsWhereTouched>},
      {"the simplex is processed after Eq. 9 has said no (Algorithm 1 as printed)", "3.1.4", ask<gjk::AsPrinted>},
      {"the origin on the first vertex is not recognised", "3.2.1", with<OriginAtVertexMissed>},
      {"the origin on the segment is not recognised: a search along the zero vector", "3.2.2",
       with<OriginOnSegmentMissed>},
      {"the direction is taken from the vertex (AO), not from the edge: ping-pong", "3.2.2", with<DirectionFromVertex>},
      {"ABCn of the triangle in the wrong order, and ABn, ACn with it", "3.2.3", with<TriangleNormalReversed>},
      {"ABn of the triangle points inward", "3.2.3", with<TriangleABnInward>},
      {"ACn of the triangle points inward", "3.2.3", with<TriangleACnInward>},
      {"ABn, ACn, ADn used as 3D search direction", "3.2.3", with<EdgeNormalAsDirection>},
      {"2D only: inside the three edges is inside", "3.2.3", with<TwoDimensionsOnly>},
      {"the origin in the triangle is not recognised", "3.2.3", with<OriginInTriangleMissed>},
      {"the order is not changed when moving below the triangle", "3.2.3", with<OrderKeptBelowTriangle>},
      {"ABCn of the tetrahedron points inward", "3.2.4", with<ABCnInward>},
      {"ACDn of the tetrahedron points inward", "3.2.4", with<ACDnInward>},
      {"ADBn of the tetrahedron points inward", "3.2.4", with<ADBnInward>},
      {"the edge normals of the face before are used again: ACn for ACD, ADn for ADB", "3.2.4", with<EdgeNormalReused>},
      {"ABn of ABC is used again for ADB", "3.2.4", with<ABnReusedForADB>},
      {"face ADB is kept in the wrong order", "3.2.4", with<OrderOfADB>},
      {"the origin in a face of the tetrahedron counts as outside", "3.2.4", with<OriginInFaceSeenOutside>},
  };
  return all;
}

}  // namespace study
