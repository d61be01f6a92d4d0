#include "tests/study/methods/methods_of_scalar.hpp"

namespace study {

std::vector<Method> long_double_methods() { return methods_of_scalar<long double>("long-double"); }

}  // namespace study
