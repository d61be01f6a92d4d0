#include "render/panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace render {
namespace {

// Page units.
constexpr double frame_margin = 4;     // between a label and the frame
constexpr double line_clearance = 4;   // between a label and an obstacle
constexpr double label_clearance = 6;  // between two labels, at least
constexpr double label_comfort = 16;   // between two labels, if there is room
constexpr std::array spreads = {1.0, 1.3, 1.6, 2.0, 2.6,
                                3.2, 4.0, 4.7, 5.5};  // multiples of a label's gap, in the order tried
constexpr std::array area_clearances = {8.0, 12.0};   // between the name of an area and obstacles, if there is room
constexpr double area_pitch = 3;                      // between the places tried for it
constexpr double leader_from = 30;  // a label farther from its anchor than this is tied to it by a line
constexpr double leader_width = 1.2, leader_gap = 3;  // between the line and what it ties
constexpr double anchor_radius = 8;                   // of what usually stands at an anchor
constexpr double min_grid_spacing = 3;
constexpr double most_page_units = 1e5, beyond_frame = 100;  // farther out shapes are cut off near the frame
constexpr double least_obstacle = 2;                         // the width of a line that labels must keep clear of
constexpr double small_area_name = 0.8;                      // the size of a name that would not fit else
constexpr double next_smaller = 0.93;                        // the sizes in which labels are tried
constexpr double beside_area_gap = 34;  // between the middle of an area and its name outside: far enough for a leader

constexpr int directions = 32;
constexpr int circle_sides = 16;

// Costs of a place for a label, least is best. A cut-off label is worse than one across another, that is worse than one
// across a line; only among equals does it count how far the label strays, in distance and in direction.
constexpr double cost_outside = 1e6;
constexpr double cost_label = 1e4;
constexpr double cost_obstacle = 1e2;
constexpr double cost_near_label = 30;  // within its comfort: rather that than across a line
constexpr double cost_near = 10;        // for the name of an area: less than any overlap
constexpr double cost_fine_line = 4, most_fine_lines = 5;
constexpr double cost_elsewhere = 20;  // nearer to what another label names
constexpr double cost_across = 60;     // a line between the label and its anchor: less than over the line
constexpr double cost_gap = 1.5;
constexpr double cost_turn = 0.5;

/// Returns how many steps of 1/32 turn direction number `attempt` is away from the wanted one: 0, 1, -1, 2, -2, ...
constexpr int turns_of(int attempt) { return attempt % 2 == 1 ? (attempt + 1) / 2 : -attempt / 2; }

Vec2 from_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Returns: `v` turned by so many steps of 1/32 turn.
Vec2 rotated(const Vec2& v, int turns) {
  static const std::vector<Vec2> steps = [] {
    std::vector<Vec2> all;
    for (int turn = -directions / 2; turn <= directions / 2; ++turn)
      all.push_back(from_angle(2 * std::numbers::pi * turn / directions));
    return all;
  }();
  const Vec2& by = steps[static_cast<std::size_t>(turns + directions / 2)];
  return {by.x() * v.x() - by.y() * v.y(), by.y() * v.x() + by.x() * v.y()};
}

/// Returns how far the middle of a box of size 2 * `half` must be from a point, in direction `unit`, to keep `gap` away.
double distance_clear_of(const Vec2& half, const Vec2& unit, double gap) {
  const auto along = [&](int axis) {
    return unit[axis] == 0 ? std::numeric_limits<double>::infinity() : (half[axis] + gap) / std::abs(unit[axis]);
  };
  return std::min(along(0), along(1));
}

std::vector<double> multiples_between(double low, double high, double step) {
  const double first = std::ceil(low / step);
  const int count = static_cast<int>(std::floor(high / step) - first) + 1;
  std::vector<double> multiples;
  for (int i = 0; i < count; ++i) multiples.push_back((first + i) * step);
  return multiples;
}

bool contains(const Box& outer, const Box& inner) {
  return (inner.min.array() >= outer.min.array()).all() && (inner.max.array() <= outer.max.array()).all();
}

/// Requires: a convex polygon of either sense.
bool contains(std::span<const Vec2> corners, const Vec2& point) {
  int left = 0, right = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double side = turn(corners[(i + 1) % corners.size()] - corners[i], point - corners[i]);
    left += side > 0;
    right += side < 0;
  }
  return left == 0 || right == 0;
}

