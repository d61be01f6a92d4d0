#include "tests/golden/random_searches.hpp"

#include <array>

#include "tests/kit/json.hpp"
#include "tests/walkthroughs/trace/random_scene_files.hpp"
#include "walkthroughs/text/scene_file.hpp"

namespace golden {
namespace {

using namespace walkthroughs::program;

constexpr unsigned seed = 17;
constexpr int count = 120;

std::string name_of(int i) {
  const std::string digits = std::to_string(i);
  return "random/" + std::string(3 - digits.size(), '0') + digits;
}

/// The scene with other panels, of every sixth.
std::string with_panels(const std::string& scene, int i) {
  constexpr std::array choices{R"(["hull", "close-up"])", R"(["objects", "decision", "close-up"])", R"([])",
                               R"(["algorithm"])", R"(["objects", "hull", "algorithm"])"};
  if (i % 6 != 2) return scene;
  kit::Json changed = kit::Json::parse(scene);
  changed["panels"] = kit::Json::parse(choices[static_cast<std::size_t>(i / 6 % 5)]);
  return changed.dump();
}

RandomSearch search(const std::string& original, int i) {
  const std::string scene = with_panels(original, i);
  RandomSearch search{.name = name_of(i),
                      .scene = scene,
                      .options = {},
                      .walkthrough = parse_scene(scene, "random.json").walkthrough,
                      .look = {}};
  const auto add = [&](const std::string& option) {
    search.options += (search.options.empty() ? "--" : " --") + option;
  };
  render::Theme theme = std::array{render::themes::report, render::themes::slides, render::themes::dark}[i % 3U];
  if (i % 3 > 0) add(i % 3 == 1 ? "theme slides" : "theme dark");
  if (i % 10 == 0) theme.text = 0.75, add("text-scale 0.75");
  if (i % 10 == 5) theme.text = 1.5, add("text-scale 1.5");
  search.look.style = Style(theme);
  if (i % 4 == 1) search.look.text = Text::none, add("no-captions");
  if (i % 4 == 3) search.walkthrough.naming = Naming::fixed, add("letters fixed");
  if (i % 11 == 10) search.look.values = false, add("no-values");
  if (i % 14 == 13) search.detail = Detail::iteration, add("detail iteration");
  return search;
}

}  // namespace

const std::vector<RandomSearch>& random_searches() {
  static const std::vector<RandomSearch> all = [] {
    walkthroughs::test::RandomSceneFiles files(seed);
    std::vector<RandomSearch> list;
    for (int i = 0; i < count; ++i) list.push_back(search(files.next_without_sines().text, i));
    return list;
  }();
  return all;
}

}  // namespace golden
