#include "walkthroughs/picture/panel_title.hpp"

#include <algorithm>
#include <numeric>

namespace walkthroughs {
namespace {

using render::Vec2;

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

double width_of(render::Canvas& canvas, const std::string& words, const render::TextStyle& text) {
  return words.empty() ? 0 : canvas.text_box({0, 0}, words, text).width();
}

bool is_larger(const Style& style) { return style.theme.text > 1; }

double pitch_of(const KeyEntry& entry, const Style& style) {
  return is_larger(style) ? 2 * (entry.half_width + beside_sign) : key_pitch;
}

double width_of(render::Canvas& canvas, const std::vector<KeyEntry>& key, const render::TextStyle& text,
                const Style& style) {
  return std::accumulate(key.begin(), key.end(), 0.0, [&](double sum, const KeyEntry& entry) {
    return sum + pitch_of(entry, style) + width_of(canvas, entry.text, text);
  });
}

/// Returns: how title and key are lettered: where they do not fit beside each other smaller than the style says, but not
/// smaller than usual, unless the title alone would not fit.
render::TextStyle lettering(render::Canvas& canvas, double room, const std::string& title,
                            const std::vector<KeyEntry>& key, const Style& style) {
  render::TextStyle text = style.panel_title;
  while (text.size > usual_size && width_of(canvas, title, text) + width_of(canvas, key, text, style) > room)
    text.size = std::max(usual_size, text.size - 1);
  if (const double width = width_of(canvas, title, text); width > room) text.size *= room / width;
  return text;
}

/// Returns: whether the key would be too small beside the title.
bool gives_way(render::Canvas& canvas, double room, const std::string& title, const std::vector<KeyEntry>& key,
               const Style& style) {
  render::TextStyle text = style.panel_title;
  text.size = shortened_key_size;
  return is_larger(style) && !key.empty() && width_of(canvas, title, text) + width_of(canvas, key, text, style) > room;
}

/// Draws the entries at the right end of `room`, in smaller letters where they would not fit; where they do not fit then,
/// those of a user's words shortened, of others as many as fit.
void draw_key(render::Canvas& canvas, render::Interval room, double baseline, std::vector<KeyEntry> key,
              render::TextStyle text, const Style& style) {
  const auto width = [&](const KeyEntry& entry) { return pitch_of(entry, style) + width_of(canvas, entry.text, text); };
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
  const Vec2 corners[] = {frame.min, {frame.max.x(), frame.min.y()}, frame.max, {frame.min.x(), frame.max.y()}};
  canvas.outline(corners, style.frame);
  const render::Box room = below_title(frame, style);
  canvas.line(room.min, {room.max.x(), room.min.y()}, style.frame);
  const double baseline = frame.min.y() + above_title + style.panel_title.size;
  const double left = frame.min.x() + margin, right = frame.max.x() - margin;
  const std::string beside = gives_way(canvas, right - left, title, key, style) ? "" : title;
  const render::TextStyle text = lettering(canvas, right - left, beside, key, style);
  if (!beside.empty()) canvas.text({left, baseline}, beside, text);
  draw_key(canvas, {left + width_of(canvas, beside, text), right}, baseline, key, text, style);
  return room;
}

}  // namespace walkthroughs
