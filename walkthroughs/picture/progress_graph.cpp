#include "walkthroughs/picture/progress_graph.hpp"

#include <algorithm>
#include <cmath>

#include "walkthroughs/picture/panel_title.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::picture {
namespace {

using render::Align;
using render::Box;
using render::Vec2;

// Page units.
constexpr double letter_size = 13, graph_margin = 14, gap = 6, mark_radius = 5, dot_width = 7, least_step = 2;
constexpr int most_dots = 24, most_ticks = 60;  // iterations
constexpr double foot_of_powers = 0.2;          // of the height, between 0 and the lowest power of ten
constexpr double span_of_powers = 1000;         // from which on heights are powers of ten

/// Without the last digits, which libraries round in their own ways: pages and files are to have the same bytes.
double log_of(double x) { return std::round(std::log10(x) * 0x1p20) * 0x1p-20; }

/// Where a distance is drawn, 0 at the foot and 1 on top, and which distances the axis names.
class Heights {
 public:
  explicit Heights(const std::vector<ProgressLine>& lines) {
    double least = 0;
    for (const ProgressLine& line : lines)
      for (const Progress& each : line.all) {
        high_ = std::max(high_, each.distance);
        if (each.distance > 0 && (least == 0 || each.distance < least)) least = each.distance;
      }
    if (high_ == 0) high_ = least = 1;
    are_powers_ = high_ / least > span_of_powers;
    if (are_powers_)
      name_powers(std::floor(log_of(least)), std::ceil(log_of(high_)));
    else
      name_steps();
  }

  double operator()(double distance) const {
    if (!are_powers_ || distance == 0) return distance / high_;
    return foot_of_powers + (1 - foot_of_powers) * (log_of(distance) - low_) / (high_ - low_);
  }
  const std::vector<double>& named() const { return named_; }
  bool are_powers() const { return are_powers_; }

 private:
  /// 0 and whole steps of 1, 2 or 5 in their power of ten, up to three.
  void name_steps() {
    const double power = std::pow(10, std::floor(log_of(high_))), first = high_ / power;
    const double step = power * (first < 2 ? 0.5 : first < 4 ? 1 : first < 8 ? 2 : 5);
    for (int i = 0; i < 4 && i * step <= high_; ++i) named_.push_back(i * step);
  }
  /// 0 and powers of ten, at most four.
  void name_powers(double low, double high) {
    low_ = low, high_ = high, named_ = {0};
    for (double power = low; power <= high; power += std::ceil((high - low) / 3)) named_.push_back(std::pow(10, power));
  }

  bool are_powers_ = false;
  double low_ = 0, high_ = 0;  // of powers their exponents
  std::vector<double> named_;
};

class Graph {
 public:
  Graph(render::Canvas& canvas, const Box& room, const std::vector<ProgressLine>& lines, const Style& style,
        const Heights& heights)
      : canvas_(canvas), lines_(lines), style_(style), heights_(heights) {
    double widest = 0;
    for (const double distance : heights.named())
      widest = std::max(widest, canvas.width(short_number(distance), text(Align::right)));
    for (const ProgressLine& line : lines)
      if (!line.all.empty()) last_ = std::max(last_, line.all.back().iteration);
    plot_ = {room.min + Vec2(gap + widest + 2 * gap, mark_radius + gap + letters()),
             room.max - Vec2(2 * graph_margin, 2 * gap + letters())};
  }

  void draw() {
    axes();
    for (std::size_t i = lines_.size(); i-- > 0;) line(lines_[i], is_dashed(i));
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (lines_[i].known > 0) mark(canvas_, at(now(lines_[i])), is_dashed(i), style_);
    for (const ProgressLine& line : lines_)
      if (line.known > 0) written_.push_back(Box{at(now(line)), at(now(line))}.grown(mark_radius));
    for (const ProgressLine& line : lines_)
      if (line.known > 0) present(now(line));
    for (const int end : {last_, 1}) number_of(end, text(Align::center));
  }

  /// The sign of a search: a disc, or of the dashed one a square.
  static void mark(render::Canvas& canvas, const Vec2& at, bool is_dashed, const Style& style) {
    if (!is_dashed) return canvas.disc(at, mark_radius, style.theme.green);
    canvas.rectangle(Box{at, at}.grown(mark_radius), style.theme.vermillion);
  }

 private:
  bool is_dashed(std::size_t line) const { return lines_.size() > 1 && line == 0; }
  static const Progress& now(const ProgressLine& line) { return line.all[line.known - 1]; }
  double letters() const { return style_.scaled(letter_size); }
  render::TextStyle text(Align align, render::Weight weight = render::Weight::regular) const {
    const bool is_present = weight == render::Weight::bold;
    return {.size = letters(),
            .weight = weight,
            .color = is_present ? style_.theme.ink : style_.theme.grey,
            .align = align,
            .halo = is_present ? style_.theme.paper : render::Color{0, 0, 0, 0}};
  }
  double x_of(int iteration) const {
    const double share = last_ > 1 ? (iteration - 1.0) / (last_ - 1) : 0.5;
    return plot_.min.x() + share * plot_.width();
  }
  Vec2 at(const Progress& progress) const { return {x_of(progress.iteration), y_of(progress.distance)}; }

