#include "tests/study/methods/methods_of_scalar.hpp"

namespace study {

std::vector<Method> exact_methods() { return methods_of_scalar<Exact>("exact"); }

}  // namespace study
