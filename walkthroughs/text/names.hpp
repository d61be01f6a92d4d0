/// What walkthroughs and their titles may be called: the same in scene files and in traces. And what is meant by a word that
/// nobody knows.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::text {

/// Returns: what speaks against `text` as words to be shown; empty where nothing does. `longest`: in characters.
std::string objection_to_words(std::string_view text, std::size_t longest);

/// Pictures go to a folder of the walkthrough's name, which must not lie elsewhere, nor be hidden.
/// Returns: what speaks against such a name; empty where nothing does.
std::string objection_to_name(std::string_view name);

/// Returns: a name for the walkthrough of that file, made from its stem.
std::string name_from_file(const std::string& file_name);

/// Returns: the stem of that file as a title. An underscore, which would be read as the mark of a subscript, divides words.
std::string title_from_file(const std::string& file_name);

/// Returns: the text with small letters in place of A to Z.
std::string in_small_letters(std::string_view text);

/// Returns: a candidate that begins with `word`, else the one that takes the fewest letters to reach from it (Levenshtein
/// distance); the first of several. Of longer words the first 64 letters count: comparing takes time for each. Nothing where
/// that takes more than three letters, or more than half of the word.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// Returns: "did you mean 'figure-4'? "; nothing where nothing is near.
std::string did_you_mean(const std::string& nearest_word);

}  // namespace walkthroughs::text
