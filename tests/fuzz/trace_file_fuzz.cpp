/// Whatever a trace holds: it is read, told and laid out, or it is turned away
/// with a InputError that names the line.
///
///     cmake -S . -B build/fuzz -G Ninja -DGJKSTEP_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++
///     ninja -C build/fuzz trace-file-fuzz
///     sh tests/fuzz/words.sh tests/fuzz/traces > build/fuzz/words.dict
///     mkdir -p build/fuzz/found-traces
///     build/fuzz/trace-file-fuzz -dict=build/fuzz/words.dict -max_len=20480 -timeout=10 -rss_limit_mb=512
///         build/fuzz/found-traces tests/fuzz/traces
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "render/canvas.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/trace/trace_file.hpp"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

void lay_out(const walkthroughs::picture::StagedStory& story, std::size_t frame, render::Font& font) {
  const walkthroughs::picture::Look look{.style = walkthroughs::picture::Style(render::themes::report)};
  render::Canvas canvas({64, 36}, walkthroughs::picture::frame_page, look.style.theme.paper, font);
  walkthroughs::picture::draw_frame(canvas, story, frame, look);
  require(!walkthroughs::story::alternative_text(story, frame).empty());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static render::Font font(render::Font::default_directory());
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const walkthroughs::trace::TraceFile file = walkthroughs::trace::parse_trace(text, "fuzz.jsonl");
    require(file.traces.size() == file.walkthrough.scenes.size());
    const walkthroughs::picture::StagedStory story(walkthroughs::story::tell(file.walkthrough, file.traces));
    require(!story.frames.empty());
    lay_out(story, 0, font);
    lay_out(story, story.frames.size() - 1, font);
  } catch (const walkthroughs::text::InputError& error) {
    const std::string_view said = error.what();
    require(said.starts_with("fuzz.jsonl:") && said.size() < 2000);
    require('1' <= said[11] && said[11] <= '9');
  }
  return 0;
}
