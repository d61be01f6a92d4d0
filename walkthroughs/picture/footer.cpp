#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "walkthroughs/picture/draw.hpp"

namespace walkthroughs::picture {
namespace {

using render::Box;
using render::Canvas;
using render::TextStyle;
using render::Vec2;

// Page units.
constexpr double progress_width = 196, text_left = 210, mark_width = 34;
constexpr double first_line = 36, line_pitch = 30, small_pitch = 26, below_last_line = 6;
constexpr double top_of_column = 22;  // to its first line
// The first that let all lines fit: of facts beside the caption, and of both where larger text than usual was asked for.
constexpr double sizes_of_facts[] = {1, 0.88, 0.78, 0.68}, sizes_of_all[] = {1, 0.87, 0.76, 0.67};
constexpr double sizes_of_caption[] = {1.25, 1.1, 1, 0.9, 0.8, 0.7};  // of one that stands alone

struct Line {
  std::string text;
  TextStyle style;
  double pitch;  ///< to the next
  double indent = 0;
  Fact::Mark mark = Fact::Mark::none;  ///< before it
};

/// The mark stands before the first of the lines that it takes.
void append(std::vector<Line>& lines, Canvas& canvas, const Line& line, double width) {
  const std::size_t first = lines.size();
  for (const std::string& part : render::wrap(canvas, line.text, line.style, width - line.indent)) {
    lines.push_back(line);
    lines.back().text = part;
    if (lines.size() > first + 1) lines.back().mark = Fact::Mark::none;
  }
}

/// The caption, after the mark of the number that it begins with.
void append_caption(std::vector<Line>& lines, Canvas& canvas, const Frame& frame, const Style& style, double size,
                    double width) {
  const Fact::Mark mark = frame.mark();
  Line line{frame.caption, style.caption, size * style.scaled(line_pitch),
            mark == Fact::Mark::none ? 0 : style.scaled(mark_width), mark};
  line.style.size *= size;
  append(lines, canvas, line, width);
}

void append_facts(std::vector<Line>& lines, Canvas& canvas, const Frame& frame, const Style& style, double size,
                  double width) {
  for (const Fact& fact : frame.facts) {
    if (fact.is_in_caption) continue;
    const bool is_skipped = fact.mark == Fact::Mark::skipped;
    const bool is_bold = fact.mark == Fact::Mark::answer || fact.mark == Fact::Mark::truth;
    Line line{is_skipped ? "skipped " + fact.text : fact.text, is_skipped ? style.skipped : style.fact,
              size * style.scaled(is_skipped ? small_pitch : line_pitch), style.scaled(mark_width), fact.mark};
    line.style.size *= size;
    if (is_bold) line.style.weight = render::Weight::bold;
    append(lines, canvas, line, width);
  }
}

void draw_mark(Canvas& canvas, const Vec2& at, Fact::Mark mark, const Style& style) {
  TextStyle text{.size = style.scaled(24), .weight = render::Weight::bold};
  text.color = mark == Fact::Mark::yes ? style.theme.green : style.theme.vermillion;
  if (mark == Fact::Mark::yes) canvas.text(at, "✓", text);
  if (mark == Fact::Mark::no) canvas.text(at, "✗", text);
  if (mark == Fact::Mark::truth) canvas.text(at, "≠", text);
}

double height_of(const std::vector<Line>& lines) {
  return std::accumulate(lines.begin(), lines.end(), 0.0,
                         [](double sum, const Line& line) { return sum + line.pitch; });
}

bool fit_into(const Box& room, const std::vector<Line>& lines, const Style& style) {
  return height_of(lines) - lines.back().pitch <= room.height() - style.scaled(first_line) - below_last_line;
}

/// Those that fit.
void draw_lines(Canvas& canvas, const Box& room, const std::vector<Line>& lines, const Style& style) {
  Vec2 at = room.min + Vec2(0, style.scaled(first_line));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (at.y() > room.max.y() - below_last_line) return canvas.add_crowded(static_cast<int>(lines.size() - i));
    draw_mark(canvas, at, lines[i].mark, style);
    canvas.text(at + Vec2(lines[i].indent, 0), lines[i].text, lines[i].style);
    at.y() += lines[i].pitch;
  }
}

/// The iteration and the simplex.
std::vector<std::string> state_of_search(const StagedStory& story, std::size_t index) {
  const Frame& frame = story.frames[index];
  std::vector<std::string> words;
  if (!frame.moments.empty()) {
    const bool in_float = story.tellings[0].scene.scalar == Scalar::binary32;
    const std::vector<int> iterations = frame.iterations();
    words.push_back((iterations.size() > 1 ? "iterations " : "iteration ") +
                    joined(iterations, " and ", [](int each) { return std::to_string(each); }) +
                    (in_float ? ", in float" : ""));
  }
  if (frame.moments.size() == 1) {
    const Simplex& simplex = frame.moments[0].simplex;
    words.push_back(simplex.size() == 0 ? "no simplex yet" : "simplex " + story.names(index, 0).list(simplex));
  }
  return words;
}

/// "step n of N", the iteration and the simplex.
void draw_progress(Canvas& canvas, const Box& room, const StagedStory& story, std::size_t index, const Style& style) {
  const TextStyle bold{.size = style.scaled(24), .weight = render::Weight::bold, .color = style.theme.ink};
  std::vector<Line> lines;
  const auto write = [&](const std::string& text, const TextStyle& how) {
    append(lines, canvas, {text, how, style.scaled(line_pitch)}, style.scaled(progress_width));
  };
  write("step " + std::to_string(index + 1) + " of " + std::to_string(story.frames.size()), bold);
  for (const std::string& words : state_of_search(story, index)) write(words, style.small);
  draw_lines(canvas, room, lines, style);
}

/// The caption and the facts, as large as they fit, but not smaller than at the usual scale of text.
std::vector<Line> fitting_lines(Canvas& canvas, const Box& room, const Frame& frame, const Style& style) {
  std::vector<Line> lines;
  for (const double size_of_all : sizes_of_all) {
    const double size = std::min(1.0, std::max(size_of_all, 1 / style.theme.text));
    for (const double size_of_facts : sizes_of_facts) {
      lines.clear();
      append_caption(lines, canvas, frame, style, size, room.width());
      append_facts(lines, canvas, frame, style, size * size_of_facts, room.width());
      if (fit_into(room, lines, style)) return lines;
    }
  }
  return lines;
}

}  // namespace

