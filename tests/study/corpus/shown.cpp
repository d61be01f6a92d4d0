#include "tests/study/corpus/shown.hpp"

#include "tests/study/methods/mistakes.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study {
namespace {

using Set = gjk::PointSet<double>;

bool is_right(const Run& run, Truth truth) {
  return (run.status == gjk::Status::intersecting) == (truth == Truth::intersecting);
}

}  // namespace

Shown shown_by(const Pair& pair) {
  const Set a(std::get<Points>(pair.a)), b(std::get<Points>(pair.b));
  const Truth found = truth(pair);
  Shown shown{std::vector<bool>(mistakes().size()), !is_right(ask_faithfully(a, b), found)};
  if (shown.sound_fails) return shown;
  for (std::size_t i = 0; i < mistakes().size(); ++i) shown.by_mistake[i] = !is_right(mistakes()[i].ask(a, b), found);
  return shown;
}

bool shows(const Pair& pair, std::size_t mistake) {
  const Set a(std::get<Points>(pair.a)), b(std::get<Points>(pair.b));
  const Run with = mistakes()[mistake].ask(a, b), without = ask_faithfully(a, b);
  if ((with.status == gjk::Status::intersecting) == (without.status == gjk::Status::intersecting)) return false;
  return is_right(without, truth(pair));
}

}  // namespace study
