// gjkstep render --apng, --movie, --turn: pictures that move.

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/storyboard.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

/// Returns: how often `part` stands in `text`.
int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

bool there_is(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// Returns: what a command for the shell prints.
std::string printed_by(const std::string& command) {
  const Folder folder;
  const std::string file = (folder.path() / "stdout").string();
  CHECK(std::system(("( " + command + " ) >" + quoted(file)).c_str()) == 0);
  return bytes_of(file);
}

}  // namespace

TEST_CASE("gjkstep render --apng writes an animation of all frames, the last one shown longer") {
  const Folder folder;
  const Outcome outcome =
      run("render figure-5 --apng --frame-time 0.5 --turn 2 --size 64x36 --out " + quoted(folder.path().string()));
  CHECK(outcome.exit_code == 0);
  const fs::path own = folder.path() / "figure-5", animation = own / "animation.png";
  CHECK(listing(own) ==
        std::vector<std::string>{"000.png", "001.png", "002.png", "animation.png"});  // no views: planar
  REQUIRE(lines(outcome.out).size() == 4);
  CHECK(lines(outcome.out)[3].starts_with(animation.string() + "  "));
  CHECK(render::read_png(animation) == render::read_png(own / "000.png"));
  const std::string bytes = bytes_of(animation);
  CHECK(count(bytes, "fcTL") == 3);
  CHECK(count(bytes, std::string("\x01\xF4\x03\xE8", 4)) == 2);  // 500/1000 s
  CHECK(count(bytes, std::string("\x03\xE8\x03\xE8", 4)) == 1);  // 1000/1000 s
}

TEST_CASE("gjkstep render --movie prints a line for ffmpeg for each walkthrough, after the files") {
  const Folder folder;
  const fs::path out = folder.path() / "it's 100% mine";
  const std::string arguments = "render figure-5 figure-4-right --frame-time 0.4 --size 33x35 --theme dark --out ";
  const std::string shell_out = "'" + folder.path().string() + "/it'\\''s 100% mine";
  for (const std::string kind : {"mp4", "gif"}) {
    const Outcome outcome = run(arguments + shell_out + "' --movie " + kind);
    CHECK(outcome.exit_code == 0);
    const std::vector<std::string> printed = lines(outcome.out);
    REQUIRE(printed.size() == 3 + 6 + 2);
    for (const std::size_t i : {9u, 10u}) {
      const std::string name = i == 9 ? "figure-5" : "figure-4-right";
      CHECK(printed[i].starts_with("ffmpeg -y "));
      CHECK(has(printed[i], " -framerate 1000/400 "));
      CHECK(has(printed[i], "/it'\\''s 100%% mine/" + name + "/%03d.png'"));
      CHECK(printed[i].ends_with("/it'\\''s 100% mine/" + name + "/animation." + kind + "'"));
      CHECK(has(printed[i], kind == "gif" ? "palettegen" : "color=0x16191f"));
      if (there_is("ffmpeg")) {
        CHECK(printed_by(printed[i]).empty());
        CHECK(fs::file_size(out / name / ("animation." + kind)) > 0);
      }
    }
  }
  if (!there_is("ffmpeg") || !there_is("ffprobe")) return;
  const std::string probe = "ffprobe -v error -show_entries stream=width,height,pix_fmt:format=duration -of csv=p=0 ";
  const std::string mp4 = printed_by(probe + shell_out + "/figure-5/animation.mp4'");
  CHECK(has(mp4, "34,36,yuv420p"));
  CHECK(has(mp4, "1.6"));  // three frames, the last one twice as long
  CHECK(has(printed_by(probe + shell_out + "/figure-5/animation.gif'"), "1.6"));
}

TEST_CASE("gjkstep render --turn adds views of frames in space, and removes those of an earlier run with more") {
  const auto& all = catalogue();
  const auto space = std::ranges::find_if(
      all, [](const Walkthrough& w) { return !w.scenes.empty() && w.scenes[0].dimension == Dimension::space; });
  REQUIRE(space != all.end());
  const Folder folder;
  const fs::path own = folder.path() / space->name;
  const std::string command = "render " + space->name + " --size 160x90 --out " + quoted(folder.path().string());
  const std::size_t frames = tell(*space).frames.size();
  for (const int turns : {3, 1, 0}) {
    CHECK(run(command + " --turn " + std::to_string(turns)).exit_code == 0);
    CHECK(listing(own).size() == frames * static_cast<std::size_t>(1 + turns));
    for (int turn = 1; turn <= turns; ++turn) {
      const fs::path view = own / ("000-turn-" + std::to_string(turn) + ".png");
      REQUIRE(fs::exists(view));
      CHECK(render::read_png(view) != render::read_png(own / "000.png"));
    }
  }
}
