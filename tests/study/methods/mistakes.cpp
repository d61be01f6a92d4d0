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

template <class Rules>
Processed process(gjk::Simplex<double> simplex) {
  gjk::NobodyListens nobody;
  gjk::detail::Teller<gjk::NobodyListens> tell(nobody, gjk::CrossingTest::on);
  const gjk::Next<double> next = gjk::detail::process<Rules>(simplex, tell);
  if (next.contains_origin()) return {true, simplex};
  return {false, simplex, next.direction()};
}

template <class Rules>
gjk::Trace<double> trace(const Vec3& first_direction, const Set& a, const Set& b) {
  gjk::Trace<double> told;
  gjk::collision<double, Rules>(a, b, gjk::Options<double>{.first_direction = first_direction}, told);
  return told;
}

template <class Rules>
Mistake mistake_of(std::string name, std::string section) {
  return {std::move(name), std::move(section), ask<Rules>, process<Rules>, trace<Rules>};
}

}  // namespace

Run Mistake::ask(const Set& a, const Set& b) const { return ask_from(usual_first_direction, a, b); }

Run ask_faithfully(const Set& a, const Set& b, const Vec3& first_direction) {
  return study::ask<gjk::AsIntended>(first_direction, a, b);
}

const std::vector<Mistake>& mistakes() {
  using namespace mistake;
  static const std::vector<Mistake> all{
      mistake_of<WrongSideOfB>("support(B, d) in place of support(B, −d) (Eq. 8)", "2.4"),
      mistake_of<gjk::Eager<>>("the crossing test is applied to the first point, too", "3.1.3"),
      mistake_of<StopsWhereTouched>("<= in place of < in Eq. 9", "3.1.3"),
      mistake_of<gjk::AsPrinted>("the simplex is processed after Eq. 9 has said no (Algorithm 1 as printed)", "3.1.4"),
      mistake_of<OriginAtVertexMissed>("the origin on the first vertex is not recognised", "3.2.1"),
      mistake_of<OriginOnSegmentMissed>("the origin on the segment is not recognised: a search along the zero vector",
                                        "3.2.2"),
      mistake_of<DirectionFromVertex>("the direction is taken from the vertex (AO), not from the edge: ping-pong",
                                      "3.2.2"),
      mistake_of<TriangleNormalReversed>("ABCn of the triangle in the wrong order, and ABn, ACn with it", "3.2.3"),
      mistake_of<TriangleABnInward>("ABn of the triangle points inward", "3.2.3"),
      mistake_of<TriangleACnInward>("ACn of the triangle points inward", "3.2.3"),
      mistake_of<EdgeNormalAsDirection>("ABn, ACn, ADn used as 3D search direction", "3.2.3"),
      mistake_of<TwoDimensionsOnly>("2D only: inside the three edges is inside", "3.2.3"),
      mistake_of<OriginInTriangleMissed>("the origin in the triangle is not recognised", "3.2.3"),
      mistake_of<OrderKeptBelowTriangle>("the order is not changed when moving below the triangle", "3.2.3"),
      mistake_of<ABCnInward>("ABCn of the tetrahedron points inward", "3.2.4"),
      mistake_of<ACDnInward>("ACDn of the tetrahedron points inward", "3.2.4"),
      mistake_of<ADBnInward>("ADBn of the tetrahedron points inward", "3.2.4"),
      mistake_of<EdgeNormalReused>("the edge normals of the face before are used again: ACn for ACD, ADn for ADB",
                                   "3.2.4"),
      mistake_of<ABnReusedForADB>("ABn of ABC is used again for ADB", "3.2.4"),
      mistake_of<OrderOfADB>("face ADB is kept in the wrong order", "3.2.4"),
      mistake_of<OriginInFaceSeenOutside>("the origin in a face of the tetrahedron counts as outside", "3.2.4"),
  };
  return all;
}

}  // namespace study
