/// What a page asks where a search with a mistake parts from the report's.
#pragma once

#include <optional>

#include "walkthroughs/page/question.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs {

/// Returns: in which line the mistake is. Among the lines that ran there is exactly one that the mistaken program has otherwise:
/// others that it has otherwise, too, are left out. Nothing where the searches do not part. Requires: story.shows_mistake().
std::optional<Question> question_of_line(const Story& story);

}  // namespace walkthroughs
