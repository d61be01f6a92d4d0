#include "render/font.hpp"

#include <fribidi.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <new>
#include <string>
#include <tuple>

#include "render/file.hpp"
#include "render/utf8.hpp"

namespace render {
namespace {

// FreeType's fixed-point numbers with 6 fractional bits.
long to_26_6(double pixels) { return std::lround(pixels * 64); }
double from_26_6(long value) { return static_cast<double>(value) / 64; }
int rounded_26_6(long value) { return static_cast<int>((value + 32) >> 6); }

// ---------------------------------------------------------------------------------------------- markup

enum class Level { baseline, subscript };

struct Character {
  char32_t code;
  Level level;
};

/// Takes `prefix` off the front of `text` where it stands there.
bool skip(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

std::vector<Character> parse_markup(std::string_view text) {
  std::vector<Character> characters;
  while (!text.empty()) {
    if (skip(text, "\\_")) {
      characters.push_back({U'_', Level::baseline});
    } else if (skip(text, "_{")) {
      while (!text.empty() && !skip(text, "}")) characters.push_back({next_code_point(text), Level::subscript});
    } else if (text.size() > 1 && skip(text, "_")) {
      characters.push_back({next_code_point(text), Level::subscript});
    } else {
      characters.push_back({next_code_point(text), Level::baseline});
    }
  }
  return characters;
}

/// What is left of a second letter that was joined to the first, and marks of direction that have done their work.
bool is_unseen(FriBidiChar code) {
  constexpr FriBidiChar arabic_letter_mark = 0x061C;
  return code == FRIBIDI_CHAR_FILL || code == FRIBIDI_CHAR_LRM || code == FRIBIDI_CHAR_RLM ||
         code == arabic_letter_mark;
}

/// The bidirectional algorithm of Unicode, by FriBidi, which also joins Arabic letters. A text begins on the side on which
/// its first letter does.
/// Returns: the text as it is drawn from left to right; without letters that run from right to left as it is.
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

constexpr double subscript_size = 0.7;  // ems, as is the next
constexpr double subscript_drop = 0.2;

// ---------------------------------------------------------------------------------------------- FreeType

using Library = std::unique_ptr<FT_LibraryRec_, decltype(&FT_Done_FreeType)>;
using Face = std::unique_ptr<FT_FaceRec_, decltype(&FT_Done_Face)>;

void expect_memory(FT_Error error) {
  if (error == FT_Err_Out_Of_Memory) throw std::bad_alloc();
}

Library open_library() {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) throw std::bad_alloc();  // there is no other reason
  return {library, FT_Done_FreeType};
}

/// FreeType calls a file that it finds no memory for one of an unknown format.
/// Errors: std::bad_alloc where there is less than twice the size of the file.
void expect_memory_for(const std::filesystem::path& file) {
  const std::vector<std::uint8_t> once = read_file(file), twice = read_file(file);
}

Face open_face(FT_Library library, const std::filesystem::path& file) {
  FT_Face face = nullptr;
  std::error_code unknown;
  const bool regular = std::filesystem::is_regular_file(file, unknown);  // a pipe would block
  const FT_Error error = regular ? FT_New_Face(library, file.c_str(), 0, &face) : FT_Err_Cannot_Open_Resource;
  if (error == 0) return {face, FT_Done_Face};
  expect_memory(error);
  if (regular && !memory_limit().empty()) expect_memory_for(file);
  const std::string what = std::filesystem::exists(file, unknown)
                               ? "is not a font that FreeType reads (FreeType error " + std::to_string(error) + ")"
                           : unknown && unknown != std::errc::no_such_file_or_directory
                               ? "cannot be read: " + unknown.message()
                               : "does not exist";
  throw FontError("the font file " + file.string() + " " + what +
                  "; install it with: apt-get install fonts-dejavu-core, or set GJKSTEP_FONT_DIR to its folder" +
                  memory_limit());
}

/// Returns the height of an H, in font units.
FT_Pos cap_height_of(FT_Face face) {
  if (FT_Load_Char(face, 'H', FT_LOAD_NO_SCALE) != 0) return face->ascender;
  return face->glyph->metrics.horiBearingY;
}

/// A glyph at one size: where its bitmap is in the atlas, and where it goes relative to the pen.
struct CachedGlyph {
  PlacedGlyph bitmap;
  long advance;  // 26.6
};

}  // namespace

// ---------------------------------------------------------------------------------------------- Font

struct Font::Impl {
  struct LoadedFace {
    Face face{nullptr, FT_Done_Face};
    FT_Pos cap_height;
    std::filesystem::path file;
    long size = 0;  // that is set, in 26.6
  };

  Library library = open_library();
  std::array<LoadedFace, 2> faces;                                  // indexed by Weight
  std::map<std::tuple<Weight, FT_UInt, long>, CachedGlyph> glyphs;  // key: face, glyph index, size in 26.6
  std::set<char32_t> missing;
  std::vector<std::uint8_t> atlas;
  int shelf_top = 0, shelf_height = 0, shelf_x = 0;  // the row of the atlas that is being filled

  FT_Face resized(Weight weight, long size) {
    LoadedFace& loaded = faces[static_cast<std::size_t>(weight)];
    if (loaded.size == size) return loaded.face.get();
    // At 72 dots per inch a point is a pixel.
    if (const FT_Error error = FT_Set_Char_Size(loaded.face.get(), 0, size, 72, 72); error != 0) {
      expect_memory(error);
      throw FontError("FreeType cannot set the text size " + std::to_string(from_26_6(size)) + " pixels" +
                      memory_limit());
    }
    loaded.size = size;
    return loaded.face.get();
  }

