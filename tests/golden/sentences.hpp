/// Sentences of a program, each once, for a person who reads them: how often it is said, how it was said first, and where.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace golden {

class Sentences {
 public:
  /// Sentences that differ in numbers, in the letters of vertices and in what they quote count as one.
  void add(const std::string& sentence, const std::string& place) { add(sentence, place, sentence); }
  /// As above, where `compared` is what counts of it.
  void add(const std::string& sentence, const std::string& place, const std::string& compared);
  /// Adds each sentence of `text`.
  void add_all(std::string_view text, const std::string& place);

  /// Returns: a line for each, in the order in which they came: "287 × A = a − b = (2, 1) − (0, 1) = (2, 0)." and what stands
  /// between sentence and place.
  std::string text(const std::string& before_place) const;

 private:
  struct Sentence {
    int count;
    std::string first, place;
  };

  std::vector<Sentence> all_;
  std::map<std::string, std::size_t> by_pattern_, known_;  ///< indices in all_; what is known needs no second look
};

}  // namespace golden
