#include "walkthroughs/picture/footer.hpp"

#include <numeric>
#include <string>
#include <vector>

namespace walkthroughs {
namespace {

using render::Box;
using render::Canvas;
using render::TextStyle;
using render::Vec2;

// Page units.
constexpr double progress_width = 196, text_left = 210, mark_width = 34;
constexpr double first_line = 36, line_pitch = 30, small_pitch = 26, below_last_line = 6;
constexpr double sizes[] = {1, 0.88, 0.78, 0.68};  // of facts, the first that lets all of them fit

struct Line {
  std::string text;
  TextStyle style;
  double pitch;  ///< to the next
  double indent = 0;
  Fact::Mark mark = Fact::Mark::none;  ///< before it
};

void append(std::vector<Line>& lines, Canvas& canvas, const Line& line, double width) {
  for (const std::string& part : render::wrap(canvas, line.text, line.style, width - line.indent)) {
    lines.push_back(line);
    lines.back().text = part;
  }
}

std::vector<Line> lines_of_facts(Canvas& canvas, const Frame& frame, const Style& style, double size, double width) {
  std::vector<Line> lines;
  for (const Fact& fact : frame.facts) {
    const bool is_skipped = fact.mark == Fact::Mark::skipped;
    const bool is_bold = fact.mark == Fact::Mark::answer || fact.mark == Fact::Mark::truth;
    Line line{is_skipped ? "skipped " + fact.text : fact.text, is_skipped ? style.skipped : style.fact,
              size * (is_skipped ? small_pitch : line_pitch), mark_width};
    line.style.size *= size;
    if (is_bold) line.style.weight = render::Weight::bold;
    const std::size_t first = lines.size();
    append(lines, canvas, line, width);
    if (lines.size() > first) lines[first].mark = fact.mark;
  }
  return lines;
}

void draw_mark(Canvas& canvas, const Vec2& at, Fact::Mark mark, const Style& style) {
  TextStyle text{.size = 24, .weight = render::Weight::bold};
  text.color = mark == Fact::Mark::yes ? style.theme.green : style.theme.vermillion;
  if (mark == Fact::Mark::yes) canvas.text(at, "✓", text);
  if (mark == Fact::Mark::no) canvas.text(at, "✗", text);
  if (mark == Fact::Mark::truth) canvas.text(at, "≠", text);
}

double height_of(const std::vector<Line>& lines) {
  return std::accumulate(lines.begin(), lines.end(), 0.0,
                         [](double sum, const Line& line) { return sum + line.pitch; });
}

/// Returns: how many did not fit.
int draw_lines(Canvas& canvas, const Box& room, const std::vector<Line>& lines, const Style& style) {
  Vec2 at = room.min + Vec2(0, first_line);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (at.y() > room.max.y() - below_last_line) return static_cast<int>(lines.size() - i);
    draw_mark(canvas, at, lines[i].mark, style);
    canvas.text(at + Vec2(lines[i].indent, 0), lines[i].text, lines[i].style);
    at.y() += lines[i].pitch;
  }
  return 0;
}

/// "step n of N", the iteration and the simplex.
int draw_progress(Canvas& canvas, const Box& room, const StagedStory& story, std::size_t index, const Style& style) {
  const Frame& frame = story.frames[index];
  const TextStyle bold{.size = 24, .weight = render::Weight::bold, .color = style.theme.ink};
  std::vector<Line> lines;
  const auto write = [&](const std::string& text, const TextStyle& how) {
    append(lines, canvas, {text, how, line_pitch}, progress_width);
  };
  write("step " + std::to_string(index + 1) + " of " + std::to_string(story.frames.size()), bold);
  if (!frame.moments.empty()) {
    const bool in_float = story.tellings[0].scene.scalar == Scalar::binary32;
    write("iteration " + std::to_string(frame.moments[0].iteration) + (in_float ? ", in float" : ""), style.small);
  }
  if (frame.moments.size() == 1) {
    const Simplex& simplex = frame.moments[0].simplex;
    write(simplex.size() == 0 ? "no simplex yet" : "simplex " + story.names(index, 0).list(simplex), style.small);
  }
  return draw_lines(canvas, room, lines, style);
}

}  // namespace

int draw_footer(Canvas& canvas, const Box& room, const StagedStory& story, std::size_t index, const Style& style) {
  const Frame& frame = story.frames[index];
  const Box text{room.min + Vec2(text_left, 0), room.max};
  std::vector<Line> caption, facts;
  append(caption, canvas, {frame.caption, style.caption, line_pitch}, text.width());
  const double for_facts = text.height() - first_line - below_last_line - height_of(caption);
  for (const double size : sizes) {
    facts = lines_of_facts(canvas, frame, style, size, text.width());
    if (height_of(facts) - (facts.empty() ? 0 : facts.back().pitch) <= for_facts) break;
  }
  caption.insert(caption.end(), facts.begin(), facts.end());
  return draw_progress(canvas, room, story, index, style) + draw_lines(canvas, text, caption, style);
}

}  // namespace walkthroughs
