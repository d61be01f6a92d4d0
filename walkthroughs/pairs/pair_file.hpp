/// Pairs of a file, however many there are: one is in memory.
#pragma once

#include <filesystem>
#include <optional>

#include "walkthroughs/pairs/named_pair.hpp"
#include "walkthroughs/query/query_lines.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace walkthroughs::pairs {

class PairFile {
 public:
  /// `file`: or "-", standard input. Errors: InputError, where it is neither a regular file nor that.
  explicit PairFile(const std::filesystem::path& file);
  PairFile(const PairFile&) = delete;
  PairFile& operator=(const PairFile&) = delete;

  /// Returns: the pair of the next line, called "line-7" where that says no name; nothing at the end. Answers that lines tell are
  /// not looked at. Errors: InputError, which names the line, where it is no such pair, or too long; where there is no line at all.
  std::optional<NamedPair> next();

 private:
  std::size_t read_some(std::span<char> bytes);
  [[noreturn]] void refuse_line(const std::string& why) const;

  const std::string called_;
  text::OpenFile file_;
  query::LineReader lines_;
  std::size_t number_ = 0;
  std::size_t without_end_ = 0;  ///< bytes that were read in search of the end of this line
};

}  // namespace walkthroughs::pairs
