/// A shape of any kind whose points are computed, so that what asks for them is compiled once for all kinds.
#pragma once

#include "core/certified/support_error.hpp"

namespace gjk::test {

/// Refers to the shape.
template <class S>
class AnyDoubtful {
 public:
  template <class A>
  requires(!std::same_as<A, AnyDoubtful> && BoundedShape<A, S>) AnyDoubtful(const A& shape)
      : shape_(&shape), doubt_(gjk_doubt(shape)), near_support_([](const void* any, const Vec3<S>& d) {
          return Vec3<S>(near_support(*static_cast<const A*>(any), d));
        }) {}

  friend SupportError support_error(const AnyDoubtful& s) { return s.doubt_; }
  friend Vec3<S> near_support(const AnyDoubtful& s, const Vec3<S>& d) { return s.near_support_(s.shape_, d); }

 private:
  static SupportError gjk_doubt(const auto& shape) { return support_error(shape); }

  const void* shape_;
  SupportError doubt_;
  Vec3<S> (*near_support_)(const void*, const Vec3<S>&);
};

}  // namespace gjk::test
