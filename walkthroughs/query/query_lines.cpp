#include "walkthroughs/query/query_lines.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace walkthroughs::query {

std::optional<LineReader::Line> LineReader::next() {
  for (;;) {
    const void* const feed = std::memchr(bytes_.data() + searched_, '\n', end_ - searched_);
    if (feed != nullptr)
      return line_ending_at(static_cast<std::size_t>(static_cast<const char*>(feed) - bytes_.data()));
    searched_ = end_;
    if (!read_more()) return last_line();
  }
}

std::optional<LineReader::Line> LineReader::line_ending_at(std::size_t feed) {
  const std::string_view text(bytes_.data() + begin_, feed - begin_);
  begin_ = searched_ = feed + 1;
  const bool is_too_long = std::exchange(is_too_long_, false) || text.size() > longest_;
  return Line{is_too_long ? std::string_view() : text, is_too_long};
}

std::optional<LineReader::Line> LineReader::last_line() {
  if (begin_ == end_ && !is_too_long_) return std::nullopt;
  const std::size_t end = end_;
  std::optional<Line> line = line_ending_at(end);
  begin_ = searched_ = end;
  return line;
}

/// Returns: whether there was more. What belongs to a line that is too long is thrown away first.
bool LineReader::read_more() {
  if (is_at_end_) return false;
  if (end_ - begin_ > longest_) is_too_long_ = true;
  if (is_too_long_) begin_ = end_;
  std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(begin_), bytes_.begin() + static_cast<std::ptrdiff_t>(end_),
            bytes_.begin());
  end_ -= begin_;
  searched_ = end_;
  begin_ = 0;
  if (end_ == bytes_.size()) bytes_.resize(2 * bytes_.size());
  const std::size_t count = read_(std::span(bytes_).subspan(end_));
  end_ += count;
  is_at_end_ = count == 0;
  return !is_at_end_;
}

}  // namespace walkthroughs::query
