// An implementation of the report with one mistake of the study, or with none: the program that the judge's tests judge.
//
//     GJKSTEP_MISTAKE=18 judged-mistake     # 0: without
#include "point_set.hpp"
#include "tests/study/methods/mistakes.hpp"

bool collide(const judge::Points& a, const judge::Points& b) {
  static const std::size_t number = std::stoul(std::getenv("GJKSTEP_MISTAKE"));
  const study::Run run = number == 0 ? study::ask_faithfully(set_of(a), set_of(b))
                                     : study::mistakes().at(number - 1).ask(set_of(a), set_of(b));
  return run.status == gjk::Status::intersecting;  // at its limit Algorithm 1 says no
}
