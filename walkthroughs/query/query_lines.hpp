/// Lines from a stream without end, in constant memory.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::query {

/// Puts what there is to read into the bytes given, waits only where there is nothing, and returns how many there were: 0 at
/// the end.
using ReadSome = std::function<std::size_t(std::span<char>)>;

class LineReader {
 public:
  struct Line {
    std::string_view text;  ///< without its line feed; valid until the next call
    bool is_too_long;       ///< then the text is empty
  };

  /// `longest`: in bytes, without the line feed. Longer lines are passed over, and told.
  LineReader(ReadSome read, std::size_t longest) : read_(std::move(read)), longest_(longest), bytes_(1 << 16) {}

  /// Returns: the next line; nothing at the end. The last line may lack its line feed. Errors: those of reading.
  std::optional<Line> next();

 private:
  std::optional<Line> line_ending_at(std::size_t feed);
  std::optional<Line> last_line();
  bool read_more();

  ReadSome read_;
  const std::size_t longest_;
  std::vector<char> bytes_;
  std::size_t begin_ = 0, end_ = 0;  // of what was read and not yet handed out
  std::size_t searched_ = 0;         // no line feed lies between begin_ and here
  bool is_at_end_ = false;           // a terminal would go on behind its end
  bool is_too_long_ = false;         // the beginning of this line has been thrown away
};

}  // namespace walkthroughs::query
