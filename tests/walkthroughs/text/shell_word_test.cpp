
#include <algorithm>

#include "tests/kit/catch.hpp"
#include "tests/kit/program.hpp"
#include "walkthroughs/text/printable.hpp"

namespace shell_word_test {

using walkthroughs::text::printable;
using walkthroughs::text::shell_word;

TEST_CASE("A word of a shell is quoted only where it needs to be, and is no option") {
  CHECK(shell_word("out/scene-1.json") == "out/scene-1.json");
  CHECK(shell_word("azAZ09") == "azAZ09");
  CHECK(shell_word("my scene.json") == "'my scene.json'");
  CHECK(shell_word("it's; rm") == "'it'\\''s; rm'");
  CHECK(shell_word("-rf") == "./-rf");
  CHECK(shell_word("") == "''");
}

TEST_CASE("A word of a shell has nothing that a terminal would act upon, and a shell makes it what it was") {
  CHECK(shell_word("a\x1b[31m") == R"-('a'"$(printf '\033')"'[31m')-");
  for (const std::string name :
       {"\x1b]0;x\x07", "o\xff", "\xff\xfe", "a\u202eb", "\U000e0041", "it's \r", "größe", "a\nb"}) {
    const std::string word = shell_word(name);
    INFO(word);
    std::string shown = word;
    std::erase(shown, '\n');
    CHECK(printable(shown) == shown);
    CHECK(kit::shell("printf %s " + word).out == name);
  }
}

}  // namespace shell_word_test
