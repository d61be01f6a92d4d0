#include "walkthroughs/picture/panel_title.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "walkthroughs/picture/inset.hpp"

namespace walkthroughs::picture {
namespace {

using render::Vec2;

constexpr double origin_radius = 7, in_plane_radius = 3;  // page units

constexpr double above_title = 8, below_title_line = 10, margin = 14;
constexpr double least_size = 15, least_share = 2.0 / 3;  // of letters that get smaller for want of room: of the usual
constexpr double line_pitch = 1.35;                       // of a key below its title, in sizes of the letters
constexpr double before_sign = 10, behind_sign = 7, middle_of_sign = 6;  // the last above the baseline
constexpr const char* ellipsis = "…";

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

std::string shortened(render::Canvas& canvas, std::string text, const render::TextStyle& how, double room) {
  while (canvas.width(text, how) > room && text != ellipsis) text = shorter(text);
  return text;
}

/// The letters of a title and its key, and the lines of the key, from the top.
struct Head {
  Head(render::Canvas& on, double room, const std::string& title, const std::vector<KeyEntry>& key, const Style& style)
      : canvas(on), title_text(style.panel_title), key_text(style.panel_title) {
    const double usual = style.panel_title.size, least = std::min(usual, std::max(least_size, least_share * usual));
    const auto is_beside = [&](double size) {
      key_text.size = size;
      return canvas.width(title, key_text) + width_of(key) <= room;
    };
    const auto larger_that_fits = [&](const auto& fits) {
      double size = usual;
      while (size > least && !fits(size)) size = std::max(least, size - 1);
      return size;
    };
    begins_below = !is_beside(larger_that_fits(is_beside)) && !title.empty();
    if (!begins_below) title_text.size = key_text.size;
    title_text.size = canvas.fitted(title, title_text, room).size;
    words = title;
    if (title_text.size < least) {
      title_text.size = least;
      words = shortened(canvas, title, title_text, room);
    }
    if (is_beside(key_text.size)) {
      if (!key.empty()) lines = {key};
      return;
    }
    larger_that_fits([&](double size) {
      key_text.size = size;
      return width_of(key) - before_sign <= room;
    });
    wrap(key, room);
  }

  double width_of(const KeyEntry& entry) const {
    return before_sign + 2 * entry.half_width + behind_sign + canvas.width(entry.text, key_text);
  }
  double width_of(const std::vector<KeyEntry>& line) const {
    return std::accumulate(line.begin(), line.end(), 0.0,
                           [&](double sum, const KeyEntry& entry) { return sum + width_of(entry); });
  }
  double pitch() const { return line_pitch * key_text.size; }
  /// Returns: how much higher all this is than one line.
  double added_height() const {
    const double below = static_cast<double>(lines.size()) - (begins_below ? 0 : 1);
    return std::max(0.0, below) * pitch();
  }

  render::Canvas& canvas;
  render::TextStyle title_text, key_text;
  std::string words;          ///< of the title
  bool begins_below = false;  ///< whether the key begins below the title
  std::vector<std::vector<KeyEntry>> lines;

 private:
  /// As many entries in a line as fit. One that alone is too wide goes on in the next line where it is a name of several words,
  /// and is shortened where it is another; else all get smaller.
  void wrap(const std::vector<KeyEntry>& key, double room) {
    const auto room_of_words = [&](const KeyEntry& entry) { return room - 2 * entry.half_width - behind_sign; };
    for (const KeyEntry& entry : key)
      if (!entry.may_be_shortened) key_text = canvas.fitted(entry.text, key_text, room_of_words(entry));
    for (KeyEntry entry : key) {
      KeyEntry rest = entry.may_be_shortened ? cut_off(entry, room_of_words(entry)) : KeyEntry{};
      if (lines.empty() || width_of(lines.back()) + width_of(entry) - before_sign > room) lines.emplace_back();
      lines.back().push_back(entry);
      if (!rest.text.empty()) lines.push_back({std::move(rest)});
    }
  }