bool reaches_far(std::span<const Vec2> page) {
  return std::ranges::any_of(page, [](const Vec2& p) { return p.cwiseAbs().maxCoeff() > most_page_units; });
}

bool contains(std::span<const Vec2> corners, const Box& box) {
  return std::ranges::all_of(box.corners(), [&](const Vec2& corner) { return contains(corners, corner); });
}

Vec2 middle_of(std::span<const Vec2> corners) {
  Vec2 middle = Vec2::Zero();
  for (const Vec2& corner : corners) middle += corner / static_cast<double>(corners.size());
  return middle;
}

TextStyle centered(TextStyle style) {
  style.align = Align::center;
  return style;
}

/// Whether two points lie on either side of the line through `from` and `to`; not where rounding may have put one there.
bool are_apart(const Vec2& from, const Vec2& to, const Vec2& p, const Vec2& q) {
  constexpr double least = 1e-6;  // page units
  const Vec2 along = to - from;
  const double length = along.norm();
  const auto distance = [&](const Vec2& point) { return turn(along, point - from) / length; };
  const double of_p = distance(p), of_q = distance(q);
  return (of_p > least && of_q < -least) || (of_p < -least && of_q > least);
}

Box moved(const Box& box, const Vec2& by) { return {box.min + by, box.max + by}; }

}  // namespace

// ---------------------------------------------------------------------------------------------- View

View View::fit(const Vec2& low, const Vec2& high, const Box& frame, double max_scale) {
  View view;
  view.center_scene_ = (low + high) / 2;
  view.center_page_ = frame.center();
  view.scale_ = max_scale;
  const Vec2 size = high - low;
  if (size.x() > 0) view.scale_ = std::min(view.scale_, frame.width() / size.x());
  if (size.y() > 0) view.scale_ = std::min(view.scale_, frame.height() / size.y());
  return view;
}

View View::into(const Box& from, const Box& to) const {
  View view = *this;
  view.center_scene_ = scene(from.center());
  view.center_page_ = to.center();
  view.scale_ *= std::min(to.width() / from.width(), to.height() / from.height());
  return view;
}

// ---------------------------------------------------------------------------------------------- shapes

Panel::Panel(Canvas& canvas, const Box& frame, const View& view) : canvas_(canvas), frame_(frame), view_(view) {
  canvas_.clip(frame_);
}

Panel::~Panel() { canvas_.unclip(); }

void Panel::polygon(std::span<const Vec2> corners, Color fill) {
  const std::vector<Vec2> page = to_page(corners);
  const std::vector<Vec2> seen = reaches_far(page) ? clip_polygon(page, frame_.grown(beyond_frame)) : page;
  if (seen.size() > 2) canvas_.polygon(seen, fill);
}

void Panel::line(const Vec2& from, const Vec2& to, const Stroke& stroke) {
  Vec2 page_from = view_.page(from), page_to = view_.page(to);
  if (reaches_far(std::array{page_from, page_to})) {
    const std::optional<Interval> seen = clip_segment(page_from, page_to, frame_.grown(beyond_frame));
    if (!seen) return;
    const Vec2 way = page_to - page_from;
    page_to = page_from + way * seen->to;
    page_from += way * seen->from;
  }
  canvas_.line(page_from, page_to, stroke);
  avoid({page_from, page_to, stroke.width / 2});
}

void Panel::outline(std::span<const Vec2> corners, const Stroke& stroke) {
  const std::vector<Vec2> page = to_page(corners);
  canvas_.outline(page, stroke);
  avoid_outline(page, stroke.width / 2);
}

