#include "walkthroughs/program/missing_letters.hpp"

#include "tests/kit/catch.hpp"

using walkthroughs::missing_letters;

TEST_CASE("Missing letters are named with their codes, marks that would not show by these alone") {
  CHECK(missing_letters({0x6F22, 0x5B57}) ==
        "the font has no sign for 字 (U+5B57), 漢 (U+6F22): boxes stand in their place");
  CHECK(missing_letters({0x1F9CA}) == "the font has no sign for 🧊 (U+1F9CA): a box stands in its place");
  CHECK(missing_letters({0x1, 0x85, 0x2067}) ==
        "the font has no sign for U+0001, U+0085, U+2067: boxes stand in their place");
}

TEST_CASE("Of many missing letters the first are named, and how many more there are") {
  std::set<char32_t> codes;
  for (char32_t code = 0x4E00; code < 0x4E00 + 20; ++code) codes.insert(code);
  const std::string text = missing_letters(codes);
  CHECK(text.find("(U+4E07) and 12 more: boxes") != std::string::npos);
  CHECK(text.find("U+4E08") == std::string::npos);
}
