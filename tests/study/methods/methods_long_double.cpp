#include "tests/study/methods/methods_of.hpp"

namespace study {

std::vector<Method> long_double_methods() { return methods_of<long double>("long-double"); }

}  // namespace study
