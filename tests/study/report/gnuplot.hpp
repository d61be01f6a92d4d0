/// Words that all pictures say to gnuplot.
#pragma once

#include <string>

#include "tests/study/sweep/settings.hpp"

namespace study {

/// Returns: the command that begins a picture of that size in pixels.
inline std::string canvas(int width, int height) {
  return "set terminal pngcairo size " + std::to_string(width) + "," + std::to_string(height) +
         " noenhanced background rgb 'white' font 'DejaVu Sans,11'\nset encoding utf8\n";
}

/// As canvas(), of at most 256 colours and without smooth lines: a quarter of the bytes, for areas and words.
inline std::string flat_canvas(int width, int height) {
  return "set terminal png size " + std::to_string(width) + "," + std::to_string(height) +
         " noenhanced background rgb 'white' font 'DejaVu Sans,11'\nset encoding utf8\n";
}

/// Returns: the text as gnuplot reads it. A line feed would end the text, and what follows would be a command.
inline std::string in_quotes(const std::string& text) {
  std::string inside;
  for (const char c : text) inside += c == '\'' ? "''" : std::string(1, static_cast<unsigned char>(c) < 0x20 ? ' ' : c);
  return "'" + inside + "'";
}

/// Returns: how the data were made.
inline std::string small_print(const Settings& settings) {
  const Header& header = settings.study().header;
  return header.command + "; " + header.compiler;
}

/// Colours that colour-blind readers tell apart as well (Okabe and Ito). They never stand alone.
inline constexpr const char* blue = "'#0072B2'";
inline constexpr const char* vermilion = "'#D55E00'";
inline constexpr const char* orange = "'#E69F00'";
inline constexpr const char* green = "'#009E73'";
inline constexpr const char* purple = "'#CC79A7'";

}  // namespace study
