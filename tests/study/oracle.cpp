#include "tests/study/oracle.hpp"

#include <stdexcept>

namespace study {

Truth truth(const Pair&) { throw std::invalid_argument("the oracle cannot judge this pair"); }

}  // namespace study
