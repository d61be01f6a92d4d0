/// Texts of others, shown in messages: what a user typed, read or called a file may hold anything.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::text {

/// Returns: the code points of UTF-8; U+FFFD for each byte that is not.
std::u32string code_points(std::string_view text);

/// Returns: whether a terminal or a picture can show it: no control character, nothing that breaks or turns lines, and
/// nothing that only looks like nothing, such as a space of no width. By itself, so that two names that look the same are
/// the same.
bool is_printable(char32_t code_point);

/// Returns: whether words may have it: what is printable, and what joins letters or chooses their variant.
bool is_part_of_words(char32_t code_point);

/// Returns: "U+00E4".
std::string code_point_name(char32_t code_point);

/// Returns: where the first byte is that is not UTF-8; nothing where all are.
std::optional<std::size_t> first_not_utf_8(std::string_view text);

/// Returns: `text` with escapes such as \x1b, \u202e and \U000e0001 for what is not printable or not UTF-8, in one line.
std::string printable(std::string_view text);

/// Returns: `text` in quotes, printable, and cut short where it is long.
std::string in_quotes(std::string_view text);

/// Returns: "the font has no sign for 漢 (U+6F22), 字 (U+5B57): boxes stand in their place"; of many the first few, and how
/// many more. Characters that would not show, or change what does, are named by their codes alone. Requires: at least one.
std::string missing_letters(const std::set<char32_t>& codes);

/// Returns: a message, printable, its overlong words (names of files, most likely) without their middle.
std::string message_line(std::string_view text);

/// Returns: `text` as one word of a POSIX shell, which has nothing but line breaks that a terminal would act upon or not show.
std::string shell_quoted(std::string_view text);

/// Returns: `path` as one word of a shell and not an option, for commands that readers may copy.
std::string shell_word(const std::string& path);

}  // namespace walkthroughs::text
