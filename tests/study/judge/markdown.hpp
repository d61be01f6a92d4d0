/// Tables in Markdown, and how often something happens in words.
#pragma once

#include <cstdio>
#include <ostream>
#include <string>
#include <vector>

#include "tests/study/judge/rate.hpp"

namespace study {

using Cells = std::vector<std::string>;

inline void row(std::ostream& out, const Cells& cells) {
  for (const std::string& cell : cells) out << "| " << cell << ' ';
  out << "|\n";
}

/// `left`: how many columns, from the first, hold words; the others hold numbers.
inline void heading(std::ostream& out, const Cells& cells, std::size_t left) {
  row(out, cells);
  for (std::size_t i = 0; i < cells.size(); ++i) out << (i < left ? "|---" : "|--:");
  out << "|\n";
}

/// One line, with an empty one after it.
inline void paragraph(std::ostream& out, const std::string& text) { out << text << "\n\n"; }

/// Returns: "0.0031", "3.1e-5", "0".
inline std::string in_short(double value) {
  if (value == 0) return "0";
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  std::string words = text;
  const std::size_t at = words.find("e-0");  // "3.1e-05" is longer than it need be
  return at == std::string::npos ? words : words.erase(at + 2, 1);
}

/// Returns: "0 (< 3.7e-6)", "0.0031 (0.0029 – 0.0033)", with the ends of the 95 % interval; "no pairs" of no trials.
inline std::string in_words(const Rate& rate) {
  if (rate.trials == 0) return "no pairs";
  const Interval interval = rate.interval();
  if (rate.count == 0) return "0 (< " + in_short(interval.high) + ")";
  return in_short(rate.share()) + " (" + in_short(interval.low) + " – " + in_short(interval.high) + ")";
}

}  // namespace study
