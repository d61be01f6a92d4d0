#include "walkthroughs/output/handout.hpp"

#include <algorithm>
#include <optional>
#include <variant>

#include "walkthroughs/story/iterations.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::output {
namespace {

using render::Box;
using render::Canvas;
using render::Size;
using render::TextStyle;
using render::Vec2;
using render::Weight;

// Points.
constexpr double column_gap = 8, row_gap = 5, rule = 0.7;
constexpr double number_column = 20;
constexpr double room_of_caption = 4;                  // sizes of its letters
constexpr double shares[] = {0.31, 0.39, 0.12, 0.18};  // of what the other columns have
constexpr const char* heads[] = {"support point along d", "what decided", "simplex kept", "next direction"};
constexpr double text_of_pictures = render::least_text_scale, least_side = 100;  // page units of a picture

/// How large letters and pictures are, and which rows have one, in the order in which that is tried.
struct Attempt {
  double letters, picture;
  bool of_all_rows = true;
};
constexpr Attempt attempts[] = {{9, 120}, {8.5, 108}, {8, 96}, {7.5, 84}, {8, 96, false}, {7.5, 0}, {7, 0}};

/// An iteration of a scene.
struct Row {
  std::size_t scene;
  IterationTold told;
  std::optional<std::size_t> frame;  ///< the last that shows it
};

/// The last frame in which the search of a scene is in that iteration; none where it is left out.
std::optional<std::size_t> last_frame_of(const Story& story, std::size_t scene, int iteration) {
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < story.frames.size(); ++i)
    if (story.frames[i].moments.at(scene).iteration == iteration) last = i;
  return last;
}

/// Where two searches have been the same only those of the first.
std::vector<Row> rows_of(const Story& story) {
  std::vector<Row> rows;
  for (std::size_t scene = 0; scene < story.tellings.size(); ++scene)
    for (const IterationTold& told : iterations_told(story, scene))
      if (scene == 0 || told.last >= story.parts_at.value_or(0))
        rows.push_back({scene, told, last_frame_of(story, scene, told.number)});
  return rows;
}

/// A page as it is filled from above; its page unit is a point.
class Page {
 public:
  Page(const StagedStory& story, const Look& look, render::Font& font, const Attempt& attempt)
      : story_(story), look_(look), font_(font), attempt_(attempt), handout_{{*paper_named("a4")}} {
    const Size size{static_cast<int>(handout_.paper.width), static_cast<int>(handout_.paper.height)};
    page_ = &handout_.canvases.emplace_back(size, size, look.style.theme.paper, font);
    handout_.pages.push_back({{page_, {{0, 0}, {handout_.paper.width, handout_.paper.height}}, {0, 0}, 1}});
    title();
  }

  bool is_full() const { return y_ > handout_.paper.height - margin; }
  Handout finished(std::size_t left_out) && {
    handout_.free_from = y_;
    handout_.left_out = left_out;
    return std::move(handout_);
  }

  void line(const std::string& text, Weight weight = Weight::regular) {
    y_ += write_lines(*page_, {margin, y_}, text, letters(weight), width() - beside_);
  }
  void gap() { y_ += row_gap; }

  /// In the upper right corner, where all pictures fit.
  void draw_objects() {
    if (attempt_.picture == 0 || !attempt_.of_all_rows) return;
    Look look = look_;
    look.style = style_with_text(render::most_text_scale);
    Canvas& canvas = handout_.canvases.emplace_back(objects_page, objects_page, look.style.theme.paper, font_);
    draw_objects_alone(canvas, story_, 0, 0, look);
    const double scale = least_points / smallest_letters(canvas), side = scale * objects_page.width;
    place(canvas, {{0, 0}, {objects_page.width, objects_page.height}}, {handout_.paper.width - margin - side, y_},
          scale);
    top_ends_ = y_ + side;
    beside_ = side + column_gap;
  }
  void end_top() {
    y_ = std::max(y_, top_ends_) + row_gap;
    beside_ = 0;
  }

  void table_head() {
    double height = 0;
    for (std::size_t i = 0; i < std::size(heads); ++i) height = std::max(height, write({heads[i]}, i, Weight::bold));
    y_ += height + row_gap / 2;
    page_->line({margin, y_}, {margin + width(), y_}, {look_.style.theme.grey, rule});
    y_ += row_gap;
  }

