#include "walkthroughs/picture/key.hpp"

#include <algorithm>

namespace walkthroughs {
namespace {

using render::Canvas;
using render::Vec2;

constexpr double origin_radius = 7, in_plane_radius = 3;  // page units

}  // namespace

KeyEntry key_of_line(const std::string& text, const render::Stroke& stroke) {
  return {text, [=](Canvas& canvas, const Vec2& at) { canvas.line(at - Vec2(15, 0), at + Vec2(15, 0), stroke); }};
}

KeyEntry key_of_newest(const Style& style) {
  return {"newest",
          [&style](Canvas& canvas, const Vec2& at) {
            canvas.disc(at, style.point_radius - 1, style.theme.green);
            canvas.circle(at, style.point_radius + 3, {style.theme.ink, 2});
          },
          11};
}

KeyEntry key_of_out_of_reach(const std::string& text, const Style& style) {
  return {text, [&style](Canvas& canvas, const Vec2& at) {
            canvas.rectangle({at - Vec2(15, 8), at + Vec2(15, 8)}, style.out_of_reach);
            canvas.line(at + Vec2(-15, -8), at + Vec2(15, -8), style.support_line);
          }};
}

KeyEntry key_of_skipped(const Style& style) {
  return {"skipped",
          [&style](Canvas& canvas, const Vec2& at) {
            for (const double x : {-12.0, -4.0, 4.0, 12.0})
              canvas.line(at + Vec2(x - 7, 7), at + Vec2(x + 7, -7), style.hatching);
          },
          19};
}

std::vector<KeyEntry> key_of_origin(const std::vector<DecisionView>& views, const Style& style) {
  const auto entry = [&style](const char* words, double inner) {
    return KeyEntry{words,
                    [&style, inner](Canvas& canvas, const Vec2& at) {
                      if (inner > 0) canvas.disc(at, inner, style.theme.ink);
                      canvas.circle(at, origin_radius - 1, {style.theme.ink, 2});
                    },
                    origin_radius};
  };
  if (std::ranges::any_of(views, [](const DecisionView& view) { return view.height == 0; }))
    return {entry("above", origin_radius), entry("in it", in_plane_radius), entry("below", 0)};
  if (style.theme.text > 1)
    return {entry("above", origin_radius), entry("below", 0)};  // what its letters have room for
  return {entry("O above", origin_radius), entry("O below", 0)};
}

void draw_origin_beside(render::Panel& panel, const Vec2& at, double height, const Style& style) {
  panel.disc(at, origin_radius + 2, style.theme.paper);
  if (height > 0) panel.disc(at, origin_radius, style.theme.ink);
  if (height == 0) panel.disc(at, in_plane_radius, style.theme.ink);
  panel.circle(at, origin_radius - 1, {style.theme.ink, 2});
}

}  // namespace walkthroughs
