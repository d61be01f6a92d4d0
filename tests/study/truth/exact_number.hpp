/// The number that does not round, computed by another library than the program's, so that neither vouches for itself.
#pragma once

#include <boost/multiprecision/gmp.hpp>

namespace study {

/// Fractions without limit, computed by GMP; every finite float is one. Expression templates are off, because Eigen keeps
/// what a function of the scalar returns.
using Exact = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

}  // namespace study
