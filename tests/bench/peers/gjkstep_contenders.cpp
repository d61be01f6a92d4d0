#include "tests/bench/peers/gjkstep_call.hpp"

namespace peers {
namespace {

template <class Rules, class A, class B>
Answer answer(const A& a, const B& b) {
  if constexpr (std::same_as<A, PointSet> && std::same_as<B, PointSet>)
    return asked_of_point_sets<Rules>(a, b);
  else
    return asked<Rules>(a, b);
}

template <class Rules>
class Query {
 public:
  explicit Query(const study::Pair& pair) : a_(any_shape(pair.a)), b_(any_shape(pair.b)) {}

  Answer operator()() const {
    return std::visit([](const auto& one, const auto& other) { return answer<Rules>(one, other); }, a_, b_);
  }

 private:
  AnyShape a_, b_;
};

}  // namespace

std::vector<Contender> gjkstep_contenders() {
  return {
      {.name = "gjkstep",
       .how = "`gjk::collision<double>(a, b)`, the plain call: at most 20 iterations",
       .prepare = batch_of<Query<gjk::AsIntended>>,
       .is_peer = false},
      {.name = "gjkstep relative",
       .how =
           "`gjk::collision<double, gjk::Intended<gjk::RelativeZeroTest>>(a, b)`, the same with the relative zero test",
       .prepare = batch_of<Query<Relative>>,
       .is_peer = false}};
}

}  // namespace peers
