#include <algorithm>
#include <array>
#include <string_view>

#include "walkthroughs/page/questions.hpp"
#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

namespace walkthroughs::page {
namespace {

/// The walkthroughs of regions in which a search decides so: the one that is about it, and another.
struct Practice {
  int simplex_size;
  std::string_view found;  ///< as Decision has it
  std::array<std::string_view, 2> walkthroughs;
};

constexpr Practice practices[] = {
    {0, "crossed", {"1-simplex-r3", "1-simplex-r4"}},
    {0, "not crossed", {"1-simplex-r2-cannot-happen", "2-simplex-r2-cannot-happen"}},
    {1, "A != 0", {"0-simplex-elsewhere", "0-simplex-a-is-origin"}},
    {1, "A = 0", {"0-simplex-a-is-origin", "0-simplex-elsewhere"}},
    {2, "AB != 0", {"1-simplex-r3", "1-simplex-r4"}},
    {2, "AB = 0", {"1-simplex-on-segment", "1-simplex-a-is-origin"}},
    {3, "AB > 0", {"2-simplex-r3", "2-simplex-r4-cannot-happen"}},
    {3, "AC > 0", {"2-simplex-r7", "2-simplex-r6-cannot-happen"}},
    {3, "ABC > 0", {"2-simplex-r1-above", "2-simplex-r1-below"}},
    {3, "ABC < 0", {"2-simplex-r1-below", "2-simplex-r1-above"}},
    {3, "ABC = 0", {"2-simplex-r1-in-plane", "2-simplex-on-edge"}},
    {4, "ABC > 0", {"3-simplex-face-abc", "3-simplex-face-abc-edge-ac"}},
    {4, "ABC AB > 0", {"3-simplex-face-abc-edge-ab", "3-simplex-face-abc"}},
    {4, "ABC AC > 0", {"3-simplex-face-abc-edge-ac", "3-simplex-face-abc"}},
    {4, "ACD > 0", {"3-simplex-face-acd", "3-simplex-in-plane-of-face"}},
    {4, "ACD AC > 0", {"3-simplex-face-acd-edge-ac", "3-simplex-face-acd"}},
    {4, "ACD AD > 0", {"3-simplex-face-acd-edge-ad", "3-simplex-face-acd"}},
    {4, "ADB > 0", {"3-simplex-face-adb", "3-simplex-face-adb-edge-ab"}},
    {4, "ADB AB > 0", {"3-simplex-face-adb-edge-ab", "3-simplex-face-adb"}},
    {4, "ADB AD > 0", {"3-simplex-face-adb-edge-ad", "3-simplex-face-adb"}},
    {4, "ABCD > 0", {"3-simplex-inside", "3-simplex-on-face"}},
};

/// The face or feature in words of Decision::found.
std::string_view first_word(std::string_view found) { return found.substr(0, found.find(' ')); }

/// That of M1 is about no region.
std::string practice_for_mistake(const std::string& word) {
  const wrong_on_purpose::Description* known = wrong_on_purpose::named(word);
  return known == nullptr || known->practice.empty() ? "" : "regions/" + std::string(known->practice);
}

}  // namespace

std::string practice_for(const Decision& decision, const std::string& but) {
  if (decision.kind == Decision::Kind::line) return practice_for_mistake(decision.found);
  const auto find = [&](const auto& is_likewise) {
    return std::ranges::find_if(practices, [&](const Practice& each) {
      return each.simplex_size == decision.simplex_size && is_likewise(each.found);
    });
  };
  auto found = find([&](std::string_view it) { return it == decision.found; });
  if (found == std::end(practices))
    found = find([&](std::string_view it) { return first_word(it) == first_word(decision.found); });
  if (found == std::end(practices)) return "";
  const std::string first = "regions/" + std::string(found->walkthroughs[0]);
  return first == but ? "regions/" + std::string(found->walkthroughs[1]) : first;
}

}  // namespace walkthroughs::page
