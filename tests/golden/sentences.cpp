#include "tests/golden/sentences.hpp"

#include <regex>
#include <utility>

namespace golden {
namespace {

std::string pattern(std::string sentence) {
  static const std::vector<std::pair<std::regex, std::string>> rules{
      {std::regex("'[^']*'|\"[^\"]*\""), "''"},
      {std::regex("(^|[^A-Za-z0-9])(?:−|-)?[0-9][0-9.]*(?:e(?:−|-|\\+)?[0-9]+)?"), "$1#"},
      {std::regex("\\(#(?:, #)*\\)"), "#"},
      {std::regex("#(?:, #)+"), "#"},
      {std::regex("\\b[A-Z]{1,4}(n?)\\b"), "X$1"},
      {std::regex("X(?: #)?(?:, X(?: #)?)+"), "X"},
      {std::regex("\\bR[0-9](?:, R[0-9])*"), "R"},
  };
  for (const auto& [numbers, in_place] : rules) sentence = std::regex_replace(sentence, numbers, in_place);
  return sentence;
}

}  // namespace

void Sentences::add(const std::string& sentence, const std::string& place, const std::string& compared) {
  const auto [known, is_new] = known_.emplace(compared, 0);
  if (is_new) {
    const auto [like, is_first] = by_pattern_.emplace(pattern(compared), all_.size());
    if (is_first) all_.push_back({0, sentence, place});
    known->second = like->second;
  }
  ++all_[known->second].count;
}

void Sentences::add_all(std::string_view text, const std::string& place) {
  while (!text.empty()) {
    std::size_t end = text.find('\n');
    for (const std::string_view stop : {". ", ": ", "? ", "! "})
      if (const std::size_t at = text.find(stop); at < end) end = at + 1;
    end = std::min(end, text.size());
    if (end > 0) add(std::string(text.substr(0, end)), place);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::string Sentences::text(const std::string& before_place) const {
  std::string text;
  for (const Sentence& each : all_)
    text += std::to_string(each.count) + " × " + each.first + before_place + each.place + "\n";
  return text;
}

}  // namespace golden