  void row(const Row& row, bool has_picture) {
    const IterationTold& told = row.told;
    page_->text({margin, y_ + attempt_.letters}, std::to_string(told.number), letters(Weight::bold));
    double height = has_picture && row.frame ? picture(row) : 0;
    const std::vector<std::string> cells[] = {told.found, told.decided, {told.simplex}, {told.next}};
    for (std::size_t i = 0; i < std::size(cells); ++i) height = std::max(height, write(cells[i], i, Weight::regular));
    y_ += height + row_gap;
    page_->line({margin, y_}, {margin + width(), y_}, {look_.style.theme.faint, rule});
    y_ += row_gap;
  }

  /// Those of a walkthrough, below each other, with their captions.
  void diagrams() {
    const double room = (handout_.paper.height - margin - y_) / static_cast<double>(story_.frames.size());
    const Box usual = pictures_of_frame(story_.walkthrough, {.text = Text::none});
    const double scale =
        std::min((room - room_of_caption * attempt_.letters) / usual.height(), width() / usual.width());
    Look look = look_;
    look.text = Text::none;
    for (const double text : {1.0, 1.2, render::most_text_scale}) {
      look.style = style_with_text(text);
      if (scale * smallest_letters_of_frames(look) >= least_points) break;
    }
    const Size page = page_of_frame(look);
    for (std::size_t i = 0; i < story_.frames.size(); ++i) {
      Canvas& canvas = handout_.canvases.emplace_back(page, page, look.style.theme.paper, font_);
      draw_frame(canvas, story_, i, look);
      place(canvas, usual, {margin, y_}, scale);
      y_ += scale * usual.height();
      line(story_.frames[i].caption);
      gap();
    }
  }

 private:
  double width() const { return handout_.paper.width - 2 * margin; }
  TextStyle letters(Weight weight) const {
    return {.size = attempt_.letters, .weight = weight, .color = look_.style.theme.ink};
  }

  Style style_with_text(double scale) const {
    render::Theme theme = look_.style.theme;
    theme.text = scale;
    return Style(theme);
  }

  double smallest_letters_of_frames(const Look& look) const {
    const Size page = page_of_frame(look);
    Canvas all(page, page, look.style.theme.paper, font_);
    for (std::size_t i = 0; i < story_.frames.size(); ++i) draw_frame(all, story_, i, look);
    return smallest_letters(all);
  }

  void title() {
    const std::string title = literal(story_.walkthrough.title);
    const TextStyle style{.size = title_size, .weight = Weight::bold, .color = look_.style.theme.ink};
    page_->text({margin, margin + title_size}, title, page_->fitted(title, style, width()));
    y_ = margin + 1.6 * title_size;
  }

  double left_of(std::size_t column) const {
    double left = margin + number_column + (attempt_.picture > 0 ? attempt_.picture + column_gap : 0);
    for (std::size_t i = 0; i < column; ++i) left += width_of(i) + column_gap;
    return left;
  }
  double width_of(std::size_t column) const {
    const double pictures = attempt_.picture > 0 ? attempt_.picture + column_gap : 0;
    return shares[column] * (width() - number_column - pictures - 3 * column_gap);
  }

  /// Returns: how high it is.
  double write(const std::vector<std::string>& lines, std::size_t column, Weight weight) {
    double height = 0;
    for (const std::string& text : lines)
      height += write_lines(*page_, {left_of(column), y_ + height}, text, letters(weight), width_of(column));
    return height;
  }

  /// Returns: how high it is.
  double picture(const Row& row) {
    Look look = look_;
    look.style = style_with_text(text_of_pictures);
    for (double letters = look.style.panel_title.size;;) {  // which may be smaller where there is less room
      const double scale = least_points / letters, side = attempt_.picture / scale;
      const Size page{static_cast<int>(side), static_cast<int>(side)};
      const Box box{{0, 0}, {side, side}};
      Canvas& canvas = handout_.canvases.emplace_back(page, page, look.style.theme.paper, font_);
      draw_small(canvas, box.grown(-1), story_, *row.frame, row.scene, look);
      const double drawn = smallest_letters(canvas);
      if (drawn >= letters || side < least_side) {
        place(canvas, box, {margin + number_column, y_}, scale);
        break;
      }
      letters = drawn;
      handout_.canvases.pop_back();
    }
    return attempt_.picture;
  }

  void place(const Canvas& canvas, const Box& part, const Vec2& corner, double scale) {
    handout_.pages[0].push_back({&canvas, part, corner, scale});
    ++handout_.pictures;
  }

  const StagedStory& story_;
  const Look& look_;
  render::Font& font_;
  const Attempt attempt_;
  Handout handout_;
  Canvas* page_;
  double y_ = 0, top_ends_ = 0, beside_ = 0;
};

