/// What was found about a program as one HTML page, which asks the network for nothing: first the verdict, then families, the
/// first wrong steps and the first failures, drawn.
#pragma once

#include <string>

#include "tests/study/judge/judged_text.hpp"

namespace study {

/// Draws at most `pictures` failures. Errors: render::ContextError, render::FontError.
std::string judged_page(const ProgramJudged& judged, const JudgedHead& head, std::size_t pictures = 6);

}  // namespace study
