#include "tests/golden/pictures.hpp"

#include <algorithm>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace golden {

using walkthroughs::picture::Text;

namespace {

constexpr render::Size pixels{640, 360};
constexpr Text around = Text::around, none = Text::none;
constexpr Letters drawn = Letters::drawn, left_out = Letters::left_out;

}  // namespace

const std::vector<Picture>& pictures() {
  static const std::vector<Picture> all = {
      // The report's figures
      {"figure-1", 0, "report", around, left_out,
       "circles, a disk, a crescent made of polygons, the chords that decide"},
      {"figure-2", 0, "report", around, drawn, "letters: title, caption and facts around a diagram; pins"},
      {"figure-2", 2, "slides", around, left_out, "a snapped band in the theme for slides: the widest lines"},
      {"figure-3", 2, "report", around, left_out, "the difference of two triangles, lines x = -1, 1, -2"},
      {"figure-4", 2, "report", around, left_out, "two searches side by side, one scale"},
      {"figure-5", 0, "report", around, left_out, "close-ups: direction and simplex of the first move"},
      {"figure-6", 0, "report", around, drawn,
       "letters: names of areas; the regions of a segment from a grid of origins"},
      {"figure-7", 1, "report", around, left_out, "the regions of a triangle, skipped ones hatched"},
      {"figure-8", 0, "report", around, left_out, "a tetrahedron in space, hidden edges thin and dashed, normals"},
      // Planar searches
      {"figure-4-left", 0, "report", around, left_out, "first support point: objects, supporting lines, out of reach"},
      {"figure-4-left", 4, "report", around, left_out, "crossing test: OP, d, its line, the projection of P"},
      {"figure-4-left", 7, "dark", around, left_out, "a support point, on a dark ground"},
      {"figure-4-left", 10, "report", around, left_out, "a vertex is dropped: the cross, earlier segments dotted"},
      {"figure-4-left", 1, "report", none, drawn, "letters without captions: pseudo-code with its marked line, keys"},
      {"figure-4-right", 5, "report", around, left_out, "the end of a search that finds a gap"},
      {"regions/2-simplex-on-vertex", 6, "report", around, left_out,
       "a chosen region of the plane beside one that is not"},
      {"regions/1-simplex-on-segment", 7, "slides", around, left_out, "the origin on a segment, for slides"},
      {"regions/2-simplex-on-vertex", 12, "report", around, left_out,
       "a rejected region with the tested one and hatching"},
      {"as-printed-spheres", 5, "report", around, left_out, "two runs part: the frames around what differs first"},
      {"mistakes/m1-wrong-side-of-b", 3, "report", around, left_out,
       "a mistake parts from the report's search, in the plane, each with what it finds"},
      {"mistakes/survival", 0, "report", around, left_out, "bars: how long mistakes survive; those that go on beyond"},
      // Space
      {"regions/2-simplex-r1-below", 5, "report", around, left_out, "a segment in space, camera, triad"},
      {"regions/3-simplex-inside", 20, "report", around, left_out,
       "tested and rejected faces from back to front, normal"},
      {"regions/3-simplex-inside", 22, "dark", around, left_out,
       "the origin inside: all faces rejected, on a dark ground"},
      {"cycle-separated", 21, "report", around, left_out, "the normal of a triangle that turns over"},
      {"cycle-separated", 25, "report", around, left_out,
       "three faces edge-on, and below them the one that is left behind"},
      {"regions/3-simplex-face-abc-edge-ac", 21, "report", around, left_out,
       "vertices that leave, in space and in the planes of the decision"},
      {"regions/3-simplex-face-abc-edge-ac", 20, "report", around, left_out,
       "regions beside the edges of a face, the origin's foot"},
      {"regions/3-simplex-face-acd", 0, "slides", around, left_out, "support plane in space: a translucent patch"},
      {"vehicle-and-threat/vehicle-hit", 12, "report", around, left_out,
       "cylinder with caps, polyhedron, regions in space"},
      {"vehicle-and-threat/counter-munition-near-miss", 15, "report", around, left_out, "sphere; a gap seen edge-on"},
      {"cycle-intersecting", 57, "report", around, left_out, "the repeated simplex marked by double rings"},
      {"complete/cycle-separated", 30, "report", around, left_out, "an edge of several that leads toward the origin"},
      {"complete/cycle-separated", 12, "report", around, left_out, "an edge that leads away from it"},
      {"complete/cycle-separated", 15, "report", around, left_out, "the foot of the origin on an edge"},
      {"complete/cycle-separated", 33, "report", around, left_out, "a region that alone does not decide"},
      // Proofs
      {"certified/tetrahedron", 23, "report", around, left_out, "four numbers beside the bound of what was rounded"},
      {"certified/one-step-apart", 28, "report", around, left_out, "a sign in doubt: computed and exact, to scale"},
      {"certified/cycle-separated", 13, "report", around, left_out, "the feature kept by a second search, from below"},
      {"certified/cycle-separated", 16, "report", around, left_out, "the gap that a second search ends with"},
  };
  return all;
}

std::string Picture::name() const {
  std::string base = walkthrough;
  std::ranges::replace(base, '/', '-');
  const std::string number = std::to_string(frame);
  return base + "-" + std::string(3 - std::min<std::size_t>(3, number.size()), '0') + number + "-" + theme +
         (text == none ? "-no-captions" : "");
}

render::Image draw(const Picture& picture, walkthroughs::output::Studio& studio) {
  const walkthroughs::picture::Look look{
      .style = walkthroughs::picture::Style(walkthroughs::picture::theme_named(picture.theme)), .text = picture.text};
  const walkthroughs::picture::StagedStory story(
      walkthroughs::story::tell(*walkthroughs::catalogue::find_walkthrough(picture.walkthrough)));
  render::Canvas canvas(pixels, walkthroughs::picture::page_of_frame(look), look.style.theme.paper, studio.font);
  walkthroughs::picture::draw_frame(canvas, story, picture.frame, look);
  if (picture.letters == left_out)
    for (render::Shape& shape : canvas.shapes())
      if (auto* const text = std::get_if<render::shape::Text>(&shape)) text->style.color.a = text->style.halo.a = 0;
  return studio.rasterizer.draw(canvas);
}

}  // namespace golden