void draw_footer(Canvas& canvas, const Box& room, const StagedStory& story, std::size_t index, const Style& style) {
  const Box text{room.min + Vec2(style.scaled(text_left), 0), room.max};
  const std::vector<Line> lines = fitting_lines(canvas, text, story.frames[index], style);
  draw_progress(canvas, room, story, index, style);
  draw_lines(canvas, text, lines, style);
}

void draw_caption(Canvas& canvas, const Box& room, const Frame& frame, const Style& style) {
  std::vector<Line> lines;
  for (const double size : sizes_of_caption) {
    lines.clear();
    append_caption(lines, canvas, frame, style, size, room.width());
    if (fit_into(room, lines, style)) break;
  }
  draw_lines(canvas, room, lines, style);
}

std::string state_in_words(const StagedStory& story, std::size_t index) {
  return joined(state_of_search(story, index), " · ");
}

double draw_words(Canvas& canvas, double width, const StagedStory& story, std::size_t index, const Style& style) {
  const Frame& frame = story.frames[index];
  const std::string words = state_in_words(story, index);
  const std::string state = "step " + std::to_string(index + 1) + (words.empty() ? "" : " · ") + words;
  std::vector<Line> lines;
  append(lines, canvas, {state, style.small, style.scaled(line_pitch)}, width);
  append_caption(lines, canvas, frame, style, 1, width);
  append_facts(lines, canvas, frame, style, 1, width);
  const double height = height_of(lines) + below_last_line;
  draw_lines(canvas, {{0, style.scaled(top_of_column - first_line)}, {width, height + style.scaled(line_pitch)}}, lines,
             style);
  return height;
}

}  // namespace walkthroughs::picture
