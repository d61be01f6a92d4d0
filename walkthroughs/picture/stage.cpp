#include "walkthroughs/picture/stage.hpp"

#include <optional>
#include <utility>

namespace walkthroughs {
namespace {

/// Returns: the first iteration that the walkthrough has something to say about.
std::optional<int> decisive_iteration(const std::vector<Remark>& remarks) {
  for (const Remark& remark : remarks)
    if (remark.at == Remark::At::region_tested || remark.at == Remark::At::reduced) return remark.iteration;
  return std::nullopt;
}

Stage stage_of(const Telling& telling, const std::vector<Remark>& remarks) {
  const Scene& scene = telling.scene;
  const Panels& panels = telling.panels;
  Stage stage;
  if (panels.objects || panels.hull) {
    stage.a = body_of(scene.a, scene.dimension);
    stage.b = body_of(scene.b, scene.dimension);
  }
  if (panels.hull) stage.difference = body_of_difference(scene, stage.a, stage.b);
  if (scene.dimension == Dimension::space)
    stage.lens.camera = choose_camera(telling.trace, decisive_iteration(remarks));
  return stage;
}

}  // namespace

StagedStory::StagedStory(Story story) : Story(std::move(story)) {
  for (const Telling& telling : tellings) stages.push_back(stage_of(telling, remarks));
}

}  // namespace walkthroughs
