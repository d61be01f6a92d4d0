#include "walkthroughs/program/missing_letters.hpp"

#include "tests/kit/catch.hpp"

using walkthroughs::missing_letters;

TEST_CASE("Missing letters that would not show are named by their codes alone") {
  CHECK(missing_letters({0x1, 0x85, 0x2067}) ==
        "the font has no sign for U+0001, U+0085, U+2067: boxes stand in their place");
}
