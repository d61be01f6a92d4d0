#include "walkthroughs/picture/inset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "render/length.hpp"

namespace walkthroughs::picture {
namespace {

using render::Box;
using render::Vec2;
using render::View;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Page units.
constexpr double least_distance = 14, wanted_distance = 75;  // of what is near from the origin
constexpr double hidden_distance = 9;                        // where one mark hides the other
constexpr double least_apart = 14, wanted_apart = 70;        // of two vertices
constexpr double room_around = 26, room_of_mark = 12;        // inside the frame, and outside
constexpr double in_sight = 60, least_factor = 2;            // of what is nearest, where an inset is wanted
constexpr double gap = 8, circle_radius = 14, widest = 0.48, highest = 0.5;  // the last two in parts of the room
constexpr double least_inside = 48;
constexpr double most_width = 1.5;  // in heights
constexpr double strip = 24, text_size = 15;
constexpr double smaller_text = 0.8, smaller_arrows = 0.7;  // inside
constexpr double largest_factor = 1e302;                    // so that the page's own coordinates are numbers
const Vec2 size_of_frame(230, 186);

/// Returns: a box in the corner of `room` where it is farthest from `at`, from the shape and from other marks.
Box best_corner(const Vec2& at, const Surroundings& what, const Box& room, const Vec2& size, const View& view) {
  Box best;
  double most = -1;
  for (const bool right : {false, true})
    for (const bool low : {false, true}) {
      const Vec2 corner(right ? room.max.x() - size.x() : room.min.x(), low ? room.max.y() - size.y() : room.min.y());
      const Vec2 middle = view.scene(corner + size / 2);
      double clear = (middle - at).norm();
      for (const Segment& s : what.shape)
        clear = std::min(clear, render::distance_to_segment(middle, s.first, s.second));
      for (const Vec2& other : what.others) clear = std::min(clear, (middle - what.origin - other).norm());
      if (clear <= most) continue;
      most = clear;
      best = {corner, corner + size};
    }
  return best;
}

Box below_strip(const Box& frame, const Style& style) { return {frame.min + Vec2(0, style.scaled(strip)), frame.max}; }

/// Returns: what is nearest to the origin, and not there; nothing where there is nothing.
const Nearest* nearest_of(const std::vector<Nearest>& all) {
  const Nearest* found = nullptr;
  for (const Nearest& each : all)
    if (each.distance > 0 && (!found || each.distance < found->distance)) found = &each;
  return found;
}

/// Returns: the two vertices that are nearest to each other, but not in one place.
std::optional<Segment> nearest_two(const std::vector<Vec2>& vertices) {
  std::optional<Segment> found;
  double least = infinity;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t j = i + 1; j < vertices.size(); ++j) {
      const double apart = render::length_of(vertices[i] - vertices[j]);
      if (!(apart > 0) || apart >= least) continue;
      least = apart;
      found = {vertices[i], vertices[j]};
    }
  return found;
}

/// Returns: the middle of the origin, what is nearest, and the vertices that find room beside these.
Vec2 middle_of_near(const Nearest& nearest, const std::vector<Vec2>& vertices, const Vec2& room) {
  Box box = Box::around(std::array<Vec2, 2>{Vec2::Zero(), nearest.at});
  for (const Vec2& vertex : vertices) {
    Box larger = box;
    larger.add(vertex);
    if (larger.width() <= room.x() && larger.height() <= room.y()) box = larger;
  }
  return box.center();
}

bool covers_mark(const Inset& inset, const Surroundings& what, const View& view) {
  const Box kept = inset.frame.grown(room_of_mark);
  const auto is_covered = [&](const Vec2& p) {
    const Vec2 at = view.page(what.origin + p);
    return (at.array() > kept.min.array() && at.array() < kept.max.array()).all();
  };
  return is_covered(Vec2::Zero()) || std::ranges::any_of(what.vertices, is_covered) ||
         std::ranges::any_of(what.others, is_covered);
}

/// Whether nothing is seen without an inset.
bool is_hidden(const Surroundings& what, const View& view) {
  const Nearest* const nearest = nearest_of(what.nearest);
  return nearest && nearest->distance * view.scale() < hidden_distance;
}

std::optional<Inset> inset_of_size(const Vec2& size, const Surroundings& what, const Box& room, const View& view,
                                   bool is_wanted, const Style& style) {
  if (size.y() - style.scaled(strip) < least_inside) return std::nullopt;  // nothing would be seen in it
  const Vec2 inner = size - Vec2(2 * room_around, style.scaled(strip) + 2 * room_around);
  const auto around = [&](const Vec2& at, double factor) {
    return Inset{at, best_corner(what.origin + at, what, room.grown(-gap), size, view), factor};
  };
  const Nearest* const nearest = nearest_of(what.nearest);
  const double distance = nearest ? nearest->distance * view.scale() : infinity;
  const auto around_nearest = [&](double wanted) {
    const double factor = std::max(round_factor(wanted), least_factor);
    return around(middle_of_near(*nearest, what.vertices, inner / (view.scale() * factor)), factor);
  };
  const double wanted = std::min(wanted_distance, (size.y() - style.scaled(strip)) / 2);
  if (distance < least_distance) return around_nearest(wanted / distance);
  if (const auto two = nearest_two(what.vertices)) {
    const double apart = render::length_of(two->first - two->second) * view.scale();
    if (apart < least_apart) return around((two->first + two->second) / 2, round_factor(wanted_apart / apart));
  }
  if (!is_wanted || distance == infinity) return std::nullopt;
  return around(Vec2::Zero(), round_factor(std::max(least_factor, in_sight / distance)));
}

}  // namespace

