#include "tests/study/oracle.hpp"

#include <stdexcept>

#include "tests/study/linear_program.hpp"
#include "tests/study/oracle_cgal.hpp"
#include "tests/study/oracle_round.hpp"

namespace study {
namespace {

struct Judge {
  Truth operator()(const Points& a, const Points& b) const {
    if (const auto found = truth_by_cgal(a, b)) return *found;
    return truth_by_linear_program(a, b);
  }

  Truth operator()(const Ball& a, const Ball& b) const { return truth_of_round(a, b); }
  Truth operator()(const Ball& a, const Can& b) const { return truth_of_round(a, b); }
  Truth operator()(const Can& a, const Ball& b) const { return truth_of_round(b, a); }
  Truth operator()(const Can& a, const Can& b) const { return truth_of_round(a, b); }

  template <class A, class B>
  Truth operator()(const A&, const B&) const {
    throw std::invalid_argument("the oracle cannot judge a round body against a hull of points");
  }
};

}  // namespace

Truth truth(const Pair& pair) { return std::visit(Judge{}, pair.a, pair.b); }

}  // namespace study
