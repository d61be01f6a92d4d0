/// Lines of CSV files.
#pragma once

#include <cstddef>
#include <sstream>
#include <string>

#include "tests/study/sweep/tally.hpp"

namespace study {

struct Csv {
  std::string name, text;
};

/// Returns: the fields with commas between, and the end of the line.
template <class... Fields>
std::string csv_line(const Fields&... fields) {
  std::ostringstream text;
  ((text << fields << ','), ...);
  std::string all = text.str();
  all.back() = '\n';
  return all;
}

/// Returns: "4:1000 5:20" where 1000 took 4 and 20 took 5.
inline std::string csv_text(const Histogram& histogram) {
  std::string text;
  for (std::size_t k = 0; k < histogram.size(); ++k)
    if (histogram[k] > 0) text += (text.empty() ? "" : " ") + std::to_string(k) + ':' + std::to_string(histogram[k]);
  return text;
}

}  // namespace study