  const CachedGlyph& glyph(Weight weight, FT_UInt index, long size) {
    const auto key = std::tuple(weight, index, size);
    const auto found = glyphs.find(key);
    if (found != glyphs.end()) return found->second;
    return glyphs.emplace(key, render(resized(weight, size), index)).first->second;
  }

  CachedGlyph render(FT_Face face, FT_UInt index) {
    const FT_Error error = FT_Load_Glyph(face, index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP | FT_LOAD_RENDER);
    if (error != 0) {
      expect_memory(error);
      throw FontError("FreeType cannot draw glyph " + std::to_string(index) + " of " + face->family_name +
                      " (FreeType error " + std::to_string(error) + ")" + memory_limit());
    }
    const FT_GlyphSlot slot = face->glyph;
    CachedGlyph result{{.x = slot->bitmap_left, .y = -slot->bitmap_top}, slot->advance.x};
    store(result.bitmap, slot->bitmap);
    return result;
  }

  // Shelves: glyphs side by side until a row is full, then a new row below the tallest of them.
  void store(PlacedGlyph& glyph, const FT_Bitmap& bitmap) {
    glyph.width = std::min(static_cast<int>(bitmap.width), atlas_width);
    glyph.height = static_cast<int>(bitmap.rows);
    if (glyph.width == 0 || glyph.height == 0) return;

    if (shelf_x + glyph.width > atlas_width) {
      shelf_top += shelf_height;
      shelf_height = shelf_x = 0;
    }
    shelf_height = std::max(shelf_height, glyph.height);
    atlas.resize(static_cast<std::size_t>(shelf_top + shelf_height) * atlas_width);
    glyph.atlas_x = shelf_x;
    glyph.atlas_y = shelf_top;
    shelf_x += glyph.width;
    for (int y = 0; y < glyph.height; ++y) {
      std::copy_n(bitmap.buffer + y * bitmap.pitch, glyph.width,
                  atlas.data() + (glyph.atlas_y + y) * atlas_width + glyph.atlas_x);
    }
  }
};

Font::Font(const std::filesystem::path& directory) : impl_(std::make_unique<Impl>()) {
  const std::array<const char*, 2> files = {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"};
  for (std::size_t i = 0; i < files.size(); ++i) {
    impl_->faces[i].file = directory / files[i];
    impl_->faces[i].face = open_face(impl_->library.get(), impl_->faces[i].file);
    impl_->faces[i].cap_height = cap_height_of(impl_->faces[i].face.get());
  }
}

Font::~Font() = default;

std::filesystem::path Font::default_directory() {
  const char* chosen = std::getenv("GJKSTEP_FONT_DIR");
  return chosen != nullptr && *chosen != '\0' ? chosen : GJKSTEP_FONT_DIR_DEFAULT;
}

TextLine Font::set(std::string_view text, double pixels, Weight weight) {
  const double em = std::clamp(pixels, 1.0, max_pixels);
  TextLine line;
  long pen = 0;  // 26.6
  FT_UInt previous = 0;
  Level previous_level = Level::baseline;
  for (const auto& [code, level] : in_visual_order(parse_markup(text))) {
    const long size = to_26_6(level == Level::subscript ? subscript_size * em : em);
    const FT_Face face = impl_->resized(weight, size);
    const FT_UInt index = FT_Get_Char_Index(face, code);
    if (index == 0) impl_->missing.insert(code);
    FT_Vector kerning{};
    if (level == previous_level) FT_Get_Kerning(face, previous, index, FT_KERNING_UNFITTED, &kerning);
    pen += kerning.x;

    const CachedGlyph& glyph = impl_->glyph(weight, index, size);
    PlacedGlyph& placed = line.glyphs.emplace_back(glyph.bitmap);
    const double drop = level == Level::subscript ? subscript_drop * em : 0;
    placed.x += rounded_26_6(pen);
    placed.y += static_cast<int>(std::lround(drop));
    placed.code = code;
    placed.index = index;
    placed.size = from_26_6(size);
    placed.pen = {from_26_6(pen), drop};
    pen += glyph.advance;
    previous = index;
    previous_level = level;
  }
  line.advance = from_26_6(pen);

  const FT_Face face = impl_->faces[static_cast<std::size_t>(weight)].face.get();
  const double pixels_per_unit = em / face->units_per_EM;
  line.ascent = static_cast<double>(face->ascender) * pixels_per_unit;
  line.descent = -static_cast<double>(face->descender) * pixels_per_unit;
  line.cap_height = static_cast<double>(impl_->faces[static_cast<std::size_t>(weight)].cap_height) * pixels_per_unit;
  return line;
}

const std::filesystem::path& Font::file(Weight weight) const {
  return impl_->faces[static_cast<std::size_t>(weight)].file;
}

int Font::atlas_height() const { return static_cast<int>(impl_->atlas.size()) / atlas_width; }

const std::set<char32_t>& Font::missing() const { return impl_->missing; }

const std::vector<std::uint8_t>& Font::atlas() const { return impl_->atlas; }

std::string freetype_version() {
  const Library library = open_library();
  FT_Int major = 0, minor = 0, patch = 0;
  FT_Library_Version(library.get(), &major, &minor, &patch);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace render
