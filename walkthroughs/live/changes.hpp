/// What a reader may change of a scene: what each grip moves, and the switches. A page needs to know nothing of scenes: it adds to
/// numbers at paths, and puts values in their place.
#pragma once

#include <optional>
#include <string>

#include "render/canvas.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/page/page.hpp"

namespace walkthroughs::live {

/// Returns: {"says", "paths": of points and vectors in the scene's JSON, ["a", "points", 2]; what is not there is zero}.
/// Requires: a grip of the scene (objects_panel.cpp).
PageJson moved_by(const render::Grip& grip, const Scene& scene);

/// Returns: [{"key", "label", "chosen": place of one of these, "choices": [{"text", "value"}]}]. A value belongs at the key in the
/// scene's JSON; null: nothing belongs there.
PageJson switches_of(const Scene& scene, std::optional<Mistake> mistake);

}  // namespace walkthroughs::live
