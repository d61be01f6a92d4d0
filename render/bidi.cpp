#include "render/bidi.hpp"

#include <fribidi.h>

#include <algorithm>
#include <new>
#include <numeric>

namespace render {
namespace {

/// What is left of a second letter that was joined to the first, and marks of direction that have done their work.
bool is_unseen(FriBidiChar code) {
  constexpr FriBidiChar arabic_letter_mark = 0x061C;
  return code == FRIBIDI_CHAR_FILL || code == FRIBIDI_CHAR_LRM || code == FRIBIDI_CHAR_RLM ||
         code == arabic_letter_mark;
}

}  // namespace

VisualText visual(const std::u32string& text) {
  VisualText result{text, std::vector<std::size_t>(text.size())};
  std::iota(result.from.begin(), result.from.end(), std::size_t{0});
  const auto count = static_cast<FriBidiStrIndex>(text.size());
  std::vector<FriBidiChar> codes(text.begin(), text.end());
  std::vector<FriBidiCharType> types(text.size());
  fribidi_get_bidi_types(codes.data(), count, types.data());
  if (std::ranges::none_of(types, [](FriBidiCharType type) { return FRIBIDI_IS_RTL(type); })) return result;

  std::vector<FriBidiBracketType> brackets(text.size());
  std::vector<FriBidiLevel> levels(text.size());
  std::vector<FriBidiArabicProp> joins(text.size());
  std::vector<FriBidiStrIndex> places(text.size());
  std::iota(places.begin(), places.end(), 0);
  FriBidiParType base = FRIBIDI_PAR_ON;
  fribidi_get_bracket_types(codes.data(), count, types.data(), brackets.data());
  if (fribidi_get_par_embedding_levels_ex(types.data(), brackets.data(), count, &base, levels.data()) == 0)
    throw std::bad_alloc();  // the one way in which it fails
  fribidi_get_joining_types(codes.data(), count, joins.data());
  fribidi_join_arabic(types.data(), count, levels.data(), joins.data());
  fribidi_shape(FRIBIDI_FLAGS_DEFAULT | FRIBIDI_FLAGS_ARABIC, levels.data(), count, joins.data(), codes.data());
  if (fribidi_reorder_line(FRIBIDI_FLAGS_DEFAULT, types.data(), count, 0, base, levels.data(), codes.data(),
                           places.data()) == 0)
    throw std::bad_alloc();

  result = {};
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const auto place = static_cast<std::size_t>(places[i]);
    if (is_unseen(codes[i]) || FRIBIDI_IS_EXPLICIT_OR_BN(types[place])) continue;
    result.codes += static_cast<char32_t>(codes[i]);
    result.from.push_back(place);
  }
  return result;
}

}  // namespace render
