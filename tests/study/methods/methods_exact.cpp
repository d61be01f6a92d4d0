#include "tests/study/methods/methods_of_scalar.hpp"

template std::vector<study::Method> study::methods_of_scalar<study::Exact>(const std::string& scalar_name);
