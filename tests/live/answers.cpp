// Answers each line of standard input as the program in a page does (live.hpp). With the word "requests": prints what the test asks
// of both, a line each; of scenes that are good, and of such as are not.
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "render/json_text.hpp"
#include "tests/kit/dice.hpp"
#include "tests/walkthroughs/trace/random_scene_files.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/live/live.hpp"
#include "walkthroughs/model/exact_shape.hpp"
#include "walkthroughs/model/truth.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/text/scene_text.hpp"

namespace {

using Json = nlohmann::ordered_json;
using namespace walkthroughs::live;

constexpr int random_scenes = 100, damaged_scenes = 1000;

void ask(const std::string& key, const Json& what) { std::cout << render::json_text(Json{{key, what}}) << '\n'; }

void ask_for_walkthroughs() {
  for (const walkthroughs::model::Walkthrough& w : whole_catalogue()) {
    ask("tell", {{"name", w.name}});
    const std::size_t count = tell(w).frames.size();
    for (std::size_t frame = 0; frame < count; ++frame) ask("draw", {{"frame", frame}});
    ask("draw", {{"frame", count / 2},
                 {"theme", "dark"},
                 {"text", 1.5},
                 {"height", 700},
                 {"stacked", count % 2 == 0},
                 {"turn", 40},
                 {"rise", 20},
                 {"zoom", 2}});
  }
}

/// Whether what is said of the truth differs: cylinders that doubles find so near to contact that long doubles are asked, of which
/// there are 80 bits here and 128 in a page. Of other objects fractions tell.
bool asks_long_doubles(const std::string& text) {
  if (text.find("cylinder") == std::string::npos) return false;
  const auto [file, complaint] = walkthroughs::text::scene_in(text, "scene.json");
  if (complaint) return false;
  const walkthroughs::model::Scene& scene = file.walkthrough.scenes.front();
  return is_near_contact(a_as_read(scene), b_as_read(scene), walkthroughs::model::Scalar::binary64);
}

/// While one drags, each like a step of the one before.
void ask_for_random_scenes() {
  walkthroughs::test::RandomSceneFiles files(20261128);
  for (int i = 0; i < random_scenes; ++i) {
    const std::string scene = files.next_without_sines().text;
    if (asks_long_doubles(scene)) continue;
    ask("tell", {{"scene", scene}, {"like", 7}, {"brief", i % 2 == 1}});
    ask("hold", i % 3 == 0);
    ask("draw", {{"frame", 7}});
  }
}

/// One byte less, another one, or cut off.
std::string damaged(std::string text, kit::Dice& dice) {
  const auto at = static_cast<std::size_t>(dice.between(0, static_cast<int>(text.size()) - 1));
  switch (dice.between(0, 2)) {
    case 0: text.resize(at); break;
    case 1: text.erase(at, 1); break;
    default: text[at] = "\"{}[],:-0e. \nx"[dice.between(0, 13)];
  }
  return text;
}

void ask_for_bad_scenes() {
  kit::Dice dice(20261128);
  walkthroughs::test::RandomSceneFiles files(20261128);
  for (int i = 0; i < damaged_scenes; ++i) {
    const std::string good = i % 2 == 0 ? walkthroughs::text::example_scene() : files.next_without_sines().text;
    if (const std::string bad = damaged(good, dice); !asks_long_doubles(bad)) ask("tell", {{"scene", bad}});
  }
}

}  // namespace

int main(int count, char** words) {
  if (count > 1 && std::string_view(words[1]) == "requests") {
    ask_for_walkthroughs();
    ask_for_random_scenes();
    ask_for_bad_scenes();
    return 0;
  }
  render::Font font(render::Font::default_directory());
  Live live(font);
  for (std::string request; std::getline(std::cin, request);) std::cout << live.answer(request) << '\n';
}
