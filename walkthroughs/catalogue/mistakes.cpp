// Mistakes: how long each stays unnoticed, as the study has measured it; and each on a pair on which it shows.

#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/picture/diagram_parts.hpp"

namespace walkthroughs::catalogue {
namespace {

using render::Box;
using render::Canvas;
using render::TextStyle;
using render::Vec2;
using wrong_on_purpose::PairsToNotice;
using wrong_on_purpose::TestPairs;

// -- How long each stays unnoticed -------------------------------------------------------------------------------------

// Page units.
constexpr double text_size = 14, names_width = 650, numbers_width = 48, counts_width = 166, axis_height = 24,
                 thickness = 0.62;
constexpr int decades = 6;

/// Where the bars stand.
struct Chart {
  explicit Chart(const Box& room)
      : left(room.min.x() + names_width),
        right(room.max.x() - counts_width),
        top(room.min.y() + 4),
        bottom(room.max.y() - axis_height),
        pitch((bottom - top) / static_cast<double>(wrong_on_purpose::all().size())) {}

  double x_of(double pairs) const { return left + (right - left) * std::min(std::log10(pairs) / decades, 1.0); }
  /// Returns: the middle of the bar.
  double y_of(Mistake mistake) const { return top + pitch * (static_cast<double>(mistake) + 0.5); }

