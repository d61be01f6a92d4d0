#include "walkthroughs/picture/panel_title.hpp"

#include <algorithm>
#include <numeric>

namespace walkthroughs::picture {
namespace {

using render::Vec2;

constexpr double origin_radius = 7, in_plane_radius = 3;  // page units

constexpr double above_title = 8, below_title_line = 10, margin = 14;
constexpr double usual_size = 18;
constexpr double least_key_size = 11, shortened_key_size = 15;
constexpr const char* ellipsis = "…";
constexpr double key_pitch = 48,
                 sign_to_words = 21;  // a sign with the space around it, and how far from its middle words begin
constexpr double beside_sign = 7;     // the space around it where text is larger, which takes the rest

/// Returns: `text` without its last character, "…" in its place: "cube" becomes "cub…", and that "cu…".
std::string shorter(std::string text) {
  const auto drop_last = [&] {
    while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
    if (!text.empty()) text.pop_back();
  };
  if (text.ends_with(ellipsis)) drop_last();
  drop_last();
  if (text.ends_with('\\')) text.pop_back();  // of an underscore's markup
  return text + ellipsis;
}

bool is_larger(const Style& style) { return style.theme.text > 1; }

double pitch_of(const KeyEntry& entry, const Style& style) {
  return is_larger(style) ? 2 * (entry.half_width + beside_sign) : key_pitch;
}

double width_of(render::Canvas& canvas, const std::vector<KeyEntry>& key, const render::TextStyle& text,
                const Style& style) {
  return std::accumulate(key.begin(), key.end(), 0.0, [&](double sum, const KeyEntry& entry) {
    return sum + pitch_of(entry, style) + canvas.width(entry.text, text);
  });
}

/// Returns: how title and key are lettered: where they do not fit beside each other smaller than the style says, but not
/// smaller than usual, unless the title alone would not fit.
render::TextStyle lettering(render::Canvas& canvas, double room, const std::string& title,
                            const std::vector<KeyEntry>& key, const Style& style) {
  render::TextStyle text = style.panel_title;
  while (text.size > usual_size && canvas.width(title, text) + width_of(canvas, key, text, style) > room)
    text.size = std::max(usual_size, text.size - 1);
  return canvas.fitted(title, text, room);
}

/// Returns: whether the key would be too small beside the title.
bool gives_way(render::Canvas& canvas, double room, const std::string& title, const std::vector<KeyEntry>& key,
               const Style& style) {
  render::TextStyle text = style.panel_title;
  text.size = shortened_key_size;
  return is_larger(style) && !key.empty() && canvas.width(title, text) + width_of(canvas, key, text, style) > room;
}

/// Draws the entries at the right end of `room`, in smaller letters where they would not fit; where they do not fit then,
/// those of a user's words shortened, of others as many as fit.
void draw_key(render::Canvas& canvas, render::Interval room, double baseline, std::vector<KeyEntry> key,
              render::TextStyle text, const Style& style) {
  const auto width = [&](const KeyEntry& entry) { return pitch_of(entry, style) + canvas.width(entry.text, text); };
  const auto needed = [&] { return width_of(canvas, key, text, style); };
  while (text.size > least_key_size && needed() > room.to - room.from) text.size -= 1;
  const bool may_be_shortened = !key.empty() && std::ranges::all_of(key, &KeyEntry::may_be_shortened);
  if (may_be_shortened && needed() > room.to - room.from) {
    text.size = shortened_key_size;
    while (needed() > room.to - room.from) {
      KeyEntry& widest = *std::ranges::max_element(key, {}, width);
      if (widest.text == ellipsis) break;
      widest.text = shorter(widest.text);
    }
  }
  std::size_t fitting = 0;
  for (double end = room.from; fitting < key.size(); ++fitting)
    if ((end += width(key[fitting])) > room.to) break;
  double right = room.to;
  for (std::size_t i = fitting; i-- > 0;) {
    const double left = right - width(key[i]), words = left + pitch_of(key[i], style);
    canvas.text({words, baseline}, key[i].text, text);
    key[i].draw(canvas, {words - (is_larger(style) ? key[i].half_width + beside_sign : sign_to_words),
                         baseline - std::max(usual_size, text.size) / 3});
    right = left;
  }
}

}  // namespace

render::Box below_title(const render::Box& frame, const Style& style) {
  return {frame.min + Vec2(0, above_title + style.panel_title.size + below_title_line), frame.max};
}

render::Box draw_panel_title(render::Canvas& canvas, const render::Box& frame, const std::string& title,
                             const Style& style, const std::vector<KeyEntry>& key) {
  canvas.outline(frame.corners(), style.frame);
  const render::Box room = below_title(frame, style);
  canvas.line(room.min, {room.max.x(), room.min.y()}, style.frame);
  const double baseline = frame.min.y() + above_title + style.panel_title.size;
  const double left = frame.min.x() + margin, right = frame.max.x() - margin;
  const std::string beside = gives_way(canvas, right - left, title, key, style) ? "" : title;
  const render::TextStyle text = lettering(canvas, right - left, beside, key, style);
  if (!beside.empty()) canvas.text({left, baseline}, beside, text);
  draw_key(canvas, {left + canvas.width(beside, text), right}, baseline, key, text, style);
  return room;
}

// -- Signs --

KeyEntry key_of_line(const std::string& text, const render::Stroke& stroke) {
  return {text,
          [=](render::Canvas& canvas, const Vec2& at) { canvas.line(at - Vec2(15, 0), at + Vec2(15, 0), stroke); }};
}

KeyEntry key_of_newest(const Style& style) {
  return {"newest",
          [&style](render::Canvas& canvas, const Vec2& at) {
            canvas.disc(at, style.point_radius - 1, style.theme.green);
            canvas.circle(at, style.point_radius + 3, {style.theme.ink, 2});
          },
          11};
}

KeyEntry key_of_out_of_reach(const std::string& text, const Style& style) {
  return {text, [&style](render::Canvas& canvas, const Vec2& at) {
            canvas.rectangle({at - Vec2(15, 8), at + Vec2(15, 8)}, style.out_of_reach);
            canvas.line(at + Vec2(-15, -8), at + Vec2(15, -8), style.support_line);
          }};
}

KeyEntry key_of_skipped(const Style& style) {
  return {"skipped",
          [&style](render::Canvas& canvas, const Vec2& at) {
            for (const double x : {-12.0, -4.0, 4.0, 12.0})
              canvas.line(at + Vec2(x - 7, 7), at + Vec2(x + 7, -7), style.hatching);
          },
          19};
}

std::vector<KeyEntry> key_of_origin(const std::vector<DecisionView>& views, const Style& style) {
  const auto entry = [&style](const char* words, double inner) {
    return KeyEntry{words,
                    [&style, inner](render::Canvas& canvas, const Vec2& at) {
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

}  // namespace walkthroughs::picture
