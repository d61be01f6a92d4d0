#include "render/rendered_by.hpp"

#include <unistd.h>

#include <filesystem>

#include "render/file.hpp"
#include "tests/kit/catch.hpp"

using namespace render;
namespace fs = std::filesystem;

namespace {

struct Folder {
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  const fs::path path = fs::temp_directory_path() / ("gjkstep-rendered-by-test-" + std::to_string(getpid()));
};

}  // namespace

TEST_CASE("the font is told by its size and its checksum") {
  const Folder folder;
  write_file(folder.path / "DejaVuSans.ttf", "123456789");  // whose CRC-32 is in every description of CRC-32
  const OffscreenContext context(default_backend());
  const RenderedBy notes = rendered_by(context, folder.path);
  CHECK(notes.front() == std::pair<std::string, std::string>{"drawn by", context.description()});
  CHECK(notes.back() == std::pair<std::string, std::string>{"font", "DejaVuSans.ttf, 9 bytes, CRC-32 cbf43926"});
  CHECK_THROWS_AS(rendered_by(context, folder.path / "nowhere"), FileError);
}

TEST_CASE("notes are read as they were written, and what cannot be understood is one line") {
  const Folder folder;
  CHECK_FALSE(read_rendered_by(folder.path).has_value());
  const RenderedBy notes = {{"b", "1"}, {"a", "\"2\""}};
  write_file(folder.path / rendered_by_file, rendered_by_json(notes));
  CHECK(read_rendered_by(folder.path) == notes);
  write_file(folder.path / rendered_by_file, "no notes");
  REQUIRE(read_rendered_by(folder.path).has_value());
  CHECK(read_rendered_by(folder.path)->size() == 1);
}

TEST_CASE("notes stand side by side, those that only one side has included") {
  const std::vector<RenderedByLine> lines = side_by_side({{"a", "1"}, {"b", "2"}}, {{"c", "3"}, {"b", "2"}});
  CHECK(lines == std::vector<RenderedByLine>{{"a", "1", std::nullopt}, {"b", "2", "2"}, {"c", std::nullopt, "3"}});
  CHECK(lines[0].differs());
  CHECK_FALSE(lines[1].differs());
}