  /// Leaves what fits of a name. Returns: the words for the next line, without a sign.
  KeyEntry cut_off(KeyEntry& entry, double room) const {
    const std::vector<std::string> words = render::wrap(canvas, entry.text, key_text, room);
    const auto fits = [&](const std::string& text) { return canvas.width(text, key_text) <= room; };
    if (words.size() != 2 || !std::ranges::all_of(words, fits)) {
      entry.text = shortened(canvas, entry.text, key_text, room);
      return {};
    }
    entry.text = words[0];
    return {words[1], [](render::Canvas&, const Vec2&) {}, entry.half_width};
  }
};

/// Draws one line of the key from `left`, where the space before its first sign begins.
void draw_line_of_key(const Head& head, const std::vector<KeyEntry>& line, Vec2 at) {
  for (const KeyEntry& entry : line) {
    const double middle = at.x() + before_sign + entry.half_width;
    entry.draw(head.canvas, {middle, at.y() - std::max(middle_of_sign, head.key_text.size / 3)});
    head.canvas.text({middle + entry.half_width + behind_sign, at.y()}, entry.text, head.key_text);
    at.x() += head.width_of(entry);
  }
}

}  // namespace

render::Box below_title(const render::Box& frame, const Style& style) {
  return {frame.min + Vec2(0, above_title + style.panel_title.size + below_title_line), frame.max};
}

render::Box draw_panel_title(render::Canvas& canvas, const render::Box& frame, const std::string& title,
                             const Style& style, const std::vector<KeyEntry>& key) {
  const double left = frame.min.x() + margin, right = frame.max.x() - margin;
  const Head head(canvas, right - left, title, key, style);
  canvas.outline(frame.corners(), style.frame);
  const render::Box room{below_title(frame, style).min + Vec2(0, head.added_height()), frame.max};
  canvas.line(room.min, {room.max.x(), room.min.y()}, style.frame);
  Vec2 at(left, frame.min.y() + above_title + style.panel_title.size);
  canvas.text(at, head.words, head.title_text);
  if (head.begins_below) at.y() += head.pitch();
  for (const std::vector<KeyEntry>& line : head.lines) {
    const bool is_at_the_right = head.lines.size() == 1 && !head.begins_below;
    draw_line_of_key(head, line, {is_at_the_right ? right - head.width_of(line) : left - before_sign, at.y()});
    at.y() += head.pitch();
  }
  return room;
}

render::View view_in(const render::Box& room, const render::Box& frame, const render::View& view, const Style& style) {
  const render::Box whole = below_title(frame, style);
  return room.height() < whole.height() ? view.into(whole, room) : view;
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

KeyEntry key_of_stretch(const std::string& what, const Vec2& way, double factor, const Style& style) {
  const double half_length = 8, half_width = 4;
  return {what + " " + words_of_factor(factor),
          [=, &style](render::Canvas& canvas, const Vec2& at) {
            for (const double side : {-half_length, half_length})
              canvas.arrow(at, at + side * way, {style.theme.grey, 1.3 * style.theme.line});
          },
          way.x() != 0 ? half_length : half_width};
}

std::vector<KeyEntry> key_of_origin(double height, const Style& style) {
  const auto entry = [&style](const char* words, double inner) {
    return KeyEntry{words,
                    [&style, inner](render::Canvas& canvas, const Vec2& at) {
                      if (inner > 0) canvas.disc(at, inner, style.theme.ink);
                      canvas.circle(at, origin_radius - 1, {style.theme.ink, 2});
                    },
                    origin_radius};
  };
  if (height == 0) return {entry("O above", origin_radius), entry("in it", in_plane_radius), entry("below", 0)};
  return {entry("O above", origin_radius), entry("below", 0)};
}

void draw_origin_beside(render::Panel& panel, const Vec2& at, double height, const Style& style) {
  panel.disc(at, origin_radius + 2, style.theme.paper);
  if (height > 0) panel.disc(at, origin_radius, style.theme.ink);
  if (height == 0) panel.disc(at, in_plane_radius, style.theme.ink);
  panel.circle(at, origin_radius - 1, {style.theme.ink, 2});
}

}  // namespace walkthroughs::picture
