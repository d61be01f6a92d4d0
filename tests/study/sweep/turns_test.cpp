#include "tests/study/sweep/turns.hpp"

#include "tests/kit/catch.hpp"
#include "tests/study/support.hpp"

namespace study::test {
namespace turns_test {

using std::chrono::nanoseconds;

/// What the methods below were asked: one letter and the limit for each batch, in order.
std::string asked;

template <char name>
nanoseconds note(std::span<const Question* const>, int limit) {
  asked += name + std::to_string(limit) + ' ';
  return nanoseconds(100 * limit);
}

Method noting(nanoseconds (*time)(std::span<const Question* const>, int), bool is_slow) {
  Method method = all_methods().front();
  method.time = time;
  method.scalar.is_slow = is_slow;
  return method;
}

TEST_CASE("Methods take turns, warm up unmeasured for each limit and begin with another", "[turns]") {
  const Method quick = noting(note<'q'>, false), slow = noting(note<'s'>, true);
  const Question* const question = nullptr;
  asked.clear();
  times_in_turn({{&quick, {question}}, {&slow, {question}}, {&slow, {}}}, {5, 8});
  const std::string q = "q5 q5 q8 q8 ", s = "s5 s5 s8 s8 ", q_turned = "q8 q8 q5 q5 ", s_turned = "s8 s8 s5 s5 ";
  CHECK(asked == q + s + q_turned + s_turned + q + s + q_turned + q);
}

/// Takes longer each time but for the third, which is the quickest.
nanoseconds tiring(std::span<const Question* const>, int) {
  static int call = 0;
  const int taken[] = {0, 700, 0, 900, 0, 100, 0, 300, 0, 500};  // every other is the pass that is not measured
  return nanoseconds(taken[call++ % 10]);
}

TEST_CASE("Of the turns of a method the median counts", "[turns]") {
  const Method method = noting(tiring, false);
  const Question* const question = nullptr;
  const std::vector<Timings> times = times_in_turn({{&method, {question, question}}}, {20});
  CHECK(times.at(0).at(20).queries == 2);
  CHECK(times.at(0).at(20).nanoseconds == 500);
}

}  // namespace turns_test
}  // namespace study::test
