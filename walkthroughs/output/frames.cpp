#include "walkthroughs/output/frames.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

#include "render/file.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/story/alternative_text.hpp"

namespace walkthroughs {
namespace {

namespace fs = std::filesystem;

bool in_space(const Walkthrough& walkthrough) {
  return std::ranges::any_of(walkthrough.scenes,
                             [](const Scene& scene) { return scene.dimension == Dimension::space; });
}

}  // namespace

std::string picture_name(std::size_t index, int turn) {
  char name[64];
  if (turn == 0)
    std::snprintf(name, sizeof name, "%03zu.png", index);
  else
    std::snprintf(name, sizeof name, "%03zu-turn-%d.png", index, turn);
  return name;
}

std::vector<std::uint8_t> read_back(const fs::path& file) {
  try {
    return render::read_file(file);
  } catch (const render::ReadError& error) {
    throw render::FileError(error.what());
  }
}

std::vector<std::uint8_t> written_picture(const fs::path& folder, std::size_t index, int turn) {
  return read_back(folder / picture_name(index, turn));
}

int turns_of(const Walkthrough& walkthrough, const Output& output) { return in_space(walkthrough) ? output.turns : 0; }

void Frames::add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
  const Walkthrough& w = story->walkthrough;
  const fs::path folder = folder_of(output, w);
  const std::size_t count = story->frames.size();
  const int turns = turns_of(w, output);
  std::set<std::string> written;
  for (std::size_t i = 0; i < count; ++i) {
    const render::PngText text{w.title + ", step " + std::to_string(i + 1) + " of " + std::to_string(count),
                               alternative_text(*story, i)};
    Output turned = output;
    for (int turn = 0; turn <= turns; ++turn) {
      turned.look.turn = output.look.turn + 360.0 * turn / (turns + 1);
      written.insert(picture_name(i, turn));
      renderer.write(folder / picture_name(i, turn), renderer.draw(*story, i, turned), text,
                     [written = written_, story, i](const fs::path& file) { written(file, *story, i); });
    }
  }
  renderer.then([=, files = files(w), title = w.title] { remove_outputs(folder, files, title, written); });
}

}  // namespace walkthroughs
