#include "walkthroughs/picture/stage.hpp"

#include <utility>

namespace walkthroughs::picture {
namespace {

Stage stage_of(const Telling& telling, const Placing& placing) {
  const Scene& scene = telling.scene;
  const Panels& panels = telling.panels;
  Stage stage{&telling, placing, {}, {}, {}, {}};
  if (panels.objects || panels.hull) {
    stage.a = body_of(scene.a, scene.dimension);
    stage.b = body_of(scene.b, scene.dimension);
  }
  const bool is_proven_apart = telling.truth.answer.status == gjk::Status::separated;
  if (panels.objects && scene.dimension == Dimension::space && !is_proven_apart)
    stage.crossing = crossing_of(scene.a, stage.a, scene.b, stage.b);
  if (panels.hull) stage.difference = body_of_difference(scene, stage.a, stage.b);
  return stage;
}

/// Whether two searches are about the same points, so that their pictures can be compared.
bool have_same_points(const Scene& one, const Scene& other) {
  const std::vector<Point> a = vertices_of(one.a), b = vertices_of(one.b);
  return !a.empty() && !b.empty() && a == vertices_of(other.a) && b == vertices_of(other.b);
}

}  // namespace

StagedStory::StagedStory(Story story) : Story(std::move(story)) {
  const Placing placing = placing_of(tellings);
  for (const Telling& telling : tellings) {
    const Telling* drawn = &telling;
    if (placing.moves()) {
      const Scene& scene = placed_scenes_.emplace_back(placing.placed(telling.scene));
      drawn = &placed_tellings_.emplace_back(
          Telling{scene, placing.placed(telling.trace), placing.placed(telling.hull), telling.panels});
    }
    stages.push_back(stage_of(*drawn, placing));
    const bool is_seen_already = stages.size() > 1 && have_same_points(tellings.front().scene, telling.scene);
    if (is_seen_already)
      stages.back().lens = stages.front().lens;
    else if (telling.scene.dimension == Dimension::space)
      stages.back().lens.camera = choose_camera(drawn->trace);
  }
}

Moment StagedStory::drawn(std::size_t frame, std::size_t scene) const {
  if (!stages[scene].placing.moves()) return frames[frame].moments[scene];
  Moment moment = replay(stages[scene].telling->trace, frames[frame].events[scene].last + 1);
  moment.scale = stages[scene].placing.scale;
  return moment;
}

std::vector<std::string> StagedStory::left_out() const {
  std::vector<std::string> sentences;
  for (std::size_t s = 0; s < stages.size(); ++s) {
    const Scene& scene = tellings[s].scene;
    const auto tell = [&](const Body& body, const std::string& name) {
      if (body.only_outline)
        sentences.push_back(name + " has more than " + std::to_string(most_corners) +
                            " corners: it is drawn without its edges, which would cover it");
    };
    tell(stages[s].a, "'" + scene.a.name + "'");
    tell(stages[s].b, "'" + scene.b.name + "'");
    tell(stages[s].difference, "the difference");
  }
  return sentences;
}

}  // namespace walkthroughs::picture