void Panel::arrow(const Vec2& from, const Vec2& to, const Stroke& stroke) {
  const Vec2 tail = view_.page(from), tip = view_.page(to);
  canvas_.arrow(tail, tip, stroke);
  obstacles_.push_back({tail, tip, stroke.width / 2});
  const Vec2 head = (tip - tail).stableNormalized() * (arrow_head::length * stroke.width);
  obstacles_.push_back({tip - head, tip - head / 2, arrow_head::width / 2 * stroke.width});
}

void Panel::disc(const Vec2& center, double radius, Color fill) {
  canvas_.disc(view_.page(center), radius, fill);
  obstacles_.push_back({view_.page(center), view_.page(center), radius});
}

void Panel::circle(const Vec2& center, double radius, const Stroke& stroke) {
  const Vec2 middle = view_.page(center);
  canvas_.circle(middle, radius, stroke);
  std::vector<Vec2> sides;
  for (int i = 0; i < circle_sides; ++i) {
    sides.push_back(middle + radius * from_angle(2 * std::numbers::pi * i / circle_sides));
  }
  avoid_outline(sides, stroke.width / 2);
}

void Panel::plus(const Vec2& center, double half, const Stroke& stroke) {
  const Vec2 middle = view_.page(center);
  canvas_.plus(middle, half, stroke);
  for (const Vec2& arm : {Vec2(half, 0), Vec2(0, half)}) {
    obstacles_.push_back({middle - arm, middle + arm, stroke.width / 2});
  }
}

void Panel::grid(double step, const Stroke& stroke, const Vec2& through) {
  if (!(step * view_.scale() >= min_grid_spacing)) return;  // it would be a grey area
  const Vec2 low = view_.scene({frame_.min.x(), frame_.max.y()});
  const Vec2 high = view_.scene({frame_.max.x(), frame_.min.y()});
  for (const double x : multiples_between(low.x() - through.x(), high.x() - through.x(), step)) {
    canvas_.line(view_.page({x + through.x(), low.y()}), view_.page({x + through.x(), high.y()}), stroke);
  }
  for (const double y : multiples_between(low.y() - through.y(), high.y() - through.y(), step)) {
    canvas_.line(view_.page({low.x(), y + through.y()}), view_.page({high.x(), y + through.y()}), stroke);
  }
}

// A line at 45 degrees is where x + y is constant; it crosses the border of a convex area twice or not at all.
void Panel::hatch(std::span<const Vec2> corners, double spacing, const Stroke& stroke) {
  const std::vector<Vec2> page = to_page(corners);
  const bool finite = std::ranges::all_of(page, [](const Vec2& corner) { return corner.allFinite(); });
  if (!finite || !(spacing >= min_grid_spacing)) return;  // closer together they would be a grey area
  const std::vector<Vec2> area = clip_polygon(page, frame_);
  if (area.empty()) return;
  const auto level = [](const Vec2& p) { return p.x() + p.y(); };
  const Vec2& lowest = *std::ranges::min_element(area, {}, level);
  const Vec2& highest = *std::ranges::max_element(area, {}, level);
  for (const double at : multiples_between(level(lowest), level(highest), spacing)) {
    std::vector<Vec2> crossings;
    for (std::size_t i = 0; i < area.size(); ++i) {
      const Vec2 &from = area[i], &to = area[(i + 1) % area.size()];
      if ((level(from) < at) != (level(to) < at))
        crossings.push_back(from + (to - from) * ((at - level(from)) / (level(to) - level(from))));
    }
    if (crossings.size() == 2) canvas_.line(crossings[0], crossings[1], stroke);
  }
}

std::vector<Vec2> Panel::corners() const {
  return Box::around(std::array{view_.scene(frame_.min), view_.scene(frame_.max)}).corners();
}

std::vector<Vec2> Panel::to_page(std::span<const Vec2> scene) const {
  std::vector<Vec2> page;
  for (const Vec2& point : scene) page.push_back(view_.page(point));
  return page;
}

