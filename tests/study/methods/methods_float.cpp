#include "tests/study/methods/methods_of_scalar.hpp"

namespace study {

std::vector<Method> float_methods() { return methods_of_scalar<float>("float"); }

}  // namespace study