Style style_of_inset(const Style& style) {
  render::Theme theme = style.theme;
  theme.text *= smaller_text;
  Style small(theme);
  small.arrow_length *= smaller_arrows;
  return small;
}

// By way of its digits, which end before 2e23 is 1.9999: logarithms and powers differ in their last digit from one machine to another.
double round_factor(double factor) {
  char text[32];
  std::snprintf(text, sizeof text, "%.14e", factor < largest_factor ? factor : largest_factor);
  const char* const digit = text[0] >= '5' ? "5" : text[0] >= '2' ? "2" : "1";
  return std::strtod((digit + std::string(std::strchr(text + 2, 'e'))).c_str(), nullptr);
}

std::string words_of_factor(double factor) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0e", factor);
  const int power = std::atoi(text + 2);
  return power < 6 ? "×" + (text[0] + std::string(static_cast<std::size_t>(power), '0'))
                   : std::string("×") + text[0] + "e" + std::to_string(power);
}

std::optional<Inset> inset_of(const Surroundings& what, const Box& room, const View& view, bool is_wanted,
                              const Style& style) {
  const Vec2 most = (room.max - room.min).cwiseProduct(Vec2(widest, highest));
  Vec2 whole = Vec2(size_of_frame.x(), size_of_frame.y() + style.scaled(strip) - strip).cwiseMin(most);
  whole.x() = std::min(whole.x(), most_width * whole.y());
  std::optional<Inset> smallest;
  for (const double part : {1.0, 0.8, 0.65}) {
    const std::optional<Inset> inset = inset_of_size(whole * part, what, room, view, is_wanted, style);
    if (!inset) break;
    if (!covers_mark(*inset, what, view)) return inset;
    smallest = inset;
  }
  return is_hidden(what, view) ? smallest : std::nullopt;
}

std::vector<Inset> insets_of(const Surroundings& what, const Box& room, const View& view, bool is_wanted,
                             const Style& style) {
  const std::optional<Inset> first = inset_of(what, room, view, is_wanted, style);
  if (!first) return {};
  const double reach = first->frame.width() / (2 * view.scale() * first->factor);
  Surroundings beyond = what;  // vertices in the place of the origin's mark, too far away for the first
  beyond.nearest.clear();
  for (const Vec2& vertex : what.vertices)
    if (const double distance = render::length_of(vertex);
        distance > reach && distance * view.scale() < hidden_distance)
      beyond.nearest.push_back({vertex, distance});
  if (beyond.nearest.empty()) return {*first};
  beyond.others.push_back(view.scene(first->frame.center()) - what.origin);
  const std::optional<Inset> second = inset_of(beyond, room, view, false, style);
  if (!second || second->frame.overlaps(first->frame)) return {*first};
  return {*first, *second};
}

namespace {

void draw_inset(render::Canvas& canvas, const render::Panel& panel, const Vec2& origin, const Inset& inset,
                const Style& style, const std::function<void(render::Panel&)>& draw) {
  const auto& [at, frame, factor] = inset;
  const render::Stroke line{style.theme.ink, 1.2};
  canvas.circle(panel.view().page(origin + at), circle_radius, line);
  canvas.rectangle(frame, style.theme.paper);
  const Box room = below_strip(frame, style);
  {
    render::Panel inside(canvas, room, View::fit(at, at, room).with_scale(panel.view().scale() * factor));
    draw(inside);
    canvas.add_crowded(inside.place_labels(style.smallest_label()));
  }
  canvas.outline(frame.corners(), line);
  canvas.line(room.min, {room.max.x(), room.min.y()}, line);
  render::TextStyle text = style.small_label();
  text.size = style.scaled(text_size);
  text.halo = {0, 0, 0, 0};
  const std::string words = "magnified " + words_of_factor(factor);
  text = canvas.fitted(words, text, frame.width() - 2 * gap);
  canvas.text({frame.min.x() + gap, (frame.min.y() + room.min.y() + canvas.cap_height(text)) / 2}, words, text);
}

}  // namespace

void finish_with_insets(render::Canvas& canvas, render::Panel& panel, const Vec2& origin,
                        const std::vector<Inset>& insets, const Style& style,
                        const std::function<void(render::Panel&)>& draw) {
  for (const Inset& inset : insets) panel.keep_clear(inset.frame);
  canvas.add_crowded(panel.place_labels(style.smallest_label()));
  for (const Inset& inset : insets) draw_inset(canvas, panel, origin, inset, style, draw);
}

}  // namespace walkthroughs::picture
