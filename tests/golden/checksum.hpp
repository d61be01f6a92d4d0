/// What is too much to keep is kept as a checksum: it tells that something changed, not what.
#pragma once

#include <zlib.h>

#include <functional>
#include <string>
#include <vector>

#include "render/canvas.hpp"

namespace golden {

class Checksum {
 public:
  void add(long number) { add(std::to_string(number) + " "); }
  /// Rounded far below what can be seen of lengths in pixels: the last bits of a sine do not matter.
  void add(double number);
  void add(const std::string& text);
  /// The shapes of a page. Where letters stand in the font's atlas is no part of it.
  void add(const render::Canvas& canvas);

  /// Returns: eight hexadecimal digits.
  std::string text() const;

 private:
  uLong value_ = crc32(0, nullptr, 0);
};

std::string checksum_of(const std::string& text);

/// Whether letters are as wide as those of the accepted pictures. Warns that the test is skipped where another FreeType makes them.
bool letters_are_those_accepted();

/// Checks that the lines of an accepted file are those of now, or accepts them. `in_words` tells what differs in a line.
/// `tests`: what the tests are called that come here.
void check_lines(const std::string& file, const std::vector<std::string>& now, const std::string& tests,
                 const std::function<std::string(std::size_t line, const std::string& accepted)>& in_words);

}  // namespace golden
