#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "core/certificate_check.hpp"
#include "core/certified.hpp"
#include "core/certified_balls.hpp"
#include "core/certified_shapes.hpp"
#include "tests/study/methods/certified.hpp"
#include "tests/study/methods/methods_of_scalar.hpp"

namespace study {
namespace {

/// What every certified answer tells.
struct Proven {
  gjk::Status status;
  int iterations, second_iterations;
};

/// Balls are decided exactly, without telling how often points were looked for; where points are computed an answer may be in
/// doubt.
template <class S>
struct AskingShapes {
  Proven operator()(const auto& a, const auto& b) const {
    if constexpr (requires { gjk::certified_status(a, b); }) {
      return {gjk::certified_status(a, b), 0, 0};
    } else {
      const gjk::ShapesResult result = gjk::certified_shapes<S>(a, b);
      return {result.status, result.iterations, 0};
    }
  }
};

Answer answer_of(gjk::Status status) {
  if (status == gjk::Status::undecided) return Answer::in_doubt;
  return status == gjk::Status::intersecting ? Answer::intersecting : Answer::separated;
}

/// The functions behind one method, as in Asking.
template <class S, class Rules>
struct AskingCertified {
  static Outcome ask(const Question& question, int) {
    gjk::Options<S> options;
    const Proven found = proven(question, options);
    return {answer_of(found.status), found.iterations, found.second_iterations};
  }

  static int first_return(const Question&, int) { return 0; }

  static std::chrono::nanoseconds time(std::span<const Question* const> questions, int) {
    gjk::Options<S> options;
    int iterations = 0;
    const std::chrono::nanoseconds start = thread_time();
    for (const Question* const question : questions) iterations += proven(*question, options).iterations;
    const std::chrono::nanoseconds end = thread_time();
    volatile int used = iterations;  // so that no query is left out as useless
    static_cast<void>(used);
    return end - start;
  }

  static std::optional<bool> certificate_holds(const Question& question) {
    gjk::Options<S> options;
    const auto [a, b] = sets_of(question);
    if (!a || !b) return std::nullopt;
    const gjk::CertifiedResult result = result_of(question, *a, *b, options);
    return claim_of(result.certificate) == result.status && holds(result.certificate, *a, *b);
  }

 private:
  using Set = gjk::PointSet<S>;

  static const QuestionOf<S>& in_scalar(const Question& question) {
    return static_cast<const QuestionOf<S>&>(question);
  }

  /// Returns: null where the shape is another.
  static std::pair<const Set*, const Set*> sets_of(const Question& question) {
    const QuestionOf<S>& q = in_scalar(question);
    return {std::get_if<Set>(&q.a), std::get_if<Set>(&q.b)};
  }

  static gjk::CertifiedResult result_of(const Question& question, const Set& a, const Set& b,
                                        gjk::Options<S>& options) {
    set_first_direction<S, Rules>(options, in_scalar(question));
    return gjk::certified_collision<S, Rules>(a, b, options);
  }

  static Proven proven(const Question& question, gjk::Options<S>& options) {
    if (const auto [a, b] = sets_of(question); a && b) {
      const gjk::CertifiedResult result = result_of(question, *a, *b, options);
      return {result.status, result.iterations, result.second_iterations};
    }
    const QuestionOf<S>& q = in_scalar(question);
    return std::visit(AskingShapes<S>(), q.a, q.b);
  }
};

template <class S>
void add(std::vector<Method>& all, const std::string& scalar_name) {
  for (const CertifiedRules& rules : certified_rules)
    gjk::with_rules<gjk::ExactZeroTest>(rules.first_search, [&]<class Rules>() {
      using A = AskingCertified<S, Rules>;
      all.push_back({std::string(rules.name), "exact", scalar_called<S>(scalar_name), A::ask, A::first_return, A::time,
                     A::certificate_holds});
    });
}

}  // namespace

std::vector<Method> certified_methods() {
  std::vector<Method> all;
  add<float>(all, "float");
  add<double>(all, "double");
  return all;
}

}  // namespace study
