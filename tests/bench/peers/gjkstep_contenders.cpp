#include "tests/bench/peers/gjkstep_call.hpp"

namespace peers {
namespace {

template <class Rules, class A, class B>
Answer answer(const A& a, const B& b, const gjk::Options<double>& options) {
  if constexpr (std::same_as<A, PointSet> && std::same_as<B, PointSet>)
    return asked_of_point_sets<Rules>(a, b, options);
  else if constexpr (AreCertified<Rules>)
    return Answer::not_asked;
  else
    return asked<Rules>(a, b, options);
}

gjk::Options<double> by_default(const study::Pair&) { return {}; }

gjk::Options<double> between_centers(const study::Pair& pair) {
  return {.first_direction = gjk::first_direction_between(center(pair.a), center(pair.b))};
}

/// The centers of points are their means, as gjk::PointSet computes them.
gjk::Options<double> inside(const study::Pair& pair) {
  return {.inside = gjk::PointOfEach<double>{center(pair.a), center(pair.b)}};
}

template <class Rules, auto options_for = by_default>
class Query {
 public:
  explicit Query(const study::Pair& pair) : a_(any_shape(pair.a)), b_(any_shape(pair.b)), options_(options_for(pair)) {}

  Answer operator()() const {
    return std::visit([&](const auto& one, const auto& other) { return answer<Rules>(one, other, options_); }, a_, b_);
  }

 private:
  AnyShape a_, b_;
  gjk::Options<double> options_;
};

}  // namespace

std::vector<Contender> gjkstep_contenders() {
  return {
      {.name = "gjkstep",
       .how = "`gjk::collision<double>(a, b)`, the plain call: at most 20 iterations",
       .prepare = batch_of<Query<gjk::AsIntended>>,
       .is_peer = false},
      {.name = "gjkstep eager",
       .how = "`gjk::collision<double, gjk::Eager<>>(a, b, options)`, which starts from one center to the other and "
              "tests the first point. MPR is told the centers, too.",
       .prepare = batch_of<Query<gjk::Eager<>, between_centers>>,
       .is_peer = false},
      {.name = "gjkstep inside",
       .how = "`gjk::collision<double>(a, b, options)`, the plain call that starts with the difference of the centers",
       .prepare = batch_of<Query<gjk::AsIntended, inside>>,
       .is_peer = false},
      {.name = "gjkstep relative",
       .how = "`gjk::collision<double, gjk::Intended<gjk::RelativeZeroTest>>(a, b)`, the plain call with the relative "
              "zero test",
       .prepare = batch_of<Query<Relative>>,
       .is_peer = false},
      {.name = "gjkstep certified",
       .how = "`gjk::certified_collision(a, b)`, the plain call with an answer that is proven; sets of points only",
       .prepare = batch_of<Query<Certified<gjk::AsIntended>>>,
       .is_peer = false,
       .proves = "gjkstep"},
      {.name = "gjkstep certified eager",
       .how = "`gjk::certified_collision<double, gjk::Eager<>>(a, b, options)`, the eager call with an answer that is "
              "proven; sets of points only",
       .prepare = batch_of<Query<Certified<gjk::Eager<>>, between_centers>>,
       .is_peer = false,
       .proves = "gjkstep eager"},
      {.name = "gjkstep certified inside",
       .how = "`gjk::certified_collision(a, b, options)`, which starts inside, with an answer that is proven; sets of "
              "points only",
       .prepare = batch_of<Query<Certified<gjk::AsIntended>, inside>>,
       .is_peer = false,
       .proves = "gjkstep inside"}};
}

}  // namespace peers