/// The answer, and why; of two searches what is said of both at the end, and before that where they part.
void write_answer(Page& page, const Story& story) {
  const Frame& end = story.tellings.size() == 1 ? *story.tellings[0].said.back() : story.frames.back();
  page.line(end.caption, Weight::bold);
  if (const std::optional<std::size_t> parting = story.parting()) page.line(story.frames[*parting].caption);
  for (const Fact& fact : end.facts)
    if (!fact.is_in_caption && fact.mark != Fact::Mark::answer) page.line(fact.text);
}

/// Of few points all, so that what follows can be computed by hand.
std::string in_words(const Object& object, Dimension dimension) {
  constexpr std::size_t few = 8;
  const auto* const points = std::get_if<Points>(&object.form);
  const bool are_listed = points && points->size() <= few && object.pose == Pose{};
  return literal(object.name) + ": " +
         (are_listed ? joined(*points, ", ", [&](const Point& p) { return vector(p, dimension); })
                     : described(object.form, dimension));
}

/// What is asked and answered. Of one search the objects are drawn beside it.
void write_top(Page& page, const Story& story) {
  if (story.tellings.size() == 1 && story.tellings[0].panels.objects) page.draw_objects();
  if (story.walkthrough.summary != story.walkthrough.title) page.line(literal(story.walkthrough.summary));
  for (const Telling& telling : story.tellings) {
    const bool are_of_one_pair = story.tellings.size() == 1 || story.walkthrough.layout == Layout::until_they_part;
    const Scene& scene = telling.scene;
    page.line((are_of_one_pair ? "Objects: " : literal(scene.name) + ": ") + in_words(scene.a, scene.dimension) + "; " +
              in_words(scene.b, scene.dimension) + ".");
    if (are_of_one_pair) break;
  }
  page.gap();
  write_answer(page, story);
  page.end_top();
}

/// Of the rows of a scene, of which `row` is the first.
std::string heading(const Story& story, const Row& row) {
  const int same = row.told.number - 1;
  return literal(story.tellings[row.scene].scene.name) +
         (same > 0 ? ", the same up to iteration " + std::to_string(same) : "");
}

/// Returns: the page with so many of the rows, the first and the last; nothing where these do not fit, unless it is none.
std::optional<Handout> with_rows(const StagedStory& story, const std::vector<Row>& rows, std::size_t count,
                                 const Look& look, render::Font& font, const Attempt& attempt) {
  Page page(story, look, font, attempt);
  write_top(page, story);
  page.table_head();
  const std::size_t first = (count + 1) / 2, left_out = rows.size() - count;
  for (std::size_t i = 0; i < rows.size() && !page.is_full(); ++i) {
    if (story.tellings.size() > 1 && (i == 0 || rows[i].scene != rows[i - 1].scene))
      page.line(heading(story, rows[i]), Weight::bold);
    if (i == first && left_out > 0) {
      page.line(left_out == 1 ? "An iteration is left out here."
                              : std::to_string(left_out) + " iterations are left out here.");
      page.gap();
    }
    if (i >= first && i < first + left_out) continue;
    page.row(rows[i], attempt.picture > 0 && (attempt.of_all_rows || i == 0 || i + 1 == rows.size()));
  }
  if (story.walkthrough.naming == Naming::roles)
    page.line("P is the point just found. In the simplex it is A, the newest vertex.");
  page.line(
      "Each picture shows the end of its iteration: d is the next direction already. A simplex is written oldest "
      "vertex first.");
  if (page.is_full() && count > 0) return std::nullopt;
  return std::move(page).finished(left_out);
}

Handout of_diagrams(const StagedStory& story, const Look& look, render::Font& font) {
  Page page(story, look, font, attempts[0]);
  page.line(literal(story.walkthrough.summary));
  page.gap();
  page.diagrams();
  return std::move(page).finished(0);
}

}  // namespace

Handout handout_of(const StagedStory& story, const Look& look, render::Font& font) {
  if (story.walkthrough.layout == Layout::diagrams) return of_diagrams(story, look, font);
  const std::vector<Row> rows = rows_of(story);
  for (const Attempt& attempt : attempts)
    if (std::optional<Handout> page = with_rows(story, rows, rows.size(), look, font, attempt)) return std::move(*page);
  for (std::size_t count = rows.size() - 1; count > 0; --count)
    if (std::optional<Handout> page = with_rows(story, rows, count, look, font, std::end(attempts)[-1]))
      return std::move(*page);
  return *with_rows(story, rows, 0, look, font, std::end(attempts)[-1]);
}

OneFile handout() {
  const auto make = [](const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
    return pdf_of(handout_of(*story, output.look, renderer.font()), text_of(story->walkthrough),
                  output.look.style.theme.paper);
  };
  return {"handout.pdf", make};
}

}  // namespace walkthroughs::output
