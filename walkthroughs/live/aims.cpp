#include "walkthroughs/live/aims.hpp"

#include <algorithm>
#include <vector>

#include "walkthroughs/page/page.hpp"
#include "walkthroughs/picture/panels.hpp"

namespace walkthroughs::live {
namespace {

using render::Vec2;
using Json = PageJson;

constexpr double aside = 34;        // page units, from a feature to where one points at what lies beyond it
constexpr double least_apart = 42;  // of two aims
constexpr int most_rounds = 30;     // of pushing them apart
constexpr double narrow = 200;      // a picture that has no room for them beside what it shows
constexpr double margin = 24;       // from the border of the picture

/// How a difference is drawn: through which all is placed as a scene has it.
class Projection {
 public:
  Projection(const render::Grip& origin, const render::Box& part) : origin_(origin), part_(part) {}

  Vec2 along(const Point& v) const {
    return {v.dot(origin_.right) / origin_.right.squaredNorm(), -v.dot(origin_.up) / origin_.up.squaredNorm()};
  }
  Vec2 at(const Point& p) const { return origin_.at + along(p) - part_.min; }

 private:
  const render::Grip& origin_;
  const render::Box& part_;
};

/// Returns: the grip of the difference of that scene, of several in their order; null where its origin is out of sight.
const render::Grip* difference_in(const render::Canvas& canvas, std::size_t scene) {
  std::vector<const render::Grip*> all;
  for (const render::Grip& grip : canvas.grips())
    if (grip.name == difference_grip) all.push_back(&grip);
  return all.size() == 1 ? all[0] : scene < all.size() ? all[scene] : nullptr;
}

/// Returns: the plane picture in which a choice is plain, else the difference; null where that is out of sight.
const render::Grip* picture_for(const Aim& aim, const render::Canvas& canvas, std::size_t scene) {
  const std::string name = difference_grip_of(aim.face, aim.is_height);
  const auto found = std::ranges::find(canvas.grips(), name, &render::Grip::name);
  return found == canvas.grips().end() ? difference_in(canvas, scene) : &*found;
}

/// Returns: a step aside; upwards where the way leads to who looks.
Vec2 step_along(const Vec2& way) {
  const double length = way.norm();
  return length > 1e-9 ? Vec2(way * (aside / length)) : Vec2(0, -aside);
}

/// Moves what lies too near to each other apart, and all into the picture.
void spread(std::vector<Vec2>& places, const render::Box& part) {
  for (int round = 0; round < most_rounds; ++round)
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Vec2 between = places[i] - places[j];
        const double lacks = least_apart - between.norm();
        if (lacks <= 0) continue;
        const Vec2 way = between.norm() > 1e-9 ? Vec2(between.normalized()) : Vec2(0, 1);
        places[i] += way * lacks / 2;
        places[j] -= way * lacks / 2;
      }
      const Vec2 low(margin, margin), high(part.width() - margin, part.height() - margin);
      places[i] = places[i].cwiseMax(low).cwiseMin(high);
    }
}

/// Returns: where one presses for a choice. Of a triangle seen edge-on it is at the border, where it hides nothing.
Vec2 place_of(const Aim& aim, const render::Grip& picture, const render::Box& part) {
  const Projection projection(picture, part);
  const Vec2 at = projection.at(aim.at),
             step = aim.toward.isZero(0) ? Vec2(0, 0) : step_along(projection.along(aim.toward));
  if (picture.frame.width() <= 0 || !aim.is_height) return at + step;
  const Vec2 corner = Vec2(picture.frame.max.x(), picture.frame.min.y()) - part.min;
  return picture.frame.width() < narrow ? Vec2(corner + Vec2(-32, 14)) : Vec2(corner.x() - 48, (at + step).y());
}

Json direction_json(std::size_t choice, const Projection& projection, const Point& from, const Point& by) {
  const Vec2 at = projection.at(from), way = step_along(projection.along(by));
  return {{"choice", choice}, {"from", {at.x(), at.y()}}, {"by", {way.x(), way.y()}}};
}

}  // namespace

Json aims_at_choices(const Question& question, const render::Canvas& canvas, const render::Box& part) {
  Json aims = Json::array();
  const bool is_drawn = question.decision.kind == Decision::Kind::direction;
  std::vector<Vec2> places;
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    const std::optional<Aim>& aim = question.choices[i].aim;
    const render::Grip* origin = aim ? picture_for(*aim, canvas, question.scene) : nullptr;
    if (!origin) return Json::array();
    if (is_drawn) aims.push_back(direction_json(i, Projection(*origin, part), aim->at, aim->toward));
    places.push_back(place_of(*aim, *origin, part));
  }
  if (is_drawn) return aims;
  spread(places, part);
  for (std::size_t i = 0; i < places.size(); ++i)
    aims.push_back({{"choice", i}, {"at", {places[i].x(), places[i].y()}}, {"name", question.choices[i].aim->name}});
  return aims;
}

Json aims_at_direction(const Story& story, std::size_t frame, const render::Canvas& canvas, const render::Box& part) {
  const render::Grip* origin = difference_in(canvas, 0);
  for (std::size_t i = frame + 1; origin && i < story.frames.size(); ++i) {
    if (story.frames[i].focus != Focus::direction) continue;
    const Direction& next = *story.frames[i].moments[0].direction;
    Point from = Point::Zero();
    for (const Vertex& vertex : next.from) from += vertex.w / next.from.size();
    return Json::array({direction_json(0, Projection(*origin, part), from, next.value)});
  }
  return Json::array();
}

}  // namespace walkthroughs::live
