#include "tests/study/claims/effort.hpp"

#include "core/gjk.hpp"
#include "tests/kit/catch.hpp"
#include "tests/study/pairs/pairs.hpp"

namespace study {

/// A double that counts how often it is multiplied.
struct Counted {
  static inline int multiplications = 0;
  double value = 0;

  Counted() = default;
  Counted(double x) : value(x) {}
  friend Counted operator+(Counted x, Counted y) { return x.value + y.value; }
  friend Counted operator-(Counted x, Counted y) { return x.value - y.value; }
  friend Counted operator-(Counted x) { return -x.value; }
  friend Counted operator*(Counted x, Counted y) {
    ++multiplications;
    return x.value * y.value;
  }
  friend Counted operator/(Counted x, Counted y) { return x.value / y.value; }
  Counted& operator+=(Counted y) { return *this = *this + y; }
  Counted& operator-=(Counted y) { return *this = *this - y; }
  Counted& operator*=(Counted y) { return *this = *this * y; }
  friend bool operator==(Counted x, Counted y) { return x.value == y.value; }
  friend auto operator<=>(Counted x, Counted y) { return x.value <=> y.value; }
};

}  // namespace study

template <>
struct Eigen::NumTraits<study::Counted> : Eigen::NumTraits<double> {
  using Real = study::Counted;
  using NonInteger = study::Counted;
  using Nested = study::Counted;
  using Literal = study::Counted;
};

namespace study {
namespace effort_test {

gjk::PointSet<Counted> set_of(const Body& body) {
  std::vector<gjk::Vec3<Counted>> points;
  for (const Vec& p : std::get<Points>(body)) points.emplace_back(p[0], p[1], p[2]);
  return gjk::PointSet<Counted>(points);
}

/// Counts the dot products of a run: three multiplications each.
struct DotProducts {
  int in_tests = 0, iterations = 0;
  template <class E>
  void operator()(const E&) {}
  void operator()(const gjk::SupportFound<Counted>&) { ++iterations; }
  void operator()(const gjk::RegionTested<Counted>& event) {
    if (event.expression.form == gjk::Expression::Form::dot) ++in_tests;
  }
};

struct Both {
  CrossProducts cross;
  DotProducts dots;
  template <class E>
  void operator()(const E& event) {
    cross(event);
    dots(event);
  }
};

TEST_CASE("Cross products are counted right: six multiplications each and all others belong to dot products",
          "[effort]") {
  for (const char* const name : {"triangles", "tetrahedra"}) {
    const Family& family = family_named(name);
    for (std::uint64_t i = 0; i < 500; ++i) {
      const Pair pair = family.make(3, i);
      const auto a = set_of(pair.a), b = set_of(pair.b);
      Counted::multiplications = 0;
      Both seen;
      gjk::collision<Counted>(a, b, gjk::Options<Counted>{}, seen);
      const auto points = static_cast<int>(a.points().size() + b.points().size());
      const int in_dots = 3 * ((points + 1) * seen.dots.iterations + seen.dots.in_tests);  // 1: w·d
      INFO(name << ", pair " << i);
      REQUIRE(Counted::multiplications - in_dots == 6 * seen.cross.total);
      REQUIRE(seen.cross.most_in_a_3simplex <= 7);
    }
  }
}

}  // namespace effort_test
}  // namespace study
