#include <algorithm>
#include <optional>
#include <thread>

#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/text.hpp"
#include "tests/walkthroughs/output/written.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/output/manifest.hpp"

namespace renderer_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

constexpr render::Size small{64, 36};
const FrameTold nobody = [](const fs::path&, std::size_t) {};
const Renderer::Written told_to_nobody = [](const fs::path&, const Story&, std::optional<std::size_t>) {};

/// Two objects of the plane, drawn as if they were in space.
Walkthrough in_space() {
  Walkthrough w = walkthrough("figure-4-right");
  w.name = "in/space";
  w.scenes[0].dimension = Dimension::space;
  return w;
}

}  // namespace

TEST_CASE("Files are written and reported in the order asked for, whatever their kind and walkthrough") {
  const Folder folder;
  Studio studio;
  std::vector<std::string> files;
  Renderer renderer(studio, [&](const fs::path& file, const Story& story, std::optional<std::size_t> frame) {
    CHECK(fs::exists(file));
    CHECK(file.parent_path().filename() == story.walkthrough.name);
    CHECK((!frame || file.filename() == picture_name(*frame)));
    files.push_back(file.lexically_relative(folder.path()).string());
  });
  Frames frames;
  OneFile animation = animated_png(1, 2), in_a_strip = strip(), on_a_sheet = sheet();
  for (const char* name : {"figure-5", "figure-4-right"}) {
    const auto story = std::make_shared<const StagedStory>(tell(walkthrough(name)));  // here gone before all is written
    for (Sink* sink : std::initializer_list<Sink*>{&frames, &animation, &in_a_strip, &on_a_sheet})
      sink->add(story, {folder.path(), small}, renderer);
  }
  renderer.finish();
  std::vector<std::string> expected;
  for (const auto& [name, frames] : {std::pair{"figure-5", 3}, std::pair{"figure-4-right", 6}}) {
    for (int i = 0; i < frames; ++i) expected.push_back(std::string(name) + "/00" + std::to_string(i) + ".png");
    for (const char* file : {"/animation.png", "/strip.png", "/sheet.png"})
      expected.push_back(std::string(name) + file);
  }
  CHECK(files == expected);
}

TEST_CASE("Views of a scene in space stand beside the frames, in folders of folders, and stale ones go") {
  const Folder folder;
  Studio studio;
  const Walkthrough space = in_space();
  const StagedStory story(tell(space));
  const fs::path own = folder.path() / "in" / "space";
  render_frames(story, {folder.path(), small, {}, 3}, studio, nobody);
  CHECK(listing(own).size() == 4 * story.frames.size());
  for (const std::string& words : {space.title + ", step 1 of 6", plain(story.frames[0].caption)})
    CHECK(kit::has(bytes_of(own / "000.png"), words));  // for readers without the picture
  for (const char* stale : {"006.png", "006-turn-1.png", "007.png", "000-turn-4.png"})
    write_output(own / stale, "stale");
  for (const char* foreign : {"009.png", "000-turn-9.png", "000-turn-x.png", "turn-1.png"})
    kit::write(own / foreign, "mine");
  std::vector<std::string> expected = {"009.png", "000-turn-9.png", "000-turn-x.png", "turn-1.png"};
  for (std::size_t i = 0; i < story.frames.size(); ++i)
    for (const char* view : {".png", "-turn-1.png"}) expected.push_back("00" + std::to_string(i) + view);
  std::ranges::sort(expected);
  render_frames(story, {folder.path(), small, {}, 1}, studio, nobody);
  CHECK(listing(own) == expected);
}

TEST_CASE("A scene in the plane has no further views") {
  const Folder folder;
  Studio studio;
  render_frames(StagedStory(tell(walkthrough("figure-5"))), {folder.path(), small, {}, 5}, studio, nobody);
  CHECK(listing(folder.path()).size() == 3);
}

TEST_CASE("A file that cannot be written is reported once, those before it are there, those after it are not") {
  const Folder folder;
  fs::create_directories(folder.path() / "figure-4-right" / "002.png" / "in the way");
  Studio studio;
  int told = 0;
  std::optional<std::string> error;
  try {
    Renderer renderer(studio, [&](const fs::path&, const Story&, std::optional<std::size_t>) { ++told; });
    for (const char* name : {"figure-4-right", "figure-5"})
      Frames().add(std::make_shared<const StagedStory>(tell(walkthrough(name))), {folder.path(), small}, renderer);
    renderer.finish();
  } catch (const render::FileError& e) {
    error = e.what();
  }
  REQUIRE(error);
  CHECK(error->find("002.png") != std::string::npos);
  CHECK(told == 2);
  CHECK(listing(folder.path()) == std::vector<std::string>{"figure-4-right/000.png", "figure-4-right/001.png"});
}

TEST_CASE("What is asked for waits until there is no more room, is done in order, and no more after an error") {
  Studio studio;
  std::vector<int> done;
  int asked = 0;
  const auto ask = [&](Renderer& renderer) {
    renderer.then([&, i = asked++] {
      if (i == 50) throw render::FileError("disk full");
      done.push_back(i);
    });
  };
  Renderer renderer(studio, told_to_nobody);
  while (asked < 50) ask(renderer);
  const std::size_t most_waiting = 2 + std::max(1u, std::thread::hardware_concurrency());
  CHECK(done.size() + most_waiting == 50);
  ask(renderer);
  ask(renderer);
  CHECK_THROWS_WITH(renderer.finish(), "disk full");
  renderer.finish();
  CHECK(done.size() == 50);
  CHECK(std::ranges::is_sorted(done));
}

TEST_CASE("A renderer that goes before it has finished has written what it was asked for") {
  const Folder folder;
  Studio studio;
  {
    Renderer renderer(studio, told_to_nobody);
    Frames().add(std::make_shared<const StagedStory>(tell(walkthrough("figure-5"))), {folder.path(), small}, renderer);
  }
  CHECK(listing(folder.path()).size() == 3);
}

TEST_CASE("An animation of frames that are not there is an error of writing, not of reading what a user has named") {
  const Folder folder;
  Studio studio;
  const auto add = [&] {
    write(animated_png(1, 2), StagedStory(tell(walkthrough("figure-5"))), {folder.path(), small}, studio,
          told_to_nobody);
  };
  CHECK_THROWS_AS(add(), render::FileError);
  try {
    add();
  } catch (const render::FileError& error) {
    CHECK(dynamic_cast<const render::ReadError*>(&error) == nullptr);
    CHECK(std::string(error.what()).find("000.png") != std::string::npos);
  }
  CHECK_FALSE(fs::exists(folder.path() / "figure-5/animation.png"));
}

}  // namespace renderer_test
