/// Whatever a scene file holds: it is read and can be run and told, or it is turned away with a InputError.
///
///     cmake -S . -B build/fuzz -G Ninja -DGJKSTEP_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++
///     ninja -C build/fuzz scene-file-fuzz
///     sh tests/fuzz/words.sh tests/fuzz/scenes > build/fuzz/words.dict
///     mkdir -p build/fuzz/found
///     build/fuzz/scene-file-fuzz -dict=build/fuzz/words.dict -max_len=4096 -timeout=10 -rss_limit_mb=512
///         build/fuzz/found tests/fuzz/scenes
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "walkthroughs/text/scene_file.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const walkthroughs::text::SceneFile file = walkthroughs::text::parse_scene(text, "fuzz.json");
    require(file.walkthrough.scenes.size() == 1 && !walkthroughs::text::summary(file).empty());
    std::ostringstream out;
    walkthroughs::trace::write_traces(out, file.walkthrough);
    require(out.good());
  } catch (const walkthroughs::text::InputError& error) {
    require(std::string_view(error.what()).starts_with("fuzz.json:"));
  }
  return 0;
}