void Panel::avoid_outline(std::span<const Vec2> page, double radius) {
  for (std::size_t i = 0; i < page.size(); ++i) {
    avoid({page[i], page[(i + 1) % page.size()], radius});
  }
}

void Panel::avoid(const Obstacle& obstacle) {
  (2 * obstacle.radius < least_obstacle ? fine_lines_ : obstacles_).push_back(obstacle);
}

bool Panel::holds(const Vec2& point, double margin) const {
  const Box within = frame_.grown(-margin);
  const Vec2 at = view_.page(point);
  return (at.array() >= within.min.array() && at.array() <= within.max.array()).all();
}

// ---------------------------------------------------------------------------------------------- labels

void Panel::label(const Vec2& anchor, const Vec2& toward, std::string text, const TextStyle& style, double gap) {
  const Vec2 up_right = Vec2(1, -1).normalized();
  const Vec2 wanted = Vec2(toward.x(), -toward.y()).stableNormalized();
  const TextStyle fitted = canvas_.fitted(text, centered(style), frame_.grown(-frame_margin).width());
  labels_.push_back({view_.page(anchor), wanted.isZero() ? up_right : wanted, std::move(text), fitted, gap});
}

void Panel::label_on_its_side(const Vec2& anchor, const Vec2& toward, std::string text, const TextStyle& style) {
  label(anchor, toward, std::move(text), style);
  labels_.back().stays_on_its_side = true;
}

void Panel::name_area(std::span<const Vec2> corners, std::string text, const TextStyle& style,
                      std::vector<std::string> shorter) {
  area_names_.push_back({to_page(corners), std::move(text), std::move(shorter), centered(style)});
}

void Panel::drop_labels() {
  labels_.clear();
  area_names_.clear();
}

/// All labels where they are to be drawn, at one size of their own; the names of areas perhaps smaller.
class Panel::Arrangement {
 public:
  /// Points first: their names have the least choice.
  Arrangement(const Panel& panel, double size, double smallest)
      : panel_(&panel), obstacles_(panel.obstacles_), taken_(panel.kept_clear_), groups_(1) {
    const auto sized = [size](auto label) {
      label.style.size *= size;
      return label;
    };
    for (const Label& label : panel.labels_)
      if (const Label now = sized(label); is_in_sight(now)) place(now);
    for (const AreaName& usual : panel.area_names_) {
      AreaName area = sized(usual);
      const bool fits = shorten(area, smallest / size);
      if (area.text.empty()) continue;
      groups_.emplace_back();
      if (fits)
        place(area);
      else
        place(Label{middle_of(area.corners), Vec2(0, -1), area.text, area.style, beside_area_gap});
    }
  }

  /// Returns: how many labels are not clear of lines, of each other, and of the frame.
  int crowded() const { return crowded_; }

  void draw(Canvas& canvas) const {
    for (const std::vector<PlacedLabel>& group : groups_) {
      for (const auto& [place, text, style] : group)
        if (place.leader) canvas.line(place.leader->first, place.leader->second, {style.color, leader_width});
      for (const auto& [place, text, style] : group) canvas.text(place.baseline, text, style);
    }
  }

 private:
  using Leader = std::optional<std::pair<Vec2, Vec2>>;
  struct Place {
    Vec2 baseline = Vec2::Zero();  // its middle
    Box box;                       // of the letters
    bool clear = false;            // of everything else
    Leader leader = {};            // the thin line that ties a label to its anchor where it stands far from it
  };
  struct PlacedLabel {
    Place place;
    std::string text;
    TextStyle style;
  };

  /// Puts a label or the name of an area into the last group.
  void place(const auto& label) {
    const Place best = best_place(label);
    groups_.back().push_back({best, label.text, label.style});
    taken_.push_back(best.box);
    crowded_ += best.clear ? 0 : 1;
    if (best.leader) obstacles_.push_back({best.leader->first, best.leader->second, leader_width / 2});
  }

