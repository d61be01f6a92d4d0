/// UTF-8, letter by letter.
#pragma once

#include <boost/locale/utf.hpp>  // headers alone
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

namespace render {

using Utf8 = boost::locale::utf::utf_traits<char>;

inline constexpr char32_t replacement_character = 0xFFFD;

struct Letter {
  std::string_view bytes;
  char32_t code_point;  ///< U+FFFD where it is not well-formed
  bool is_well_formed;
};

/// Returns: the letter that `text` begins with; of malformed bytes one. Requires: text is not empty.
inline Letter first_letter(std::string_view text) {
  const char* end = text.data();
  const char32_t code = Utf8::decode(end, text.data() + text.size());
  if (!boost::locale::utf::is_valid_codepoint(code)) return {text.substr(0, 1), replacement_character, false};
  return {text.substr(0, static_cast<std::size_t>(end - text.data())), code, true};
}

/// Takes the first letter off the front of `text`. Requires: text is not empty.
inline char32_t next_code_point(std::string_view& text) {
  const Letter letter = first_letter(text);
  text.remove_prefix(letter.bytes.size());
  return letter.code_point;
}

/// Returns: the bytes of a letter.
inline std::string utf8_of(char32_t code) {
  std::string bytes;
  Utf8::encode(code, std::back_inserter(bytes));
  return bytes;
}

}  // namespace render
