#include "walkthroughs/steps/mistakes.hpp"

#include <bit>

#include "walkthroughs/wrong_on_purpose/rules.hpp"

namespace walkthroughs::steps {
namespace {

namespace wrong_on_purpose = walkthroughs::wrong_on_purpose;

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
  return {result.status, result.iterations, static_cast<int>(result.simplex.size()), noting.way()};
}

template <class Rules>
Processed process(gjk::Simplex<double> simplex) {
  gjk::NobodyListens nobody;
  gjk::detail::Teller<gjk::NobodyListens> tell(nobody, gjk::CrossingTest::on);
  const gjk::Next<double> next = gjk::detail::process<Rules>(simplex, tell);
  if (next.contains_origin()) return {true, simplex};
  return {false, simplex, next.direction()};
}

Mistake mistake_of(const wrong_on_purpose::Description& known) {
  return wrong_on_purpose::with_mistake(known.value, [&]<class Rules>() {
    return Mistake{std::string(known.meaning), std::string(known.section), ask<Rules>, process<Rules>};
  });
}

}  // namespace

Run Mistake::ask(const Set& a, const Set& b) const { return ask_from(usual_first_direction, a, b); }

Run ask_faithfully(const Set& a, const Set& b, const Vec3& first_direction) {
  return steps::ask<gjk::AsIntended>(first_direction, a, b);
}

const std::vector<Mistake>& mistakes() {
  static const std::vector<Mistake> all = [] {
    std::vector<Mistake> list;
    for (const auto& known : wrong_on_purpose::all()) list.push_back(mistake_of(known));
    return list;
  }();
  return all;
}

}  // namespace walkthroughs::steps
