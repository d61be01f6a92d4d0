/// Pairs of others: JSON Lines as `gjkstep query` reads them, with a name and a family if they say so.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/study/corpus/answered_pair.hpp"

namespace study {

/// Returns: the pairs. Answers that lines tell are not looked at. `file` stands in errors.
/// Errors: walkthroughs::InputError, which names the line, where one is not a pair that the oracle can judge, or there is none.
std::vector<NamedPair> read_pairs(std::string_view text, const std::string& file);

/// Returns: the kept corpus, which the program has with it.
std::vector<NamedPair> kept_pairs();

}  // namespace study
