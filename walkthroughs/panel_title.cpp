#include <numeric>

#include "walkthroughs/panels.hpp"

namespace walkthroughs {
namespace {

using render::Vec2;

constexpr double title_height = 36, margin = 14;
constexpr double key_pitch = 42;  // a sign with the space around it

}  // namespace

render::Box below_title(const render::Box& frame) { return {frame.min + Vec2(0, title_height), frame.max}; }

void draw_panel_title(render::Canvas& canvas, const render::Box& frame, const std::string& title,
                      const std::vector<KeyEntry>& key, const Style& style) {
  const Vec2 corners[] = {frame.min, {frame.max.x(), frame.min.y()}, frame.max, {frame.min.x(), frame.max.y()}};
  canvas.outline(corners, style.frame);
  canvas.line(below_title(frame).min, {frame.max.x(), below_title(frame).min.y()}, style.frame);
  const double baseline = frame.min.y() + 26;
  if (!title.empty()) canvas.text({frame.min.x() + margin, baseline}, title, style.panel_title);
  const auto width = [&](const std::string& text) {
    return text.empty() ? 0 : canvas.text_box({0, 0}, text, style.panel_title).width();
  };
  const double room = frame.width() - 2 * margin - width(title);
  std::size_t fitting = 0;
  for (double needed = 0; fitting < key.size(); ++fitting)
    if ((needed += key_pitch + width(key[fitting].text)) > room) break;
  double x = frame.max.x() - margin;
  for (std::size_t i = fitting; i-- > 0;) {
    x -= width(key[i].text);
    canvas.text({x, baseline}, key[i].text, style.panel_title);
    key[i].draw(canvas, {x - 21, baseline - 6});
    x -= key_pitch;
  }
}

}  // namespace walkthroughs
