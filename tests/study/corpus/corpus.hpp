/// The kept corpus, walkthroughs/pairs/corpus.jsonl: one file that shows what random pairs show seldom or never.
///
/// It holds the published failures; the smallest pairs of whole numbers on which mistakes of the study show; and of each family
/// those pairs that show the most of what others do not yet.
#pragma once

#include <vector>

#include "tests/study/corpus/answered_pair.hpp"

namespace study {

/// Returns: its pairs, always the same, each once.
std::vector<NamedPair> kept_corpus();

}  // namespace study
