#include "render/file.hpp"

#include <cstdlib>
#include <string>

#include "tests/catch.hpp"

using namespace render;
namespace fs = std::filesystem;

namespace {

/// A folder that disappears with everything in it.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("gjkstep-file-test-" + std::to_string(std::rand()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

const std::vector<std::uint8_t> bytes = {1, 0, 255, 10, 13};

}  // namespace

TEST_CASE("What was written is read, and replaces what was there") {
  const Folder folder;
  const fs::path file = folder.path / "file";
  write_file(file, std::vector<std::uint8_t>(100, 7));
  write_file(file, bytes);
  REQUIRE(read_file(file) == bytes);
  REQUIRE(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("A text is written byte by byte") {
  const Folder folder;
  const fs::path file = folder.path / "file";
  write_file(file, std::string("\x01\0\xFF\n\r", 5));
  REQUIRE(read_file(file) == bytes);
}

TEST_CASE("A file that cannot be written names itself, and the old one stays") {
  const Folder folder;
  fs::create_directories(folder.path / "folder" / "in the way");
  REQUIRE_THROWS_AS(write_file(folder.path / "folder", bytes), FileError);
  REQUIRE_THROWS_AS(write_file(folder.path / "missing" / "file", bytes), FileError);
  REQUIRE(fs::exists(folder.path / "folder" / "in the way"));
  REQUIRE(std::distance(fs::directory_iterator(folder.path), {}) == 1);  // nothing temporary
}

TEST_CASE("A file that is not there cannot be read") {
  const Folder folder;
  REQUIRE_THROWS_AS(read_file(folder.path / "missing"), FileError);
}
