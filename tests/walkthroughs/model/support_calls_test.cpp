// Pictures of a search ask the objects nothing: but for an outline of the difference, the trace alone is drawn.

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/picture/draw.hpp"

namespace support_calls_test {

using namespace walkthroughs::program;
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

}  // namespace

TEST_CASE("The search asks each object once for each point it finds") {
  for (const Walkthrough& w : whole_catalogue()) {
    Calls expected;
    for (const Scene& scene : w.scenes)  // what is certified asks sets of its own
      expected.insert(expected.end(), 2, scene.certified ? 0 : all<gjk::SupportFound>(run(scene)).size());
    CHECK(calls_of_search(w) == expected);
  }
}

TEST_CASE("Telling and drawing ask support functions for an outline of the difference of round objects only",
          "[unsanitized][full]") {
  for (const Walkthrough& original : whole_catalogue()) {
    if (original.layout != Layout::search) continue;
    INFO(original.name);
    const Calls of_search = calls_of_search(original);
    const Walkthrough without = unasked(original, {.hull = false}), with = unasked(original, {});
    draw_all(StagedStory(tell(without)));
    CHECK(calls_of(without) == of_search);
    draw_all(StagedStory(tell(with)));
    const Scene& scene = with.scenes[0];
    const bool is_round = vertices_of(scene.a).empty() || vertices_of(scene.b).empty();
    for (std::size_t i : {0u, 1u}) CHECK((calls_of(with).at(i) > of_search.at(i)) == is_round);
  }
}

}  // namespace support_calls_test
