/// What each setting costs on pairs of one's own, and how often it is wrong about them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/query/query_options.hpp"

namespace walkthroughs::query {

/// One way to ask.
struct Setting {
  std::string scalar, rules;  ///< as on the command line; the rules of certified answers are "certified"
  bool is_certified = false;  ///< never wrong, whatever the pairs
};

/// What a setting has done with the pairs of a file.
struct Measured {
  Setting setting;
  std::size_t pairs = 0;                            ///< it was asked about these
  double nanoseconds = 0;                           ///< a pair, the median of rounds in which all settings take turns
  std::size_t found_together = 0, found_apart = 0;  ///< of those that are apart, and together
  std::size_t undecided = 0;
  double iterations = 0;  ///< a pair, in the mean

  std::size_t not_right() const { return found_together + found_apart + undecided; }
};

struct Measurement {
  bool fit_floats = true;               ///< whether all numbers may be floats; else these are not asked
  std::size_t pairs = 0, together = 0;  ///< those of which the truth is known
  std::size_t unknown = 0;              ///< nothing can be proven about these; they are left out
  std::size_t not_exact = 0;            ///< of `pairs`, those that exact numbers cannot be asked about
  std::vector<Measured> settings = {};
};

/// Returns: nothing but the measurement of the pairs of a text, one a line. Beside the text it keeps some thousand pairs at a
/// time. All are judged; the first hundred thousand are timed. Exact numbers are asked about few: they take a thousand times as
/// long. `query`: start, iteration limit and zero test.
/// Errors: InputError about the first line that is wrong, or a text without pairs.
Measurement measure(std::string_view text, const std::string& file_name, const QueryOptions& query);

/// Returns: a table to read, and which settings to choose.
std::string table_of(const Measurement& measurement);
/// Returns: the same numbers, a line a setting.
std::string csv_of(const Measurement& measurement);

}  // namespace walkthroughs::query
