#include <optional>
#include <string>
#include <variant>

#include "core/certified/certified.hpp"
#include "core/certified/check.hpp"
#include "core/certified/grown.hpp"
#include "core/certified/shapes.hpp"
#include "tests/study/methods/methods_of_scalar.hpp"

namespace study {
namespace {

/// What every certified answer tells.
struct Proven {
  gjk::Status status;
  int iterations, fallback_iterations;
};

/// Balls are decided exactly, without telling how often points were looked for; where points are computed an answer may be in
/// doubt.
template <class S>
struct AskingShapes {
  Proven operator()(const auto& a, const auto& b) const {
    if constexpr (requires { gjk::Grown(a), gjk::Grown(b); }) {
      const gjk::GrownResult result = gjk::certified_collision(gjk::Grown(a), gjk::Grown(b));
      return {result.status, result.iterations, 0};
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
  using Set = gjk::PointSet<S>;

  static Outcome ask(const Question& question, int) {
    gjk::Options<S> options;
    const Proven found = proven(question, options);
    return {answer_of(found.status), found.iterations, found.fallback_iterations};
  }

  static std::chrono::nanoseconds time(std::span<const Question* const> questions, int) {
    gjk::Options<S> options;
    return time_of(questions, [&](const Question& question) { return proven(question, options).iterations; });
  }

  static std::optional<bool> certificate_holds(const Question& question) {
    gjk::Options<S> options;
    const auto& q = static_cast<const QuestionOf<S>&>(question);
    const auto *const a = std::get_if<Set>(&q.a), *const b = std::get_if<Set>(&q.b);
    if (!a || !b) return std::nullopt;
    const gjk::CertifiedResult result = result_of(q, *a, *b, options);
    return claim_of(result.certificate) == result.status && holds(result.certificate, *a, *b);
  }

 private:
  static gjk::CertifiedResult result_of(const QuestionOf<S>& question, const Set& a, const Set& b,
                                        gjk::Options<S>& options) {
    set_first_direction<S, Rules>(options, question);
    return gjk::certified_collision<S, Rules>(a, b, options);
  }

  static Proven proven(const Question& question, gjk::Options<S>& options) {
    const auto& q = static_cast<const QuestionOf<S>&>(question);
    const auto *const a = std::get_if<Set>(&q.a), *const b = std::get_if<Set>(&q.b);
    if (!a || !b) return std::visit(AskingShapes<S>(), q.a, q.b);
    const gjk::CertifiedResult result = result_of(q, *a, *b, options);
    return {result.status, result.iterations, result.fallback_iterations};
  }
};

/// Named after the rules of the search that begins.
template <class S>
void add(std::vector<Method>& all, const std::string& scalar_name) {
  for (const gjk::RuleSet first_search : {gjk::RuleSet::as_intended, gjk::RuleSet::eager})
    gjk::with_rules<gjk::ExactZeroTest>(first_search, [&]<class Rules>() {
      using A = AskingCertified<S, Rules>;
      all.push_back({first_search == gjk::RuleSet::eager ? "certified-eager" : "certified", "exact",
                     scalar_called<S>(scalar_name), A::ask, A::time, A::certificate_holds});
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
