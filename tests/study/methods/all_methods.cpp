#include "tests/study/methods/all_methods.hpp"

#include "tests/study/methods/methods_of_scalar.hpp"

namespace study {

const std::vector<Method>& all_methods() {
  static const std::vector<Method> all = [] {
    std::vector<Method> list;
    for (const auto some : {float_methods, double_methods, long_double_methods, exact_methods, certified_methods})
      for (Method& method : some()) list.push_back(std::move(method));
    return list;
  }();
  return all;
}

}  // namespace study
