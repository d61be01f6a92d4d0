/// One story in one format, for tests: each function returns when its files are written.
#pragma once

#include <functional>

#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/output/sheet.hpp"

namespace walkthroughs::test {

using namespace program;

using FrameTold = std::function<void(const std::filesystem::path& file, std::size_t index)>;

/// Gives the story to a sink that is done with it before the story goes.
inline void write(Sink&& sink, const StagedStory& story, const Output& output, Studio& studio,
                  const Renderer::Written& told) {
  Renderer renderer(studio, told);
  sink.add(std::shared_ptr<const StagedStory>(std::shared_ptr<void>(), &story), output, renderer);
  renderer.finish();
}

inline void render_frames(const StagedStory& story, const Output& output, Studio& studio, const FrameTold& told) {
  write(Frames(), story, output, studio,
        [&](const std::filesystem::path& file, const Story&, std::optional<std::size_t> index) {
          told(file, index.value());
        });
}

/// Returns: the file.
inline std::filesystem::path write_picture(Sink&& format, const StagedStory& story, const Output& output,
                                           Studio& studio) {
  std::filesystem::path file;
  write(std::move(format), story, output, studio,
        [&](const std::filesystem::path& written, const Story&, std::optional<std::size_t>) { file = written; });
  return file;
}

inline std::filesystem::path render_strip(const StagedStory& story, const Output& output, Studio& studio) {
  return write_picture(strip(), story, output, studio);
}

inline std::filesystem::path render_sheet(const StagedStory& story, const Output& output, Studio& studio) {
  return write_picture(sheet(), story, output, studio);
}

}  // namespace walkthroughs::test
