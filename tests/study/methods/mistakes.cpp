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

template <class Rules>
Run ask(const Vec3& first_direction, const Set& a, const Set& b) {
  const Noting noting(a);
  const auto result =
      gjk::collision<double, Rules>(noting, b, gjk::Options<double>{.first_direction = first_direction});
  return {result.status, result.iterations, noting.way()};
}

}  // namespace

Run Mistake::ask(const Set& a, const Set& b) const { return ask_from(usual_first_direction, a, b); }

Run ask_faithfully(const Set& a, const Set& b, const Vec3& first_direction) {
  return study::ask<gjk::AsIntended>(first_direction, a, b);
}

const std::vector<Mistake>& mistakes() {
  using namespace mistake;
  static const std::vector<Mistake> all{
      {"support(B, d) in place of support(B, −d) (Eq. 8)", "2.4", ask<WrongSideOfB>},
      {"the crossing test is applied to the first point, too", "3.1.3", ask<gjk::Eager<>>},
      {"<= in place of < in Eq. 9", "3.1.3", ask<StopsWhereTouched>},
      {"the simplex is processed after Eq. 9 has said no (Algorithm 1 as printed)", "3.1.4", ask<gjk::AsPrinted>},
      {"the origin on the first vertex is not recognised", "3.2.1", ask<OriginAtVertexMissed>},
      {"the origin on the segment is not recognised: a search along the zero vector", "3.2.2",
       ask<OriginOnSegmentMissed>},
      {"the direction is taken from the vertex (AO), not from the edge: ping-pong", "3.2.2", ask<DirectionFromVertex>},
      {"ABCn of the triangle in the wrong order, and ABn, ACn with it", "3.2.3", ask<TriangleNormalReversed>},
      {"ABn of the triangle points inward", "3.2.3", ask<TriangleABnInward>},
      {"ACn of the triangle points inward", "3.2.3", ask<TriangleACnInward>},
      {"ABn, ACn, ADn used as 3D search direction", "3.2.3", ask<EdgeNormalAsDirection>},
      {"2D only: inside the three edges is inside", "3.2.3", ask<TwoDimensionsOnly>},
      {"the origin in the triangle is not recognised", "3.2.3", ask<OriginInTriangleMissed>},
      {"the order is not changed when moving below the triangle", "3.2.3", ask<OrderKeptBelowTriangle>},
      {"ABCn of the tetrahedron points inward", "3.2.4", ask<ABCnInward>},
      {"ACDn of the tetrahedron points inward", "3.2.4", ask<ACDnInward>},
      {"ADBn of the tetrahedron points inward", "3.2.4", ask<ADBnInward>},
      {"the edge normals of the face before are used again: ACn for ACD, ADn for ADB", "3.2.4", ask<EdgeNormalReused>},
      {"ABn of ABC is used again for ADB", "3.2.4", ask<ABnReusedForADB>},
      {"face ADB is kept in the wrong order", "3.2.4", ask<OrderOfADB>},
      {"the origin in a face of the tetrahedron counts as outside", "3.2.4", ask<OriginInFaceSeenOutside>},
  };
  return all;
}

}  // namespace study
