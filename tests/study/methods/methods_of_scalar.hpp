/// All methods of one scalar. A source file of its own for each scalar keeps compilation short.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "core/rule_sets.hpp"
#include "tests/study/methods/method.hpp"

namespace study {

/// All sets of rules with each zero test. One with a tolerance means nothing to a scalar that does not round.
template <class S>
std::vector<Method> methods_of_scalar(const std::string& scalar_name) {
  const Scalar scalar = scalar_called<S>(scalar_name);
  std::vector<Method> all;
  const auto add = [&]<class Rules>(std::string_view rules, gjk::ZeroTestKind test) {
    all.push_back(method_of<S, Rules>(std::string(rules), std::string(to_string(test)), scalar));
  };
  using gjk::ZeroTestKind;
  for (const auto& rules : gjk::rule_sets) {
    gjk::with_rules<gjk::ExactZeroTest>(
        rules.value, [&]<class Rules>() { add.template operator()<Rules>(rules.name, ZeroTestKind::exact); });
    if constexpr (std::floating_point<S>)
      gjk::with_rules<gjk::RelativeZeroTest>(
          rules.value, [&]<class Rules>() { add.template operator()<Rules>(rules.name, ZeroTestKind::relative); });
  }
  return all;
}

extern template std::vector<Method> methods_of_scalar<float>(const std::string& scalar_name);
extern template std::vector<Method> methods_of_scalar<double>(const std::string& scalar_name);
extern template std::vector<Method> methods_of_scalar<long double>(const std::string& scalar_name);
extern template std::vector<Method> methods_of_scalar<Exact>(const std::string& scalar_name);
std::vector<Method> certified_methods();  ///< in float and in double

}  // namespace study
