/// All methods of one scalar. A source file of its own for each scalar keeps compilation short.
#pragma once

#include <concepts>
#include <string>
#include <vector>

#include "tests/study/methods/method.hpp"

namespace study {

/// Adds `Rules` with each zero test. A zero test with a tolerance means nothing to a scalar that does not round.
template <class S, template <class> class Rules>
void add(std::vector<Method>& all, const std::string& rules, const Scalar& scalar) {
  all.push_back(method_of<S, Rules<gjk::ExactZeroTest>>(rules, "exact", scalar));
  if constexpr (!std::same_as<S, Exact>)
    all.push_back(method_of<S, Rules<gjk::RelativeZeroTest>>(rules, "relative", scalar));
}

template <class S>
std::vector<Method> methods_of_scalar(const std::string& scalar_name) {
  const Scalar scalar = scalar_called<S>(scalar_name);
  std::vector<Method> all;
  add<S, gjk::Intended>(all, "as-intended", scalar);
  add<S, gjk::Printed>(all, "as-printed", scalar);  // a further variant of the rules is one more line like this
  return all;
}

std::vector<Method> float_methods();
std::vector<Method> double_methods();
std::vector<Method> long_double_methods();
std::vector<Method> exact_methods();

}  // namespace study
