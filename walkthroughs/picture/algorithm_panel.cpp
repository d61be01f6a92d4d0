#include <algorithm>
#include <limits>

#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/picture/panels.hpp"
#include "walkthroughs/story/pseudocode.hpp"

namespace walkthroughs::picture {
namespace {

using render::Vec2;

constexpr double text_size = 17, least_text_size = 12, indent_width = 20, margin = 14, most_pitch = 26;
constexpr double least_value_size = 11, gap_to_value = 8;
constexpr double size_in_pitches = 0.8, space_below = 0.7;  // the last in lines

/// The lines that are shown: all of them, or, where the letters are large, as many as there is room for around `middle`. The
/// first and the last of an excerpt tell that there are more.
struct Excerpt {
  Excerpt(std::size_t lines, std::size_t room, std::size_t middle) : count(std::min(lines, room)), of(lines) {
    first = std::min(middle - std::min(middle, count / 2), lines - count);
  }
  bool leaves_out(std::size_t line) const {
    return (line == first && first > 0) || (line + 1 == first + count && first + count < of);
  }

  std::size_t first = 0, count, of;
};

/// Returns: how many lines there is room for.
std::size_t lines_in(const render::Box& room, const Style& style) {
  if (style.theme.text <= 1) return std::numeric_limits<std::size_t>::max();  // as small as it takes
  return static_cast<std::size_t>(room.height() / (style.scaled(text_size) / size_in_pitches) - space_below);
}

/// Draws the lines in equal steps from top to bottom.
class Listing {
 public:
  Listing(render::Canvas& canvas, const render::Box& room, int number, std::size_t lines, const Shown& shown)
      : canvas_(canvas),
        number_(number),
        room_(room),
        shown_(shown),
        style_(shown.style),
        pitch_(std::min(style_.scaled(most_pitch), room.height() / (static_cast<double>(lines) + space_below))),
        text_{.size = std::clamp(pitch_ * size_in_pitches, style_.scaled(least_text_size), style_.scaled(text_size)),
              .color = style_.theme.ink} {}

  void line(std::size_t row, const CodeLine& line, bool is_current) {
    const double baseline = baseline_of(row);
    if (is_current) mark(baseline);
    render::TextStyle text = text_;
    if (is_current) text.weight = render::Weight::bold;
    const std::string words = line_in_letters(number_, line, shown_.names);
    const double left = left_of(line.indent);
    const auto* const test = test_of(line, shown_.now);
    const double right =
        room_.max.x() - (test ? margin + gap_to_value + canvas_.width(outcome(*test, false), text_) : 6);
    text = canvas_.fitted(words, text, right - left);
    canvas_.text({left, baseline}, words, text);
    if (test) value(baseline, *test, left + canvas_.width(words, text));
  }

  void left_out(std::size_t row, int indent) { canvas_.text({left_of(indent), baseline_of(row)}, "⋮", text_); }

 private:
  double baseline_of(std::size_t row) const { return room_.min.y() + pitch_ * static_cast<double>(row + 1); }
  double left_of(int indent) const { return room_.min.x() + margin + 14 + indent_width * indent; }

  void mark(double baseline) {
    const double middle = baseline - text_.size * 0.35;
    canvas_.rectangle({{room_.min.x() + 4, middle - pitch_ / 2}, {room_.max.x() - 4, middle + pitch_ / 2}},
                      style_.tested_fill);
    const Vec2 tip(room_.min.x() + margin + 8, middle);
    const Vec2 arrow[] = {tip, tip + Vec2(-9, -6), tip + Vec2(-9, 6)};
    canvas_.polygon(arrow, style_.tested.color);
  }

  /// At the right, smaller where there is less room. Where it could not be read then only the mark stands: the caption has it.
  void value(double baseline, const gjk::RegionTested<double>& test, double from) {
    render::TextStyle text = text_;
    text.weight = render::Weight::bold;
    text.align = render::Align::right;
    text.color = test.verdict == gjk::Verdict::rejected ? style_.theme.vermillion : style_.theme.green;
    const double right = room_.max.x() - margin, room = right - from - gap_to_value;
    std::string words = outcome(test, shown_.values);
    if (canvas_.fitted(words, text, room).size < least_value_size) words = outcome(test, false);
    canvas_.text({right, baseline}, words, canvas_.fitted(words, text, room));
  }

  render::Canvas& canvas_;
  const int number_;
  const render::Box& room_;
  const Shown& shown_;
  const Style& style_;
  const double pitch_;
  const render::TextStyle text_;
};

}  // namespace

void draw_algorithm(render::Canvas& canvas, const render::Box& frame, const Shown& shown) {
  const int number = running_algorithm(shown.now, shown.focus);
  const std::vector<CodeLine>& code = algorithm(number, shown.telling.scene.rules);
  draw_panel_title(canvas, frame, title_of(number, shown.telling.scene.rules, shown.names, shown.now.processed),
                   shown.style);
  const render::Box room = below_title(frame, shown.style);
  const std::optional<std::size_t> current = current_line(code, shown.now, shown.focus);
  const Excerpt excerpt(code.size(), lines_in(room, shown.style), current.value_or(0));
  Listing listing(canvas, room, number, excerpt.count, shown);
  for (std::size_t row = 0; row < excerpt.count; ++row) {
    const std::size_t i = excerpt.first + row;
    if (excerpt.leaves_out(i))
      listing.left_out(row, code[i].indent);
    else
      listing.line(row, code[i], current == i);
  }
}

}  // namespace walkthroughs::picture
