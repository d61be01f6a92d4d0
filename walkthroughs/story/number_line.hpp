/// What rounding may have made, beside what it is to decide: a number line, to scale.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

struct NumberLine {
  struct Number {
    std::string name;  ///< with markup
    std::string text;  ///< of its value
    double value = 0;
    bool is_exact = false;

    std::string equation() const;  ///< "−P·d = 10.19"
  };
  std::vector<Number> numbers;  ///< the first is what was computed
  double low = 0, high = 0;     ///< between these rounding may have put it
  std::string meaning;          ///< of what is between, "±7.1e−16: …"
};

/// Returns: that of the proof or of the sign which the frame is about; nothing where there is none, or where its numbers are
/// beyond doubles. What is between `low` and `high` holds zero: of a proof it lies around zero, of a sign around the value.
std::optional<NumberLine> number_line(const Moment& now, Focus focus, const Names& names);

/// Returns: "−P·d", by the names of pictures, in which the point w that was found along d is P.
std::string name_of(const gjk::FilterValue& number, const Names& names);

/// The same of a sign: "E·d" where the point has that name, "the largest P·d", of ABn·AO also the face in whose plane ABn is.
std::string name_of(const gjk::SignTaken<double>& sign, const Names& names);

/// Returns: what is seen there, a sentence.
std::string in_words(const NumberLine& line);

}  // namespace walkthroughs::story
