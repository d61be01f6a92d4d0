/// The number that does not round. Needs Boost.Multiprecision.
#pragma once

#include "boost_whole_numbers.hpp"

namespace gjk {

/// Fractions without limit. Every finite float is one. Expression templates are off, because Eigen keeps what a
/// function of the scalar returns.
using Fraction =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

}  // namespace gjk
