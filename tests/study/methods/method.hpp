/// A way to ask GJK: rules, scalar and zero test. Together with an iteration limit it is a setting of the study.
#pragma once

#include <cerrno>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/gjk.hpp"
#include "tests/study/methods/question.hpp"

namespace study {

/// How a query ended. Undecided queries are told apart by what stopped them; those that went round count as stopped at the
/// limit, where they would have ended; proofs about points that are computed may leave an answer in doubt.
enum class Answer { intersecting, separated, unusable, at_limit, in_doubt };
inline constexpr std::size_t answers = 5;

struct Outcome {
  Answer answer;
  int iterations;
  int fallback_iterations = 0;  ///< of the second search of a certified query
  int returned =
      0;  ///< at the limit: the iteration that began in a state (simplex and direction) in which an earlier one had begun
};

/// What a method asks with. It is erased here, so that everything downstream is written once.
struct Scalar {
  std::string name;
  bool is_slow;  ///< asked about fewer pairs
  std::optional<RoundedPair> (*rounded)(const Pair& pair);
  std::unique_ptr<Question> (*question)(const Pair& pair);  ///< as question_of()
};

struct Method {
  std::string rules, zero_test;
  Scalar scalar;

  /// Requires of all three: questions that `scalar` has made.
  Outcome (*ask)(const Question& question, int limit);
  /// Returns: the thread's time to ask all of them once; reading its clock once is part of it.
  std::chrono::nanoseconds (*time)(std::span<const Question* const> questions, int limit);

  /// Returns: whether the certificate of its answer says the same and holds, multiplied out in fractions; empty where that
  /// answer has none. Null where none has.
  std::optional<bool> (*certificate_holds)(const Question& question) = nullptr;

  std::string name() const { return rules + " " + scalar.name + " " + zero_test; }
};

// -- How a method is made ---------------------------------------------------------------------------------------------

/// A shape of whatever form, where speed does not matter.
template <class S>
struct AnyForm {
  const Form<S>& form;
  gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const {
    return std::visit([&](const auto& shape) { return shape.support(d); }, form);
  }
};

/// Rules that test the first point, too, begin between the centers.
template <class S, class Rules>
void set_first_direction(gjk::Options<S>& options, const QuestionOf<S>& question) {
  if constexpr (Rules::first_point() == gjk::FirstPoint::tested) options.first_direction = question.between_centers;
}

/// Point sets are asked as users ask them; the choice of the form is made for each support call of other shapes. `options`:
/// become those of the question.
template <class S, class Rules>
gjk::Result<S> result_of(const Question& question, gjk::Options<S>& options) {
  const auto& q = static_cast<const QuestionOf<S>&>(question);
  set_first_direction<S, Rules>(options, q);
  const auto* const a = std::get_if<gjk::PointSet<S>>(&q.a);
  const auto* const b = std::get_if<gjk::PointSet<S>>(&q.b);
  if (a && b) return gjk::collision<S, Rules>(*a, *b, options);
  return gjk::collision<S, Rules>(AnyForm<S>{q.a}, AnyForm<S>{q.b}, options);
}

template <class S>
Answer answer_of(const gjk::Result<S>& result) {
  if (result.status == gjk::Status::intersecting) return Answer::intersecting;
  if (result.status == gjk::Status::separated) return Answer::separated;
  const bool is_stopped = result.reason == gjk::Reason::iteration_limit || result.cycle_start;
  return is_stopped ? Answer::at_limit : Answer::unusable;
}

/// How long this thread has computed: stands still while it waits and while the processor serves others. Errors: std::system_error.
inline std::chrono::nanoseconds thread_time() {
  std::timespec time{};
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) != 0)
    throw std::system_error(errno, std::generic_category(), "the clock of the thread cannot be read");
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// Returns: the thread's time to ask them all once. `ask`: returns the number of iterations.
template <class Ask>
std::chrono::nanoseconds time_of(std::span<const Question* const> questions, const Ask& ask) {
  int iterations = 0;
  const std::chrono::nanoseconds start = thread_time();
  for (const Question* const question : questions) iterations += ask(*question);
  const std::chrono::nanoseconds end = thread_time();
  volatile int used = iterations;  // so that no query is left out as useless
  static_cast<void>(used);
  return end - start;
}

/// The functions behind one method.
template <class S, class Rules>
struct Asking {
  static Outcome ask(const Question& question, int limit) {
    gjk::Options<S> options{.iteration_limit = limit};
    const gjk::Result<S> result = result_of<S, Rules>(question, options);
    const Answer answer = answer_of(result);
    return {answer, result.cycle_start ? limit : result.iterations, 0,
            answer == Answer::at_limit ? first_return(question, options) : 0};
  }

  static std::chrono::nanoseconds time(std::span<const Question* const> questions, int limit) {
    gjk::Options<S> options{.iteration_limit = limit};
    return time_of(questions, [&](const Question& q) { return result_of<S, Rules>(q, options).iterations; });
  }

 private:
  /// Where somebody listens a search ends as soon as it comes back. Returns: 0 where it does not.
  static int first_return(const Question& question, const gjk::Options<S>& options) {
    const auto& q = static_cast<const QuestionOf<S>&>(question);
    const auto listener = [](const auto&) {};
    const auto result = gjk::collision<S, Rules>(AnyForm<S>{q.a}, AnyForm<S>{q.b}, options, listener);
    return result.cycle_start ? result.iterations + 1 : 0;
  }
};

template <class S>
Scalar scalar_called(std::string name) {
  return {std::move(name), std::same_as<S, Exact>, rounded<S>, question_of<S>};
}

template <class S, class Rules>
Method method_of(std::string rules, std::string zero_test, const Scalar& scalar) {
  using A = Asking<S, Rules>;
  return {std::move(rules), std::move(zero_test), scalar, A::ask, A::time};
}

}  // namespace study
