#include "render/bidi.hpp"

#include <fribidi.h>

#include <algorithm>
#include <new>

namespace render {
namespace {

/// What is left of a second letter that was joined to the first, and marks of direction that have done their work.
bool is_unseen(FriBidiChar code) {
  constexpr FriBidiChar arabic_letter_mark = 0x061C;
  return code == FRIBIDI_CHAR_FILL || code == FRIBIDI_CHAR_LRM || code == FRIBIDI_CHAR_RLM ||
         code == arabic_letter_mark;
}

}  // namespace

/// The bidirectional algorithm of Unicode, by FriBidi, which also joins Arabic letters. A text begins on the side on which
/// its first letter does.
std::vector<Character> in_visual_order(const std::vector<Character>& characters) {
  std::vector<FriBidiChar> codes;
  for (const Character& character : characters) codes.push_back(character.code);
  const auto count = static_cast<FriBidiStrIndex>(codes.size());
  std::vector<FriBidiCharType> types(codes.size());
  fribidi_get_bidi_types(codes.data(), count, types.data());
  if (std::ranges::none_of(types, [](FriBidiCharType type) { return FRIBIDI_IS_RTL(type); })) return characters;

  std::vector<FriBidiChar> shaped(codes.size());
  std::vector<FriBidiStrIndex> places(codes.size());  // in the text as it was written
  FriBidiParType base = FRIBIDI_PAR_ON;
  if (fribidi_log2vis(codes.data(), count, &base, shaped.data(), nullptr, places.data(), nullptr) == 0)
    throw std::bad_alloc();  // the one way in which it fails
  std::vector<Character> ordered;
  for (std::size_t i = 0; i < shaped.size(); ++i) {
    const auto place = static_cast<std::size_t>(places[i]);
    if (!is_unseen(shaped[i]) && !FRIBIDI_IS_EXPLICIT_OR_BN(types[place]))
      ordered.push_back({static_cast<char32_t>(shaped[i]), characters[place].level});
  }
  return ordered;
}

}  // namespace render
