/// Numbers that are not rounded, and how they are told.
#pragma once

#include <string>

#include "core/certified/dyadic.hpp"
#include "core/certified/fraction.hpp"
#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::story {

using ExactVector = gjk::Vec3<gjk::Fraction>;

/// What is compared without rounding; what is told of it are fractions.
using ExactPoint = gjk::detail::Triple<gjk::detail::Dyadic>;

inline ExactPoint exact(const Point& p) { return {p.x(), p.y(), p.z()}; }

/// As number() of words.hpp, for numbers that no double holds, too.
std::string number(const gjk::Fraction& x);
/// Returns: to six digits, and in any case to a hundredth.
std::string place(const gjk::Fraction& x);
/// Returns: "(x, y)", in space "(x, y, z)"; `text` writes each.
std::string vector(const ExactVector& v, Dimension dimension, std::string (*text)(const gjk::Fraction&) = number);
/// Returns: the length of a vector, whatever its size.
std::string length(const ExactVector& v);

/// Returns: a fraction, "-3/2", as it is where it is short, and else "≈ 3.08e−33".
std::string short_fraction(const std::string& fraction);

/// Returns: infinite, or 0, where it is beyond doubles.
double nearest_double(const std::string& fraction);

}  // namespace walkthroughs::story
