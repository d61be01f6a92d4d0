#include "render/utf8.hpp"

#include <string>

#include "tests/kit/catch.hpp"

namespace utf8_test {

using namespace render;

namespace {

/// The code points of `text`; 0 for each byte that is not well-formed.
std::u32string letters_of(std::string_view text) {
  std::u32string all;
  while (!text.empty()) {
    const Letter letter = first_letter(text);
    all += letter.is_well_formed ? letter.code_point : U'\0';
    text.remove_prefix(letter.bytes.size());
  }
  return all;
}

}  // namespace

TEST_CASE("the first and the last letters of each length are written as they are read") {
  const std::u32string letters = U"\u0001\u007F\u0080\u07FF\u0800\uFFFF\U00010000\U0010FFFF";
  std::string bytes;
  for (const char32_t letter : letters) bytes += utf8_of(letter);
  CHECK(bytes.size() == 2 * (1 + 2 + 3 + 4));
  CHECK(letters_of(bytes) == letters);
}

TEST_CASE("the first and the last letters of each length are read") {
  CHECK(letters_of("\x01\x7F") == U"\u0001\u007F");
  CHECK(letters_of("\xC2\x80\xDF\xBF") == U"\u0080\u07FF");
  CHECK(letters_of("\xE0\xA0\x80\xED\x9F\xBF\xEE\x80\x80\xEF\xBF\xBF") == U"\u0800\uD7FF\uE000\uFFFF");
  CHECK(letters_of("\xF0\x90\x80\x80\xF4\x8F\xBF\xBF") == U"\U00010000\U0010FFFF");
}

TEST_CASE("what is no letter is told byte by byte") {
  for (const std::string bad :
       {"\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xED\xBF\xBF", "\xF0\x8F\xBF\xBF",
        "\xF4\x90\x80\x80", "\xF7\xBF\xBF\xBF", "\xF8", "\xFF", "\xC3", "\xE2\x82", "\xF0\x9F\x98"}) {
    CHECK(letters_of(bad) == std::u32string(bad.size(), U'\0'));
    CHECK(letters_of(bad + "a") == std::u32string(bad.size(), U'\0') + U"a");
  }
}

TEST_CASE("letters are taken off the front one by one") {
  std::string_view text = "a\xFF\xC3\xBC";
  CHECK(next_code_point(text) == U'a');
  CHECK(next_code_point(text) == replacement_character);
  CHECK(next_code_point(text) == U'ü');
  CHECK(text.empty());
}

}  // namespace utf8_test