  static Leader leader_of(const Label& label, const Box& box) {
    const Vec2 end = label.anchor.cwiseMax(box.min).cwiseMin(box.max), way = end - label.anchor;
    if (!(way.norm() > leader_from)) return std::nullopt;
    const Vec2 unit = way.normalized();
    return std::pair{label.anchor + unit * (anchor_radius + leader_gap), end - unit * leader_gap};
  }

  /// Makes the name fit, rather down to `smallest` of its size than with fewer words. Returns: whether it does.
  bool shorten(AreaName& area, double smallest) const {
    const double usual = area.style.size;
    const auto fits = [&](double size) {
      area.style.size = usual * size;
      return best_place(area).clear;
    };
    if (area.shorter.empty() || fits(1) || (smallest < 1 && fits(smallest))) return true;
    for (const std::string& text : area.shorter) {
      area.text = text;
      if (text.empty() || fits(1) || fits(small_area_name) || (smallest < 1 && fits(smallest * small_area_name)))
        return true;
    }
    area.text = area.shorter.front();
    return false;
  }

  Place best_place(const AreaName& area) const {
    const Box ink = panel_->canvas_.ink_box(Vec2::Zero(), area.text, area.style);
    const Vec2 middle = middle_of(area.corners);
    const Box around = Box::around(area.corners);
    Place best{middle, moved(ink, middle), false};
    double least = std::numeric_limits<double>::infinity();
    const Box tried{around.min.cwiseMax(panel_->frame_.min), around.max.cwiseMin(panel_->frame_.max)};
    for (double y = tried.min.y(); y <= tried.max.y(); y += area_pitch) {
      for (double x = tried.min.x(); x <= tried.max.x(); x += area_pitch) {
        const Box box = moved(ink, {x, y});
        double cost = (box.center() - middle).norm() / area_pitch;
        if (cost >= least || !contains(area.corners, box)) continue;
        const double overlap = cost_of(box);
        cost += overlap;
        if (cost > least) continue;
        for (const double clearance : area_clearances) cost += cost_near * count_near(box, obstacles_, clearance);
        if (cost >= least) continue;
        least = cost;
        best = {{x, y}, box, overlap < cost_obstacle};
      }
    }
    return best;
  }

  // A label is placed by the middle of its capitals: that keeps "p" and "p_1" on one line beside points of one height.
  Place best_place(const Label& label) const {
    const Place best = best_place(label, Leave::allowed);
    return is_whole(best) ? best : best_place(label, Leave::forbidden);
  }

  bool is_whole(const Place& place) const { return contains(panel_->frame_, place.box); }

  /// Whether the anchor, or else the label beside it, is in the frame.
  bool is_in_sight(const Label& label) const {
    return contains(panel_->frame_, Box{label.anchor, label.anchor}) || is_whole(best_place(label, Leave::allowed));
  }

  /// Whether the places that are tried may leave the frame, or are moved into it.
  enum class Leave { allowed, forbidden };

