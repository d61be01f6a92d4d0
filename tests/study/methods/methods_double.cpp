#include "tests/study/methods/methods_of.hpp"

namespace study {

std::vector<Method> double_methods() { return methods_of<double>("double"); }

}  // namespace study
