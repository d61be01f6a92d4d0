#include "tests/study/truth/oracle.hpp"

#include <stdexcept>

#include "tests/study/truth/linear_program.hpp"
#include "tests/study/truth/oracle_cgal.hpp"
#include "tests/study/truth/oracle_round.hpp"

namespace study {
namespace {

struct Judge {
  Judgement operator()(const Points& a, const Points& b) const {
    if (const auto found = truth_by_cgal(a, b)) return {*found, Proof::predicates};
    return {truth_by_linear_program(a, b), Proof::certificate};
  }

  Judgement operator()(const Ball& a, const Ball& b) const { return {truth_of_round(a, b), Proof::formulas}; }
  Judgement operator()(const Ball& a, const Can& b) const { return {truth_of_round(a, b), Proof::formulas}; }
  Judgement operator()(const Can& a, const Ball& b) const { return {truth_of_round(b, a), Proof::formulas}; }
  Judgement operator()(const Can& a, const Can& b) const { return {truth_of_round(a, b), Proof::formulas}; }

  template <class A, class B>
  Judgement operator()(const A&, const B&) const {
    throw std::invalid_argument("the oracle cannot judge a round body against a hull of points");
  }
};

}  // namespace

Judgement judge(const Pair& pair) { return std::visit(Judge{}, pair.a, pair.b); }

}  // namespace study
