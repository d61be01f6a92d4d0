#include "tests/study/methods/methods_of_scalar.hpp"

namespace study {

std::vector<Method> double_methods() { return methods_of_scalar<double>("double"); }

}  // namespace study
