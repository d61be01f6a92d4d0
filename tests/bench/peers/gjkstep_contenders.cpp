#include "tests/bench/peers/gjkstep_call.hpp"

namespace peers {
namespace {

template <class A, class B>
Answer answer(const A& a, const B& b) {
  return asked(a, b);
}
Answer answer(const PointSet& a, const PointSet& b) { return asked_of_point_sets(a, b); }

class Query {
 public:
  explicit Query(const study::Pair& pair) : a_(any_shape(pair.a)), b_(any_shape(pair.b)) {}

  Answer operator()() const {
    return std::visit([](const auto& one, const auto& other) { return answer(one, other); }, a_, b_);
  }

 private:
  AnyShape a_, b_;
};

}  // namespace

std::vector<Contender> gjkstep_contenders() {
  return {{"gjkstep", "`gjk::collision<double>(a, b)`, at most 20 iterations", batch_of<Query>}};
}

}  // namespace peers
