/// Pairs of others: JSON Lines as `gjkstep query` reads them, with a name and a family if they say so.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/study/corpus/answered_pair.hpp"
#include "walkthroughs/text/document.hpp"

namespace study {

/// Errors: std::invalid_argument where anybody has complained about it.
void require_good(const walkthroughs::text::Document& document);

/// Returns: the pair of that line. `name`: where the line says none.
/// Errors: std::invalid_argument, also where the oracle cannot judge it.
NamedPair pair_of_line(std::string_view line, const std::string& name);

/// Calls `use(line, number)` with each line, counted from 1. Errors: walkthroughs::text::InputError, which names `file` and line, in
/// place of a std::invalid_argument of `use`.
void for_each_line(std::string_view text, const std::string& file,
                   const std::function<void(std::string_view, std::size_t)>& use);

/// Returns: the pairs. Answers that lines tell are not looked at. `file` stands in errors.
/// Errors: walkthroughs::text::InputError, which names the line, where one is not a pair that the oracle can judge, or there is none.
std::vector<NamedPair> read_pairs(std::string_view text, const std::string& file);

/// Returns: the kept corpus, which the program has with it.
std::vector<NamedPair> kept_pairs();

}  // namespace study
