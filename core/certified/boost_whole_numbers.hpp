/// The whole numbers of Boost.Multiprecision.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <type_traits>

// Boost asks of each operand whether it is a container of bytes, by what its const_iterator points to. Eigen's expressions that
// cannot be walked through have void for one, of which libc++ knows no traits.
namespace boost::multiprecision::detail {
template <class C>
requires std::is_void_v<typename C::const_iterator>
struct is_byte_container_imp<C, true> : std::false_type {
};
}  // namespace boost::multiprecision::detail
