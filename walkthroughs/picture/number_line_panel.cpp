#include <algorithm>

#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/picture/panels.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::picture {
namespace {

using render::Box;
using render::Vec2;

// Page units.
constexpr double margin = 26, top_margin = 12, below_zero = 44, zero_below = 24, row_of_words = 34, most_row = 130;
constexpr double note_pitch = 1.3;    // in sizes of the note
constexpr double size_in_rows = 0.7;  // of a number's name, at most
constexpr double radius = 8, half_diamond = 10, tick = 16;
constexpr double room_at_ends = 0.1;  // of the line, beyond its outermost number
constexpr double least_band = 2;      // a narrower one is drawn so wide
constexpr double gap_to_band = 8;     // of a name that may stand beside it

/// Places numbers on the line, from left to right.
class Scale {
 public:
  Scale(const NumberLine& line, const Box& room) : left_(room.min.x()), width_(room.width()) {
    const auto [least, most] = std::ranges::minmax(line.numbers, {}, &NumberLine::Number::value);
    low_ = std::min({0.0, line.low, least.value}), high_ = std::max({0.0, line.high, most.value});
    const double more = room_at_ends * (high_ / 2 - low_ / 2);
    if (!(more > 0)) low_ = -1, high_ = 1;
    low_ -= 2 * more, high_ += 2 * more;
  }
  /// Halves, so that no difference of large numbers overflows.
  double operator()(double value) const { return left_ + width_ * ((value / 2 - low_ / 2) / (high_ / 2 - low_ / 2)); }

 private:
  double left_, width_, low_, high_;
};

void draw_mark(render::Canvas& canvas, const Vec2& at, bool is_exact, const Style& style) {
  if (!is_exact) return canvas.disc(at, radius, style.theme.vermillion);
  const Vec2 diamond[] = {at + Vec2(0, -half_diamond), at + Vec2(half_diamond, 0), at + Vec2(0, half_diamond),
                          at + Vec2(-half_diamond, 0)};
  canvas.polygon(diamond, style.theme.green);
}

std::vector<KeyEntry> key_of(const NumberLine& line, const Style& style) {
  const auto entry = [&style](const char* words, bool is_exact) {
    return KeyEntry{
        words, [&style, is_exact](render::Canvas& canvas, const Vec2& at) { draw_mark(canvas, at, is_exact, style); }};
  };
  std::vector<KeyEntry> key{entry("computed", false)};
  if (std::ranges::any_of(line.numbers, &NumberLine::Number::is_exact)) key.push_back(entry("exactly", true));
  return key;
}

/// The numbers one below the other, each on a line of its own; the lines share their scale.
class NumberLinePicture {
 public:
  NumberLinePicture(render::Canvas& canvas, const Box& inner, const NumberLine& line, const Shown& shown)
      : canvas_(canvas), line_(line), shown_(shown), style_(shown.style), note_(style_.fact) {
    note_.color = style_.support_line.color;
    const double rows = static_cast<double>(line.numbers.size());
    do {  // larger text than usual leaves room for the numbers
      if (shown.values) note_lines_ = render::wrap(canvas, line.meaning, note_, inner.width() - 2 * margin);
      const double below = below_zero + note_pitch * note_.size * static_cast<double>(note_lines_.size());
      room_ = {inner.min + Vec2(margin, top_margin), inner.max - Vec2(margin, below)};
      pitch_ = std::min(most_row, room_.height() / rows);
    } while (bold().size < style_.label(style_.theme.ink).size && --note_.size > style_.fact.size / style_.theme.text);
    top_ = room_.center().y() - pitch_ * rows / 2;
    bottom_ = top_ + pitch_ * rows;
  }

  void draw() const {
    const Scale at(line_, room_);
    band(at(line_.low), at(line_.high));
    double y = top_;
    for (const NumberLine::Number& each : line_.numbers) {
      row(each, y, at);
      y += pitch_;
    }
    render::TextStyle zero = bold();
    zero.align = render::Align::center;
    canvas_.text({at(0), bottom_ + zero_below}, "0", zero);
    y = bottom_ + zero_below;
    for (const std::string& text : note_lines_)
      canvas_.text({room_.min.x(), y += note_pitch * note_.size}, text, note_);
  }

 private:
  render::TextStyle bold() const {
    render::TextStyle text = style_.label(style_.theme.ink, render::Weight::bold);
    text.size = std::min(text.size, size_in_rows * pitch_);
    return text;
  }

  /// What rounding may have made. A narrower one than can be seen is a line.
  void band(double low, double high) const {
    const double middle = (low + high) / 2, half = std::max(high - low, least_band) / 2;
    canvas_.rectangle({{middle - half, top_}, {middle + half, bottom_}}, style_.out_of_reach);
    for (const double side : {-half, half})
      canvas_.line({middle + side, top_}, {middle + side, bottom_}, {style_.support_line.color, 1.2, {4, 4}});
  }

  void row(const NumberLine::Number& number, double top, const Scale& at) const {
    const double level = top + (pitch_ + row_of_words) / 2;
    canvas_.line({room_.min.x(), level}, {room_.max.x(), level}, {style_.theme.ink, 1.5});
    canvas_.line({at(0), level - tick}, {at(0), level + tick}, {style_.theme.ink, 2.5});
    draw_mark(canvas_, {at(number.value), level}, number.is_exact, style_);
    name(shown_.values ? number.equation() : number.name, {at(number.value), top + row_of_words - 8}, at);
  }

  /// In the middle over the mark, or beside it where the room ends; also off the band, where there is room on that side. Larger
  /// text than fits is drawn smaller.
  void name(const std::string& words, const Vec2& mark, const Scale& at) const {
    const double width = std::min(canvas_.width(words, bold()), room_.width());
    double low = room_.min.x(), high = room_.max.x();
    const double before_band = at(line_.low) - gap_to_band, behind_band = at(line_.high) + gap_to_band;
    if (mark.x() < before_band && before_band - low >= width) high = before_band;
    if (mark.x() > behind_band && high - behind_band >= width) low = behind_band;
    canvas_.text({std::max(std::min(mark.x() - width / 2, high - width), low), mark.y()}, words,
                 canvas_.fitted(words, bold(), room_.width()));
  }

  render::Canvas& canvas_;
  const NumberLine& line_;
  const Shown& shown_;
  const Style& style_;
  render::TextStyle note_;
  std::vector<std::string> note_lines_;
  Box room_;
  double pitch_ = 0, top_ = 0, bottom_ = 0;
};

}  // namespace

void draw_number_line(render::Canvas& canvas, const Box& frame, const NumberLine& line, const Shown& shown) {
  const Box room = draw_panel_title(canvas, frame, shown.focus == Focus::proof ? "is it a proof?" : "which sign?",
                                    shown.style, key_of(line, shown.style));
  NumberLinePicture(canvas, room, line, shown).draw();
}

}  // namespace walkthroughs::picture
