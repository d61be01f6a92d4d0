/// A way to ask GJK: rules, scalar and zero test. Together with an iteration limit it is a setting of the study.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/gjk.hpp"
#include "tests/study/question.hpp"

namespace study {

/// How a query ended. Undecided queries are told apart by what stopped them.
enum class Answer { intersecting, separated, unusable, at_limit };
inline constexpr std::size_t answers = 4;

struct Outcome {
  Answer answer;
  int iterations;
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
  /// Returns: the iteration that began in a state (simplex and direction) in which an earlier one had begun; 0 if none did.
  int (*first_return)(const Question& question, int limit);
  /// Returns: the time to ask all of them once.
  std::chrono::nanoseconds (*time)(std::span<const Question* const> questions, int limit);

  std::string name() const { return rules + " " + scalar.name + " " + zero_test; }
};

// -- How a method is made ---------------------------------------------------------------------------------------------

/// A shape of whatever form, where speed does not matter.
template <class S>
struct AnyShape {
  const Form<S>& form;
  gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const {
    return std::visit([&](const auto& shape) { return shape.support(d); }, form);
  }
};

/// Point sets are asked as users ask them; the choice of the form is made for each support call of other shapes.
template <class S, class Rules>
gjk::Result<S> result_of(const Question& question, const gjk::Options<S>& options) {
  const auto& q = static_cast<const QuestionOf<S>&>(question);
  const auto* const a = std::get_if<gjk::PointSet<S>>(&q.a);
  const auto* const b = std::get_if<gjk::PointSet<S>>(&q.b);
  if (a && b) return gjk::collision<S, Rules>(*a, *b, options);
  return gjk::collision<S, Rules>(AnyShape<S>{q.a}, AnyShape<S>{q.b}, options);
}

template <class S>
gjk::Options<S> limited_to(int limit) {
  gjk::Options<S> options;
  options.iteration_limit = limit;
  return options;
}

template <class S>
Answer answer_of(const gjk::Result<S>& result) {
  if (result.status == gjk::Status::intersecting) return Answer::intersecting;
  if (result.status == gjk::Status::separated) return Answer::separated;
  return result.reason == gjk::Reason::iteration_limit ? Answer::at_limit : Answer::unusable;
}

/// Watches for a state that comes back: from then on the search goes in circles.
template <class S>
class ReturnWatch {
 public:
  int first_return() const { return first_return_; }

  void operator()(const gjk::VertexAdded<S>& event) { simplex_ = event.simplex; }
  void operator()(const gjk::SimplexReduced<S>& event) { simplex_ = event.after; }
  void operator()(const gjk::SupportFound<S>& event) {
    State state{places(), event.direction};
    for (const State& earlier : states_)
      if (first_return_ == 0 && earlier == state) first_return_ = event.iteration;
    states_.push_back(std::move(state));
  }
  template <class E>
  void operator()(const E&) {}

 private:
  struct State {
    std::vector<gjk::Vec3<S>> places;  ///< of the vertices, oldest first
    gjk::Vec3<S> direction;
    bool operator==(const State&) const = default;
  };

  std::vector<gjk::Vec3<S>> places() const {
    std::vector<gjk::Vec3<S>> all;
    for (int i = 0; i < simplex_.size(); ++i) all.push_back(simplex_[i].w);
    return all;
  }

  gjk::Simplex<S> simplex_;
  std::vector<State> states_;
  int first_return_ = 0;
};

/// The functions behind one method.
template <class S, class Rules>
struct Asking {
  static Outcome ask(const Question& question, int limit) {
    const gjk::Result<S> result = result_of<S, Rules>(question, limited_to<S>(limit));
    return {answer_of(result), result.iterations};
  }

  static int first_return(const Question& question, int limit) {
    const auto& q = static_cast<const QuestionOf<S>&>(question);
    ReturnWatch<S> watch;
    gjk::collision<S, Rules>(AnyShape<S>{q.a}, AnyShape<S>{q.b}, limited_to<S>(limit), watch);
    return watch.first_return();
  }

  static std::chrono::nanoseconds time(std::span<const Question* const> questions, int limit) {
    const gjk::Options<S> options = limited_to<S>(limit);
    int iterations = 0;
    const auto start = std::chrono::steady_clock::now();
    for (const Question* const question : questions) iterations += result_of<S, Rules>(*question, options).iterations;
    const auto end = std::chrono::steady_clock::now();
    volatile int used = iterations;  // so that no query is left out as useless
    static_cast<void>(used);
    return end - start;
  }
};

template <class S>
Scalar scalar_called(std::string name) {
  return {std::move(name), std::same_as<S, Exact>, rounded<S>, question_of<S>};
}

template <class S, class Rules>
Method method_of(std::string rules, std::string zero_test, const Scalar& scalar) {
  using A = Asking<S, Rules>;
  return {std::move(rules), std::move(zero_test), scalar, A::ask, A::first_return, A::time};
}

}  // namespace study