  double y_of(double distance) const { return plot_.max.y() - heights_(distance) * plot_.height(); }

  void axes() {
    for (const double distance : heights_.named())
      canvas_.line({plot_.min.x(), y_of(distance)}, {plot_.max.x(), y_of(distance)}, style_.grid);
    for (const double distance : heights_.named())
      canvas_.text({plot_.min.x() - gap - mark_radius, y_of(distance) + letters() / 3}, short_number(distance),
                   text(Align::right));
    const render::Stroke axis{style_.theme.grey, 1};
    canvas_.line({plot_.min.x(), plot_.max.y()}, plot_.max, axis);
    for (int i = 1; i <= last_ && last_ <= most_ticks; ++i)
      canvas_.line({x_of(i), plot_.max.y()}, {x_of(i), plot_.max.y() + 3}, axis);
  }

  /// The iterations known. The exact fallback begins anew, so no line leads there.
  void line(const ProgressLine& line, bool is_dashed) {
    render::Stroke stroke{is_dashed ? style_.theme.vermillion : style_.theme.green, 2.5 * style_.theme.line};
    if (is_dashed) stroke.dash = {7, 6};
    if (line.known > 0) lead_back(line);
    std::vector<Vec2> corners;
    for (std::size_t k = 0; k < line.known; ++k) {
      const Vec2 here = at(line.all[k]);
      if (k > 0 && line.all[k].is_fallback != line.all[k - 1].is_fallback) {
        canvas_.polyline(corners, stroke);
        corners.clear();
      }
      if (corners.empty() || k + 1 == line.known || here.x() - corners.back().x() >= least_step)
        corners.push_back(here);
    }
    if (corners.empty()) return;
    canvas_.polyline(corners, stroke);
    for (std::size_t k = 0; k + 1 < line.known && last_ <= most_dots; ++k)
      canvas_.polyline(std::vector{at(line.all[k])}, {stroke.color, dot_width});
  }

  /// To the last iteration before that was as far away.
  void lead_back(const ProgressLine& line) {
    for (std::size_t k = line.known - 1; k-- > 0;)
      if (line.all[k].nearest == now(line).nearest && line.all[k].is_fallback == now(line).is_fallback)
        return canvas_.line(at(line.all[k]), at(now(line)), {style_.theme.grey, 1.5, {2, 5}});
  }

  /// Its distance where there is room around its mark, best where no falling line comes from, and its number. Where both searches
  /// are at one place it is told once.
  void present(const Progress& progress) {
    const Vec2 place = at(progress);
    const render::TextStyle bold = text(Align::center, render::Weight::bold);
    const std::string distance = short_number(progress.distance);
    const double half = canvas_.width(distance, bold) / 2, low = letters() / 3;
    const double above = -mark_radius - 4, below = mark_radius + letters(), side = mark_radius + gap + half;
    const bool is_told = std::ranges::count(presented_, place) > 0;
    for (const Vec2& from : {Vec2(half, above), Vec2(0, above), Vec2(0, below), Vec2(side, low), Vec2(-side, low)}) {
      const double x = std::clamp(place.x() + from.x(), plot_.min.x() + half, plot_.max.x() + graph_margin - half);
      const bool is_above_axis = place.y() + from.y() <= plot_.max.y() + low;
      if (!is_told && is_above_axis && write(distance, {x, place.y() + from.y()}, bold)) break;
    }
    presented_.push_back(place);
    number_of(progress.iteration, bold);
  }

  void number_of(int iteration, const render::TextStyle& how) {
    write(std::to_string(iteration), {x_of(iteration), plot_.max.y() + gap + letters()}, how);
  }

  /// Returns: whether there was room.
  bool write(const std::string& words, const Vec2& where, const render::TextStyle& how) {
    const Box box = canvas_.ink_box(where, words, how).grown(render::halo_width);
    if (std::ranges::any_of(written_, [&](const Box& other) { return other.overlaps(box); })) return false;
    written_.push_back(box);
    canvas_.text(where, words, how);
    return true;
  }

  render::Canvas& canvas_;
  const std::vector<ProgressLine>& lines_;
  const Style& style_;
  const Heights& heights_;
  Box plot_;
  int last_ = 1;
  std::vector<Box> written_;
  std::vector<Vec2> presented_;
};

}  // namespace

void draw_progress(render::Canvas& canvas, const std::vector<ProgressLine>& lines, const Style& style) {
  Style small = style;
  small.panel_title.size = style.scaled(letter_size);
  std::vector<KeyEntry> key;
  for (std::size_t i = 0; lines.size() > 1 && i < lines.size(); ++i)
    key.push_back(
        {lines[i].name,
         [&style, is_dashed = i == 0](render::Canvas& on, const Vec2& at) { Graph::mark(on, at, is_dashed, style); },
         mark_radius, true});
  const Heights heights(lines);
  const Box page{Vec2(1, 1), Vec2(progress_page.width - 1, progress_page.height - 1)};
  const Box room = draw_panel_title(
      canvas, page,
      heights.are_powers() ? "kept simplex: distance from O, powers of ten" : "kept simplex: distance from O", small,
      key);
  Graph(canvas, room, lines, style, heights).draw();
}

}  // namespace walkthroughs::picture
