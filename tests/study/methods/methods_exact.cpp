#include "tests/study/methods/methods_of.hpp"

namespace study {

std::vector<Method> exact_methods() { return methods_of<Exact>("exact"); }

}  // namespace study
