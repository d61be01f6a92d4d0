/// Numbers, vectors and expressions as captions print them, in the letters of the picture.
///
/// The events speak of roles (A is the newest vertex), the pictures of places (A … G, the corners of the hull). `Letters`
/// translates: in a triangle of E, A and the newest vertex G, the event's "ABn·AO" is the caption's "GE_n·GO".
#pragma once

#include <string>
#include <string_view>

#include "walkthroughs/hull.hpp"
#include "walkthroughs/moment.hpp"

namespace walkthroughs {

/// Returns: at most eight significant digits, with a true minus sign; never "-0".
std::string number(double value);

/// Returns: "(x, y)", for vectors of the plane z = 0 in which the scenes lie.
std::string vector(const Point& value);

/// Returns: "(x, y, z)".
std::string vector_in_space(const Point& value);

/// The names of the vertices of one simplex.
class Letters {
 public:
  Letters(const Simplex& simplex, const LabelledHull& hull);

  /// Returns: `text` with every word made of the roles A, B, C, D and of O translated, and the n of a normal set as a subscript.
  std::string translate(std::string_view text) const;

  /// Returns: the names of a feature such as "AB", in alphabetical order.
  std::string feature(std::string_view roles) const;

 private:
  std::string names_[4];  // by role
};

/// Returns: "[A, E]", oldest first as the report lists a simplex.
std::string list_of_names(const Simplex& simplex, const LabelledHull& hull);

/// Returns: `text` without markup, for files and terminals.
std::string plain(std::string_view text);

}  // namespace walkthroughs
