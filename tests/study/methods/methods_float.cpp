#include "tests/study/methods/methods_of.hpp"

namespace study {

std::vector<Method> float_methods() { return methods_of<float>("float"); }

}  // namespace study