  double left, right, top, bottom, pitch;
};

void draw_axis(Canvas& canvas, const Chart& chart, const Style& style) {
  TextStyle text{.size = text_size, .color = style.theme.grey, .align = render::Align::center};
  std::size_t pairs = 1;
  for (int decade = 0; decade <= decades; decade += 2, pairs *= 100) {
    const double x = chart.x_of(static_cast<double>(pairs));
    canvas.line({x, chart.top}, {x, chart.bottom}, style.grid);
    canvas.text({x, chart.bottom + 0.8 * axis_height}, with_commas(pairs), text);
  }
}

/// Returns: what stands behind a bar; that is all there is of a mistake that is none.
std::string words_of(const wrong_on_purpose::Description& mistake, TestPairs pairs) {
  return is_none_along_axes(mistake.value) ? "never wrong, begun along an axis"
                                           : pairs_to_notice(mistake.value, pairs).text();
}

void draw_bar(Canvas& canvas, const Chart& chart, const wrong_on_purpose::Description& mistake, TestPairs pairs,
              const Style& style) {
  const PairsToNotice needed = pairs_to_notice(mistake.value, pairs);
  const double y = chart.y_of(mistake.value), half = thickness * chart.pitch / 2, end = chart.x_of(needed.count);
  TextStyle text{.size = text_size, .color = style.theme.ink};
  const double baseline = y + canvas.cap_height(text) / 2;
  text.align = render::Align::right;
  canvas.text({chart.left - 8, baseline}, wrong_on_purpose::number_of(mistake.value), text);
  canvas.text({chart.left - numbers_width, baseline}, mistake.meaning, text);
  text.align = render::Align::left;
  if (is_none_along_axes(mistake.value)) return canvas.text({chart.left + 8, baseline}, words_of(mistake, pairs), text);
  const Vec2 bar[] = {{chart.left, y - half}, {end, y - half}, {end, y + half}, {chart.left, y + half}};
  canvas.polygon(bar, needed.is_more ? style.object_b_fill : style.object_a_fill);
  canvas.outline(bar, {style.theme.ink, 1});
  if (needed.is_more) canvas.arrow({end, y}, {chart.right + 14, y}, {style.theme.ink, 1.5 * style.theme.line});
  canvas.text({needed.is_more ? chart.right + 20 : end + 8, baseline}, words_of(mistake, pairs), text);
}

int draw(TestPairs pairs, Canvas& canvas, const Box& box, const Style& style) {
  const Chart chart(
      draw_panel_title(canvas, box, "random pairs that show it in 95 of 100 tests, by powers of ten", style));
  draw_axis(canvas, chart, style);
  for (const auto& mistake : wrong_on_purpose::all()) draw_bar(canvas, chart, mistake, pairs, style);
  return 0;
}

std::string described(TestPairs pairs) {
  std::string text = "One bar for each mistake.";
  for (const auto& mistake : wrong_on_purpose::all())
    text += " " + wrong_on_purpose::number_of(mistake.value) + ", " + std::string(mistake.meaning) + ": " +
            words_of(mistake, pairs) + ".";
  return text;
}

Diagram diagram(TestPairs pairs, const std::string& caption, std::vector<std::string> facts) {
  return {caption, std::move(facts), described(pairs),
          [pairs](Canvas& canvas, const Box& box, const Style& style) { return draw(pairs, canvas, box, style); }};
}

std::string count_where(const std::function<bool(const wrong_on_purpose::Description&)>& is_so) {
  return std::to_string(std::ranges::count_if(wrong_on_purpose::all(), is_so));
}

std::vector<Diagram> survival_diagrams() {
  const auto unseen = [](TestPairs pairs) {
    return [pairs](const auto& mistake) { return pairs_to_notice(mistake.value, pairs).is_more; };
  };
  const auto show = [&](TestPairs pairs) {
    return count_where(unseen(pairs)) + " of " + std::to_string(wrong_on_purpose::all().size()) +
           " show on none of the pairs that were tried";
  };
  const std::string none = count_where([](const auto&mistake) { return is_none_along_axes(mistake.value); }),
                    more = count_where([&](const auto&mistake) {
                      return unseen(TestPairs::triangles)(mistake) && !unseen(TestPairs::grid_triangles)(mistake);
                    });
  return {diagram(TestPairs::triangles, "How many random pairs of triangles it takes to notice a mistake.",
                  {show(TestPairs::triangles), none + " of these is never wrong, begun along an axis"}),
          diagram(TestPairs::grid_triangles,
                  "Triangles on a grid of 6 × 6 × 6 points touch more often, and some mistakes show sooner.",
                  {more + " more show once sets touch; " + show(TestPairs::grid_triangles)})};
}

// -- Pairs: small whole numbers, in the plane where there is such a pair ------------------------------------------------

/// Two triangles; a triangle and a segment, where both searches are to find the same first point.
struct MistakenPair {
  Mistake mistake;
  std::vector<Corner> a, b;
};

/// In the report's order.
std::vector<MistakenPair> pairs() {
  const std::vector<Corner> wide{{0, 0}, {-1, 2}, {-1, 0}}, narrow{{-1, 0}, {0, 0}, {0, 1}};
  return {
      {Mistake::wrong_side_of_b, {{0, 1}, {-1, 0}, {1, 0}}, {{0, 2}, {0, -1}}},
      {Mistake::first_point_tested, {{-1, 1}, {0, 0}, {-1, -1}}, {{2, 0}, {1, 1}, {1, 0}}},
      {Mistake::touching_is_apart, {{-1, -2}, {0, -1}, {0, 0}}, {{-1, 0}, {0, 0}, {-1, -1}}},
      {Mistake::as_printed, {{-1, -1}, {0, 0}, {-1, 0}}, {{0, 1}, {1, 0}, {0, 2}}},
      {Mistake::origin_at_vertex_missed, {{0, 0}, {-2, -2}, {-1, 0}}, {{0, 0}, {0, 2}, {1, 0}}},
      {Mistake::origin_on_segment_missed, {{1, 1}, {1, 0}, {0, -1}}, {{1, 0}, {0, 0}, {0, 1}}},
      {Mistake::direction_from_vertex, {{-1, 0}, {-1, 1}, {0, -1}}, {{1, 0}, {1, 1}, {0, 0}}},
      {Mistake::triangle_normal_reversed, {{0, 1}, {2, 0}, {-2, 0}}, {{0, -1}, {-1, -1}, {-1, 1}}},
      {Mistake::triangle_abn_inward, wide, narrow},
      {Mistake::triangle_acn_inward, wide, narrow},
      {Mistake::edge_normal_as_direction, {{1, 1, 0}, {-1, -1, 0}, {0, -2, 0}}, {{1, 1, 2}, {-1, -2, 1}, {-2, 1, 2}}},
      {Mistake::two_dimensions_only, {{0, 1, 1}, {-1, 2, 0}, {1, -1, 1}}, {{2, 0, 1}, {0, -1, -1}, {0, 0, 0}}},
      {Mistake::origin_in_triangle_missed, wide, narrow},
      {Mistake::order_kept_below_triangle, {{1, 0, 1}, {0, 0, -1}, {1, 0, 0}}, {{0, -2, -2}, {1, 2, 0}, {-1, -1, 0}}},
      {Mistake::abcn_inward, {{-1, 0, 0}, {0, 0, 0}, {1, -1, 1}}, {{-1, 2, 1}, {-2, 1, -1}, {-1, -1, 0}}},
      {Mistake::acdn_inward, {{-1, 0, -1}, {1, 1, 0}, {0, 0, 0}}, {{0, 1, 0}, {1, 3, -1}, {1, 0, -2}}},
      {Mistake::adbn_inward, {{0, 1, -1}, {1, 0, 0}, {-2, 0, 1}}, {{-2, -1, 1}, {0, 2, 1}, {-1, 2, -1}}},
      {Mistake::edge_normals_reused, {{-1, 0, 0}, {1, 0, -1}, {0, -2, 0}}, {{-1, -1, 0}, {1, 1, -2}, {1, -1, 0}}},
      {Mistake::abn_reused_for_adb, {{0, -2, 0}, {2, -1, 2}, {-2, 0, -1}}, {{2, 1, 1}, {0, 0, 1}, {0, -2, 1}}},
      {Mistake::order_of_adb, {{-1, 2, 1}, {0, -1, 1}, {2, 0, -1}}, {{1, 0, 0}, {0, 1, 0}, {0, -2, -2}}},
      {Mistake::origin_in_face_seen_outside, {{-1, -2, 1}, {0, -2, 1}, {0, 1, -1}}, {{0, 0, 1}, {0, 2, 2}, {0, 1, -2}}},
  };
}

}  // namespace

Walkthrough beside_the_report(Mistake mistake, Scene right) {
  const wrong_on_purpose::Description& known = wrong_on_purpose::description_of(mistake);
  return beside_mistake(
      mistake, search_of("mistakes/" + std::string(known.word),
                         "A mistake, " + wrong_on_purpose::number_of(mistake) + ", and the report's algorithm",
                         "Section " + std::string(known.section), std::string(known.meaning), std::move(right)));
}

std::vector<Walkthrough> mistakes() {
  std::vector<Walkthrough> all{diagrams_of(
      "mistakes/survival", "How long mistakes survive", "Section 1",
      "how many random pairs it takes to notice each of 21 mistakes, as the study has measured it", survival_diagrams)};
  for (const MistakenPair& pair : pairs()) {
    const std::string b = pair.b.size() == 2 ? "segment b" : "triangle b";
    all.push_back(beside_the_report(pair.mistake, scene_of("triangle a", pair.a, b, pair.b)));
  }
  return all;
}

}  // namespace walkthroughs::catalogue
