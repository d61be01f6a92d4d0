/// Where a reader points to answer a question on the picture.
#pragma once

#include <cstddef>

#include "render/canvas.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/page/questions.hpp"

namespace walkthroughs::live {

/// Returns: the "aims" of live.hpp, in units of `part`. Requires: `canvas` shows what the question is about, with its grips.
PageJson aims_at_choices(const Question& question, const render::Canvas& canvas, const render::Box& part);

/// The same of the direction that the frame after this one shows; none where that shows no other one.
PageJson aims_at_direction(const Story& story, std::size_t frame, const render::Canvas& canvas,
                           const render::Box& part);

}  // namespace walkthroughs::live
