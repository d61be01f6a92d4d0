#include "walkthroughs/text/names.hpp"

#include "tests/kit/catch.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace names_test {

using namespace walkthroughs::program;

TEST_CASE("The name of a scene can name a folder that is seen, whatever its file is called") {
  CHECK(name_from_file("a/b/Tank_2-x.1.json") == "Tank_2-x.1");
  CHECK(name_from_file("two words;rm -rf ~.json") == "two-words-rm--rf--");
  CHECK(name_from_file("Zürich.json") == "Zürich");
  CHECK(name_from_file("場面.json") == "場面");
  CHECK(name_from_file("a\u00A0b\u3000c\u202Ed\xFF.json") == "a-b-c-d-");
  CHECK(name_from_file("line\nbreak.json") == "line-break");
  CHECK(name_from_file("_.json") == "_");
  CHECK(name_from_file(".s") == "s");
  CHECK(name_from_file("..s.json") == "s");
  CHECK(name_from_file(std::string(250, 'x') + ".json") == std::string(200, 'x'));
  std::string umlauts = "x";
  for (int i = 0; i < 121; ++i) umlauts += "ü";
  CHECK(name_from_file(umlauts + ".json") == umlauts.substr(0, 199));  // no half letter
  for (const char* const file : {"..", ".", "", "/", "...json"}) CHECK(name_from_file(file) == "scene");
}

TEST_CASE("A title made from the file's name can be drawn, whatever the file is called") {
  CHECK(title_from_file("a/two words.json") == "two words");
  CHECK(title_from_file("my_scene-2.json") == "my scene-2");
  CHECK(title_from_file("__two___words _.json") == "two words");
  CHECK(title_from_file("Zürich.json") == "Zürich");
  CHECK(title_from_file("line\nbreak.json") == "line-break");
  CHECK(title_from_file("\xE2\x80\xAExyz.json") == "-xyz");
  CHECK(title_from_file("\xFF.json") == "-");
  CHECK(title_from_file(".s") == ".s");
  CHECK(title_from_file(std::string(200, 'x') + ".json").size() == scene_limits::title);
  std::string umlauts;
  for (int i = 0; i < 121; ++i) umlauts += "ü";
  CHECK(title_from_file(umlauts + ".json") == umlauts.substr(2));
  for (const char* const file : {"_", " _ .json", "", ".."}) CHECK_FALSE(title_from_file(file).empty());
  CHECK(title_from_file(" _ .json") == "scene");
}

TEST_CASE("What is made from a file's name is what traces may have, letter by letter") {
  for (int c = 1; c < 256; ++c)
    for (const std::string& stem : {std::string(1, static_cast<char>(c)), std::string("x") + static_cast<char>(c),
                                    std::string(".") + static_cast<char>(c), std::string(250, static_cast<char>(c))}) {
      const std::string file = stem + ".json";
      INFO(printable(file));
      CHECK(objection_to_name(name_from_file(file)).empty());
      CHECK(objection_to_words(title_from_file(file), scene_limits::title).empty());
    }
}

TEST_CASE("A name lies in its folder, is seen there, and is as long as said") {
  for (const char* const name : {"a", "_", "-", "regions/2-simplex-r3", "a.b", "a/b/c.", "ä/場面", "..."})
    CHECK(objection_to_name(name).empty() == (std::string(name) != "..."));
  for (const char* const name :
       {"", " ", ".", "..", ".a", "/a", "a/", "a//b", "a/../b", "a/.b", "a b", "a\u00A0b", "a\u200Bb", "a\nb", "a\\b"})
    CHECK_FALSE(objection_to_name(name).empty());
  CHECK(objection_to_name(std::string(scene_limits::walkthrough, 'x')).empty());
  CHECK(objection_to_name(std::string(scene_limits::walkthrough + 1, 'x')) == "has 201 characters; shorten it to 200");
  std::string wide;
  for (int i = 0; i < 101; ++i) wide += "ü";
  CHECK(objection_to_name(wide) == "has 202 bytes; shorten it to 200");
  CHECK(objection_to_words("a\u202Eb\tc", 9) == "has U+202E, which cannot be shown; leave it out");
}

}  // namespace names_test
