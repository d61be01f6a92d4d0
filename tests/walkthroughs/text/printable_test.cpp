#include "walkthroughs/text/printable.hpp"

#include <cstdint>
#include <initializer_list>

#include "tests/kit/catch.hpp"

namespace printable_test {

using namespace walkthroughs::program;

TEST_CASE("What is not printable is shown as an escape, and the rest as it is") {
  CHECK(printable("plain, größe, ∞ 𝄞 'quoted' \\") == "plain, größe, ∞ 𝄞 'quoted' \\");
  CHECK(printable(std::string("\x1b[31m\r\n\t\0\x7f", 10)) == "\\x1b[31m\\x0d\\x0a\\x09\\x00\\x7f");
  CHECK(printable("a\u202eb\u2066c\u200fd\u061ce\ufefff\u0085") == "a\\u202eb\\u2066c\\u200fd\\u061ce\\ufefff\\u0085");
  CHECK(printable("a\u00adb\u200bc\u2060d\u2064e\u200cf") == "a\\u00adb\\u200bc\\u2060d\\u2064e\\u200cf");
  CHECK(printable("\u206a\u180e\u3164\ufffb\U000e0001") == "\\u206a\\u180e\\u3164\\ufffb\\U000e0001");
  CHECK(printable("\xff\xc3(\xed\xa0\x80\xe2\x80") == "\\xff\\xc3(\\xed\\xa0\\x80\\xe2\\x80");
}

TEST_CASE("What cannot be seen by itself is not printable, and words may have what shapes letters") {
  for (const char32_t hidden : std::initializer_list<char32_t>{
           0x0085,  0x00AD,  0x070F,  0x115F,  0x17B4,  0x180E,  0x200B,  0x2028,  0x2065,
           0x206A,  0x206F,  0x3164,  0xFDD0,  0xFFA0,  0xFFF9,  0xFFFB,  0xFFFF,  0x1343F,
           0x1BCA0, 0x1D173, 0xE0001, 0xE0020, 0xE007F, 0xE00FF, 0xE01F0, 0xE0FFF, 0x10FFFE}) {
    INFO(std::uint32_t(hidden));
    CHECK_FALSE(is_printable(hidden));
    CHECK_FALSE(is_part_of_words(hidden));
  }
  for (const char32_t shaping :
       std::initializer_list<char32_t>{0x034F, 0x180B, 0x180F, 0x200C, 0x200D, 0xFE00, 0xFE0F, 0xE0100, 0xE01EF}) {
    INFO(std::uint32_t(shaping));
    CHECK_FALSE(is_printable(shaping));
    CHECK(is_part_of_words(shaping));
  }
  for (const char32_t seen : std::initializer_list<char32_t>{0x0020, 0x00A0, 0x0601, 0x0915, 0x200A, 0x2010, 0x2070,
                                                             0x3163, 0xFFFC, 0xFFFD, 0x1F600}) {
    INFO(std::uint32_t(seen));
    CHECK(is_printable(seen));
    CHECK(is_part_of_words(seen));
  }
}

TEST_CASE("The first byte that is not UTF-8 is found") {
  CHECK_FALSE(first_not_utf_8("").has_value());
  CHECK_FALSE(first_not_utf_8("größe 𝄞").has_value());
  CHECK(first_not_utf_8("ü\xff") == 2);
  CHECK(first_not_utf_8("ab\xe2\x80") == 2);
  CHECK(first_not_utf_8("\xc0\x80") == 0);          // overlong
  CHECK(first_not_utf_8("\xf4\x90\x80\x80") == 0);  // beyond U+10FFFF
}

TEST_CASE("Quotes hold 40 letters at most, whatever their bytes") {
  CHECK(in_quotes("") == "''");
  CHECK(in_quotes("\x1b") == "'\\x1b'");
  std::string letters;
  for (int i = 0; i < 40; ++i) letters += "ü";
  CHECK(in_quotes(letters) == "'" + letters + "'");
  CHECK(in_quotes(letters + "x") == "'" + letters + "…'");
}

TEST_CASE("A message is one line, and its overlong words lack their middle") {
  CHECK(message_line("/there/a b: is\nbad; mend it") == "/there/a b: is\\x0abad; mend it");
  const std::string front(200, 'a'), back(80, 'z');
  CHECK(message_line("at " + front + back + ": no") == "at " + front.substr(1) + "…" + back.substr(1) + ": no");
  CHECK(message_line(front + back + " no") == front + back + " no");
  CHECK(message_line(front + std::string(5000, 'm') + back + " no") == front + "…" + back + " no");
}

TEST_CASE("Missing letters that would not show are named by their codes alone") {
  CHECK(missing_letters({0x1, 0x85, 0x2067}) ==
        "the font has no sign for U+0001, U+0085, U+2067: boxes stand in their place");
}

}  // namespace printable_test
