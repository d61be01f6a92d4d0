#include "walkthroughs/text/shell_word.hpp"

#include "tests/catch.hpp"

using walkthroughs::shell_word;

TEST_CASE("A word of a shell is quoted only where it needs to be, and is no option") {
  CHECK(shell_word("out/scene-1.json") == "out/scene-1.json");
  CHECK(shell_word("my scene.json") == "'my scene.json'");
  CHECK(shell_word("it's; rm") == "'it'\\''s; rm'");
  CHECK(shell_word("-rf") == "./-rf");
  CHECK(shell_word("") == "''");
}
