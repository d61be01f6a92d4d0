// Pictures of a search ask the objects nothing: but for an outline of the difference, the trace alone is drawn.

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/picture/draw.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

using Calls = std::vector<std::size_t>;

Calls calls_of(const Walkthrough& w) {
  Calls calls;
  for (const Scene& scene : w.scenes) calls.insert(calls.end(), {scene.a.support_calls, scene.b.support_calls});
  return calls;
}

/// Returns: a copy of that walkthrough whose objects have not been asked anything.
Walkthrough unasked(const Walkthrough& original, const Panels& panels) {
  Walkthrough w = original;
  w.panels = panels;
  for (Scene& scene : w.scenes) scene.a.support_calls = scene.b.support_calls = 0;
  return w;
}

/// Returns: the calls of the algorithm itself.
Calls calls_of_search(const Walkthrough& original) {
  const Walkthrough w = unasked(original, {});
  for (const Scene& scene : w.scenes) run(scene);
  return calls_of(w);
}

void draw_all(const StagedStory& story) {
  render::Font font(render::Font::default_directory());
  const Look look;
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    render::Canvas canvas(frame_page, frame_page, look.style.theme.paper, font);
    draw_frame(canvas, story, i, look);
  }
}

bool has_round_objects(const Scene& scene) { return vertices_of(scene.a).empty() || vertices_of(scene.b).empty(); }

}  // namespace

TEST_CASE("The search asks each object once for each point it finds") {
  for (const Walkthrough& w : catalogue()) {
    Calls expected;
    for (const Scene& scene : w.scenes)  // what is certified asks sets of its own
      expected.insert(expected.end(), 2, scene.certified ? 0 : all<gjk::SupportFound>(run(scene)).size());
    CHECK(calls_of_search(w) == expected);
  }
}

TEST_CASE("Without the outline of the difference telling and drawing ask no support function", "[unsanitized]") {
  for (const Walkthrough& original : catalogue()) {
    if (original.layout != Layout::search) continue;
    INFO(original.name);
    const Walkthrough w = unasked(original, {.objects = true, .hull = false, .algorithm = true});
    const StagedStory story(tell(w));
    CHECK(calls_of(w) == calls_of_search(original));
    draw_all(story);
    CHECK(calls_of(w) == calls_of_search(original));
  }
}

TEST_CASE("The outline of the difference asks the support functions of round objects only", "[unsanitized]") {
  for (const Walkthrough& original : catalogue()) {
    if (original.layout != Layout::search) continue;
    INFO(original.name);
    const Walkthrough w = unasked(original, {.objects = true, .hull = true, .algorithm = true});
    draw_all(StagedStory(tell(w)));
    const Calls calls = calls_of(w), of_search = calls_of_search(original);
    CHECK((calls.at(0) > of_search.at(0)) == has_round_objects(w.scenes[0]));
    CHECK((calls.at(1) > of_search.at(1)) == has_round_objects(w.scenes[0]));
  }
}
