/// A study, or a shard of it, as a file.
#pragma once

#include <string>
#include <string_view>

#include "tests/study/sweep/study.hpp"

namespace study {

/// Returns: the study as JSON with its checksum; counts as they were counted, so that nothing is lost.
std::string to_json(const Study& study);

/// `name` stands in errors. Errors: StudyError, also where the checksum is wrong or the counts make no sense.
Study from_json(std::string_view text, const std::string& name);

}  // namespace study
