#include <string>

#include "core/certificate_check.hpp"
#include "core/certified.hpp"
#include "tests/study/methods/certified.hpp"
#include "tests/study/methods/methods_of_scalar.hpp"

namespace study {
namespace {

template <class S>
struct Sets {
  const gjk::PointSet<S>*a, *b;  ///< null where the shape is another
};

template <class S>
Sets<S> sets_of(const Question& question) {
  const auto& q = static_cast<const QuestionOf<S>&>(question);
  return {std::get_if<gjk::PointSet<S>>(&q.a), std::get_if<gjk::PointSet<S>>(&q.b)};
}

/// The functions behind one method, as in Asking.
template <class S, class Rules>
struct AskingCertified {
  static bool can_ask(const Question& question) {
    const Sets<S> sets = sets_of<S>(question);
    return sets.a && sets.b;
  }

  static Outcome ask(const Question& question, int) {
    gjk::Options<S> options;
    const gjk::CertifiedResult result = result_of(question, options);
    return {result.status == gjk::Status::intersecting ? Answer::intersecting : Answer::separated, result.iterations,
            result.second_iterations};
  }

  static int first_return(const Question&, int) { return 0; }

  static std::chrono::nanoseconds time(std::span<const Question* const> questions, int) {
    gjk::Options<S> options;
    int iterations = 0;
    const std::chrono::nanoseconds start = thread_time();
    for (const Question* const question : questions) iterations += result_of(*question, options).iterations;
    const std::chrono::nanoseconds end = thread_time();
    volatile int used = iterations;  // so that no query is left out as useless
    static_cast<void>(used);
    return end - start;
  }

  static bool certificate_holds(const Question& question) {
    gjk::Options<S> options;
    const gjk::CertifiedResult result = result_of(question, options);
    const Sets<S> sets = sets_of<S>(question);
    return claim_of(result.certificate) == result.status && holds(result.certificate, *sets.a, *sets.b);
  }

 private:
  static gjk::CertifiedResult result_of(const Question& question, gjk::Options<S>& options) {
    set_first_direction<S, Rules>(options, static_cast<const QuestionOf<S>&>(question));
    const Sets<S> sets = sets_of<S>(question);
    return gjk::certified_collision<S, Rules>(*sets.a, *sets.b, options);
  }
};

template <class S>
void add(std::vector<Method>& all, const std::string& scalar_name) {
  for (const CertifiedRules& rules : certified_rules)
    gjk::with_rules<gjk::ExactZeroTest>(rules.first_search, [&]<class Rules>() {
      using A = AskingCertified<S, Rules>;
      all.push_back({std::string(rules.name), "exact", scalar_called<S>(scalar_name), A::ask, A::first_return, A::time,
                     A::can_ask, A::certificate_holds});
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
