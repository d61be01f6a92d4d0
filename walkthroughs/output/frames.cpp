#include "walkthroughs/output/frames.hpp"

#include <algorithm>
#include <cstdio>
#include <set>

#include "render/file.hpp"
#include "render/vector.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/story/alternative_text.hpp"

namespace walkthroughs::output {
namespace {

namespace fs = std::filesystem;

bool in_space(const Walkthrough& walkthrough) {
  return std::ranges::any_of(walkthrough.scenes,
                             [](const Scene& scene) { return scene.dimension == Dimension::space; });
}

}  // namespace

std::string picture_name(std::size_t index, int turn, const char* extension) {
  char name[64];
  std::snprintf(name, sizeof name, "%03zu", index);
  return name + (turn == 0 ? "" : "-turn-" + std::to_string(turn)) + extension;
}

std::vector<std::uint8_t> written_picture(const fs::path& folder, std::size_t index, int turn) try {
  return render::read_file(folder / picture_name(index, turn));
} catch (const render::ReadError& error) {
  throw render::FileError(error.what());
}

int turns_of(const Walkthrough& walkthrough, const Output& output) { return in_space(walkthrough) ? output.turns : 0; }

std::vector<std::string> Frames::files(const Walkthrough&) const {
  std::vector<std::string> files{"###.png", "###-turn-#.png"};
  if (has_svg_) files.insert(files.end(), {"###.svg", "###-turn-#.svg"});
  return files;
}

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
      const render::Canvas frame = renderer.frame(*story, i, turned);
      const std::string png = picture_name(i, turn), svg = picture_name(i, turn, ".svg");
      renderer.write(folder / png, Renderer::png(renderer.draw(frame), text), story, i);
      if (has_svg_)
        renderer.write(
            folder / svg, [bytes = encode_svg(frame, text)] { return bytes; }, story, i);
      written.insert({png, svg});
    }
  }
  renderer.then([=, files = files(w)] { remove_outputs(folder, files, written); });
}

}  // namespace walkthroughs::output
