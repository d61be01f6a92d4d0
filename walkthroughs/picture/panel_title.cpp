#include "walkthroughs/picture/panel_title.hpp"

#include <algorithm>
#include <numeric>

namespace walkthroughs {
namespace {

using render::Vec2;

constexpr double title_height = 36, margin = 14;
constexpr double least_key_size = 11, shortened_key_size = 15;
constexpr const char* ellipsis = "…";
constexpr double key_pitch = 48;  // a sign with the space around it

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

/// Draws the entries at the right end of `room`, in smaller letters where they would not fit; where they do not fit then,
/// those of a user's words shortened, of others as many as fit.
void draw_key(render::Canvas& canvas, render::Interval room, double baseline, std::vector<KeyEntry> key,
              const Style& style) {
  render::TextStyle text = style.panel_title;
  const auto width = [&](const KeyEntry& entry) {
    return key_pitch + canvas.text_box({0, 0}, entry.text, text).width();
  };
  const auto needed = [&] {
    return std::accumulate(key.begin(), key.end(), 0.0, [&](double sum, const KeyEntry& e) { return sum + width(e); });
  };
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
    const double left = right - width(key[i]);
    canvas.text({left + key_pitch, baseline}, key[i].text, text);
    key[i].draw(canvas, {left + key_pitch - 21, baseline - 6});
    right = left;
  }
}

}  // namespace

render::Box below_title(const render::Box& frame) { return {frame.min + Vec2(0, title_height), frame.max}; }

render::Box draw_panel_title(render::Canvas& canvas, const render::Box& frame, const std::string& title,
                             const Style& style, const std::vector<KeyEntry>& key) {
  const Vec2 corners[] = {frame.min, {frame.max.x(), frame.min.y()}, frame.max, {frame.min.x(), frame.max.y()}};
  canvas.outline(corners, style.frame);
  const render::Box room = below_title(frame);
  canvas.line(room.min, {room.max.x(), room.min.y()}, style.frame);
  const double baseline = frame.min.y() + 26;
  if (!title.empty()) canvas.text({frame.min.x() + margin, baseline}, title, style.panel_title);
  const double title_width = title.empty() ? 0 : canvas.text_box({0, 0}, title, style.panel_title).width();
  draw_key(canvas, {frame.min.x() + margin + title_width, frame.max.x() - margin}, baseline, key, style);
  return room;
}

}  // namespace walkthroughs
