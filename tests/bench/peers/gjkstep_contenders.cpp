#include "core/gjk.hpp"
#include "tests/bench/peers/contender.hpp"
#include "tests/bench/peers/shapes.hpp"

namespace peers {
namespace {

/// The plain call: no observer, doubles, every option as it is by default.
class Query {
 public:
  explicit Query(const study::Pair& pair) : a_(any_shape(pair.a)), b_(any_shape(pair.b)) {}

  Answer operator()() const {
    const PointSet *a = std::get_if<PointSet>(&a_), *b = std::get_if<PointSet>(&b_);
    if (a && b) return ask(*a, *b);
    return std::visit([](const auto& one, const auto& other) { return ask(one, other); }, a_, b_);
  }

 private:
  template <class A, class B>
  static Answer ask(const A& a, const B& b) {
    switch (gjk::collision<double>(a, b).status) {
      case gjk::Status::intersecting: return Answer::intersecting;
      case gjk::Status::separated: return Answer::separated;
      case gjk::Status::undecided: break;
    }
    return Answer::undecided;
  }

  AnyShape a_, b_;
};

}  // namespace

std::vector<Contender> gjkstep_contenders() {
  return {{"gjkstep", "`gjk::collision<double>(a, b)`, at most 20 iterations", batch_of<Query>}};
}

}  // namespace peers