  Place best_place(const Label& label, Leave leave) const {
    const double rise = panel_->canvas_.cap_height(label.style) / 2;  // of the middle above the baseline
    const Box ink = panel_->canvas_.ink_box(Vec2::Zero(), label.text, label.style);
    const Vec2 half(std::max(-ink.min.x(), ink.max.x()), std::max(rise, ink.max.y() + rise));

    Place best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t spread = 0; spread < spreads.size(); ++spread) {
      for (int attempt = 0; attempt < directions; ++attempt) {
        const int turns = turns_of(attempt);
        const double astray = cost_gap * static_cast<double>(spread) + cost_turn * std::abs(turns);
        if (astray >= least) continue;
        const Vec2 unit = rotated(label.toward, turns);
        const Vec2 middle = label.anchor + unit * distance_clear_of(half, unit, label.gap * spreads[spread]);
        const Vec2 beside = middle + Vec2(0, rise);
        const Vec2 baseline = leave == Leave::allowed ? beside : beside + way_into_frame(moved(ink, beside));
        Place place{baseline, moved(ink, baseline)};
        place.leader = leader_of(label, place.box);
        const double overlaps = cost_of(place.box) + cost_of_leader(place.leader) + astray;
        if (overlaps >= least) continue;
        const double cost = overlaps + (is_nearer_elsewhere(label, place.box) ? cost_elsewhere : 0) +
                            (label.stays_on_its_side ? cost_across * lines_between(label, place.box) : 0);
        if (cost >= least) continue;
        least = cost;
        place.clear = cost < cost_obstacle;
        best = place;
      }
    }
    return best;
  }

  /// Returns: by how much a box must be moved to be clear of the frame's border; its left end comes first.
  Vec2 way_into_frame(const Box& box) const {
    const Box within = panel_->frame_.grown(-frame_margin);
    const Vec2 from_right = (within.max - box.max).cwiseMin(0);
    return from_right + (within.min - box.min - from_right).cwiseMax(0);
  }

  bool is_nearer_elsewhere(const Label& label, const Box& box) const {
    const double own = (box.center() - label.anchor).norm();
    return std::ranges::any_of(panel_->labels_, [&](const Label& other) {
      return (other.anchor - label.anchor).norm() > anchor_radius && (box.center() - other.anchor).norm() < own;
    });
  }

  int lines_between(const Label& label, const Box& box) const {
    const Vec2 middle = box.center();
    return static_cast<int>(std::ranges::count_if(obstacles_, [&](const Obstacle& line) {
      return distance_to_segment(label.anchor, line.from, line.to) > anchor_radius + line.radius &&
             are_apart(line.from, line.to, label.anchor, middle) && are_apart(label.anchor, middle, line.from, line.to);
    }));
  }

  double cost_of(const Box& box) const {
    double cost = contains(panel_->frame_.grown(-frame_margin), box) ? 0 : cost_outside;
    for (const Box& other : taken_) {
      if (box.grown(label_clearance).overlaps(other))
        cost += cost_label;
      else if (box.grown(label_comfort).overlaps(other))
        cost += cost_near_label;
    }
    return cost + cost_obstacle * count_near(box, obstacles_, line_clearance) +
           cost_fine_line * std::min<double>(most_fine_lines, count_near(box, panel_->fine_lines_, line_clearance));
  }

  double cost_of_leader(const Leader& line) const {
    if (!line) return 0;
    const auto crosses = [&](const Box& other) { return clip_segment(line->first, line->second, other).has_value(); };
    return cost_obstacle * static_cast<double>(std::ranges::count_if(taken_, crosses));
  }

  static bool is_near(const Obstacle& line, const Box& box, double clearance) {
    const auto& [from, to, radius] = line;
    const double reach = radius + clearance;
    // Most are far away, which is quickly seen: labels are tried in hundreds of places among thousands of lines.
    if (std::max(from.x(), to.x()) < box.min.x() - reach || std::min(from.x(), to.x()) > box.max.x() + reach ||
        std::max(from.y(), to.y()) < box.min.y() - reach || std::min(from.y(), to.y()) > box.max.y() + reach)
      return false;
    return clip_segment(from, to, box.grown(reach)).has_value();
  }

  static int count_near(const Box& box, const std::vector<Obstacle>& lines, double clearance) {
    return static_cast<int>(
        std::ranges::count_if(lines, [&](const Obstacle& line) { return is_near(line, box, clearance); }));
  }

  const Panel* panel_;
  std::vector<Obstacle> obstacles_;  // of the panel, and leaders
  std::vector<Box> taken_;
  std::vector<std::vector<PlacedLabel>> groups_;  // of each the leaders are drawn before the letters
  int crowded_ = 0;
};

int Panel::place_labels(double smallest) {
  Arrangement best(*this, 1, smallest);
  for (double size = 1; best.crowded() > 0 && size > smallest;) {
    size = std::max(smallest, next_smaller * size);
    Arrangement smaller(*this, size, smallest);
    if (smaller.crowded() < best.crowded()) best = std::move(smaller);
  }
  best.draw(canvas_);
  drop_labels();
  return best.crowded();
}

}  // namespace render
