/// corpus.jsonl, as a text in the program.
#pragma once

#include <string_view>

namespace walkthroughs::pairs {

std::string_view kept_corpus_text();

}  // namespace walkthroughs::pairs
