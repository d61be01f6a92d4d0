/// UTF-8, letter by letter.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace render {

inline constexpr char32_t replacement_character = 0xFFFD;

namespace detail {

/// What the first byte of a UTF-8 sequence says.
struct Lead {
  std::size_t length;
  char32_t bits;      // of the code point that the byte carries
  char32_t smallest;  // code point that needs this length: anything below is an overlong form
};

constexpr Lead lead_of(unsigned char byte) {
  if (byte < 0x80) return {1, byte, 0};
  if (byte >= 0xC0 && byte < 0xE0) return {2, byte & 0x1Fu, 0x80};
  if (byte >= 0xE0 && byte < 0xF0) return {3, byte & 0x0Fu, 0x800};
  if (byte >= 0xF0 && byte < 0xF8) return {4, byte & 0x07u, 0x10000};
  return {0, 0, 0};
}

}  // namespace detail

struct Letter {
  std::string_view bytes;
  char32_t code_point;  ///< U+FFFD where it is not well-formed
  bool is_well_formed;
};

/// Returns: the letter that `text` begins with; of malformed bytes one. Requires: text is not empty.
constexpr Letter first_letter(std::string_view text) {
  const detail::Lead lead = detail::lead_of(static_cast<unsigned char>(text.front()));
  const std::string_view sequence = text.substr(0, lead.length);
  char32_t code = lead.bits;
  bool valid = lead.length > 0 && sequence.size() == lead.length;
  for (std::size_t i = 1; i < sequence.size(); ++i) {
    const auto byte = static_cast<unsigned char>(sequence[i]);
    valid = valid && (byte & 0xC0) == 0x80;
    code = code << 6 | (byte & 0x3Fu);
  }
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  valid = valid && code >= lead.smallest && code <= 0x10FFFF && !surrogate;
  return valid ? Letter{sequence, code, true} : Letter{text.substr(0, 1), replacement_character, false};
}

/// Takes the first letter off the front of `text`. Requires: text is not empty.
constexpr char32_t next_code_point(std::string_view& text) {
  const Letter letter = first_letter(text);
  text.remove_prefix(letter.bytes.size());
  return letter.code_point;
}

/// Returns: the bytes of a letter.
inline std::string utf8_of(char32_t code) {
  const auto tail = [&](int shift) { return static_cast<char>(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0 | code >> 6), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0 | code >> 12), tail(6), tail(0)};
  return {static_cast<char>(0xF0 | code >> 18), tail(12), tail(6), tail(0)};
}

}  // namespace render
