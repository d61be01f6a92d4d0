#include "render/rendered_by.hpp"

#include "render/file.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"

namespace rendered_by_test {

using namespace render;
TEST_CASE("the font is told by its size and its checksum") {
  const kit::Folder folder;
  write_file(folder / "DejaVuSans.ttf", "123456789");  // whose CRC-32 is in every description of CRC-32
  const OffscreenContext context(default_backend());
  const RenderedBy notes = rendered_by(context, folder.path());
  CHECK(notes.front() == std::pair<std::string, std::string>{"drawn by", context.description()});
  CHECK(notes.back() == std::pair<std::string, std::string>{"font", "DejaVuSans.ttf, 9 bytes, CRC-32 cbf43926"});
  CHECK_THROWS_AS(rendered_by(context, folder / "nowhere"), FileError);
}

TEST_CASE("notes are read as they were written, in their order, and may be missing") {
  const kit::Folder folder;
  CHECK_FALSE(read_rendered_by(folder.path()).has_value());
  CHECK_FALSE(read_rendered_by(folder / "nowhere").has_value());
  const RenderedBy notes = {{"b", "1"}, {"a", "\"2\" <&>"}};
  kit::write(folder / rendered_by_file, rendered_by_json(notes));
  CHECK(read_rendered_by(folder.path()) == notes);
}

TEST_CASE("notes that cannot be understood are one line that says so") {
  const kit::Folder folder;
  for (const std::string& text : {std::string(), std::string("{"), std::string("[]"), std::string(R"({"a": 1})"),
                                  std::string("{\"a\": \"\xff\"}"), "{\"a\": \"" + std::string(70'000, 'x') + "\"}"}) {
    INFO(text.substr(0, 20));
    kit::write(folder / rendered_by_file, text);
    const auto notes = read_rendered_by(folder.path());
    REQUIRE(notes);
    REQUIRE(notes->size() == 1);
    CHECK_THAT(notes->front().second, kit::contains(text.size() > 70'000 ? "64 KiB" : "cannot be read"));
  }
}

TEST_CASE("notes stand side by side, those that only one side has included") {
  const std::vector<RenderedByLine> lines = side_by_side({{"a", "1"}, {"b", "2"}}, {{"c", "3"}, {"b", "2"}});
  CHECK(lines == std::vector<RenderedByLine>{{"a", "1", std::nullopt}, {"b", "2", "2"}, {"c", std::nullopt, "3"}});
  CHECK(lines[0].differs());
  CHECK_FALSE(lines[1].differs());
}

}  // namespace rendered_by_test
