#include "tests/study/methods/all_methods.hpp"

#include "tests/study/methods/methods_of_scalar.hpp"

namespace study {

const std::vector<Method>& all_methods() {
  static const std::vector<Method> all = [] {
    std::vector<Method> list;
    for (auto some :
         {methods_of_scalar<float>("float"), methods_of_scalar<double>("double"),
          methods_of_scalar<long double>("long-double"), methods_of_scalar<Exact>("exact"), certified_methods()})
      list.insert(list.end(), some.begin(), some.end());
    return list;
  }();
  return all;
}

}  // namespace study
