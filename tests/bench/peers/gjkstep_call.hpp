/// This project's calls: no observer, doubles, at most 20 iterations.
#pragma once

#include "core/certified/certified.hpp"
#include "core/gjk.hpp"
#include "tests/bench/peers/contender.hpp"
#include "tests/bench/peers/shapes.hpp"

namespace peers {

using Relative = gjk::Intended<gjk::RelativeZeroTest>;

/// In place of rules: these, asked by gjk::certified_collision(), which is about sets of points only.
template <class Rules_>
struct Certified {
  using Rules = Rules_;
};
template <class Rules>
concept AreCertified = requires {
  typename Rules::Rules;
};

inline Answer answer_of(gjk::Status status) {
  switch (status) {
    case gjk::Status::intersecting: return Answer::intersecting;
    case gjk::Status::separated: return Answer::separated;
    case gjk::Status::undecided: break;
  }
  return Answer::undecided;
}

template <class Rules, class A, class B>
Answer asked(const A& a, const B& b, const gjk::Options<double>& options) {
  if constexpr (AreCertified<Rules>)
    return answer_of(gjk::certified_collision<double, typename Rules::Rules>(a, b, options).status);
  else
    return answer_of(gjk::collision<double, Rules>(a, b, options).status);
}

/// Each compiled by itself, as in a program whose shapes are all of one kind: among nine kinds of pairs the compiler would share
/// the rules between them in place of inlining them.
template <class Rules>
Answer asked_of_point_sets(const PointSet& a, const PointSet& b, const gjk::Options<double>& options);

}  // namespace peers
