/// A font from its files, by FreeType: what it measures in its own units, and bitmaps of its glyphs.
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H
#include FT_TRUETYPE_TAGS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <new>
#include <ranges>
#include <string>
#include <tuple>

#include "render/file.hpp"
#include "render/font.hpp"

namespace render {
namespace {

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

FontError cannot_draw(FT_Face face, unsigned index, FT_Error error) {
  expect_memory(error);
  return FontError("FreeType cannot draw glyph " + std::to_string(index) + " of " + face->family_name +
                   " (FreeType error " + std::to_string(error) + ")" + memory_limit());
}

FT_GlyphSlot loaded(FT_Face face, unsigned index, FT_Int32 flags) {
  if (const FT_Error error = FT_Load_Glyph(face, index, flags); error != 0) throw cannot_draw(face, index, error);
  return face->glyph;
}

// ---------------------------------------------------------------------------------------------- in font units

/// Returns: a whole number of `count` bytes, the first byte the greatest, from a table of the file.
FT_ULong number_at(FT_Face face, FT_ULong table, FT_ULong at, FT_ULong count) {
  std::array<FT_Byte, 4> bytes{};
  if (const FT_Error error = FT_Load_Sfnt_Table(face, table, static_cast<FT_Long>(at), bytes.data(), &count);
      error != 0) {
    expect_memory(error);
    throw FontError(std::string(face->family_name) +
                    " has no TrueType outlines; set GJKSTEP_FONT_DIR to a folder with DejaVu");
  }
  FT_ULong number = 0;
  for (FT_ULong i = 0; i < count; ++i) number = number << 8 | bytes[i];
  return number;
}

int signed_at(FT_Face face, FT_ULong table, FT_ULong at) {
  return static_cast<std::int16_t>(number_at(face, table, at, 2));
}

/// Returns: how far FreeType moves an outline to the left, so that it begins where its metrics say. It does not tell.
int moved(FT_Face face, FT_ULong index) {
  const auto& head = *static_cast<const TT_Header*>(FT_Get_Sfnt_Table(face, FT_SFNT_HEAD));
  const FT_ULong glyph = head.Index_To_Loc_Format != 0 ? number_at(face, TTAG_loca, index * 4, 4)
                                                       : number_at(face, TTAG_loca, index * 2, 2) * 2;
  const FT_ULong pairs = static_cast<const TT_HoriHeader*>(FT_Get_Sfnt_Table(face, FT_SFNT_HHEA))->number_Of_HMetrics;
  const FT_ULong bearing = index < pairs ? index * 4 + 2 : pairs * 4 + (index - pairs) * 2;
  return signed_at(face, TTAG_glyf, glyph + 2) - signed_at(face, TTAG_hmtx, bearing);
}

/// Parts are outlines, or have parts themselves. In DejaVu none is turned, scaled, or hung to a point of another.
std::vector<GlyphPart> parts_of(FT_Face face, unsigned index) {
  const FT_GlyphSlot slot = loaded(face, index, FT_LOAD_NO_RECURSE);
  if (slot->format != FT_GLYPH_FORMAT_COMPOSITE) {
    if (slot->outline.n_points == 0) return {};
    FT_BBox box;
    FT_Outline_Get_CBox(&slot->outline, &box);
    const FT_Pos by = moved(face, index);
    return {{.left = static_cast<int>(box.xMin + by),
             .bottom = static_cast<int>(box.yMin),
             .right = static_cast<int>(box.xMax + by),
             .top = static_cast<int>(box.yMax)}};
  }
  struct Member {
    FT_Int index;
    GlyphPart::Offset offset;
  };
  std::vector<Member> members;  // before the slot is used for them
  for (FT_UInt i = 0; i < slot->num_subglyphs; ++i) {
    Member member;
    FT_UInt flags;
    FT_Matrix turned;
    FT_Get_SubGlyph_Info(slot, i, &member.index, &flags, &member.offset.x, &member.offset.y, &turned);
    members.push_back(member);
  }
  std::vector<GlyphPart> parts;
  for (const Member& member : members)
    for (GlyphPart& part : parts_of(face, static_cast<unsigned>(member.index))) {
      if (member.offset != GlyphPart::Offset{}) part.offsets.push_back(member.offset);
      parts.push_back(part);
    }
  return parts;
}

/// What is known of a face; its glyphs are read when they are asked for.
struct LoadedFace {
  Face face{nullptr, FT_Done_Face};
  std::string file;
  FaceUnits units;
  long size = 0;  // that is set, in 26.6
};

}  // namespace

// ---------------------------------------------------------------------------------------------- Font

struct Font::Source {
  Library library = open_library();
  std::array<LoadedFace, 2> faces;                               // indexed by Weight
  std::map<std::tuple<Weight, unsigned, long>, Texel> in_atlas;  // key: face, glyph index, size in 26.6
  std::vector<std::uint8_t> atlas;
  int shelf_top = 0, shelf_height = 0, shelf_x = 0;  // the row of the atlas that is being filled

  LoadedFace& of(Weight weight) { return faces[static_cast<std::size_t>(weight)]; }

  FT_Face resized(Weight weight, long size) {
    LoadedFace& loaded = of(weight);
    if (loaded.size == size) return loaded.face.get();
    // At 72 dots per inch a point is a pixel.
    if (const FT_Error error = FT_Set_Char_Size(loaded.face.get(), 0, size, 72, 72); error != 0) {
      expect_memory(error);
      throw FontError("FreeType cannot set the text size " + std::to_string(static_cast<double>(size) / 64) +
                      " pixels" + memory_limit());
    }
    loaded.size = size;
    return loaded.face.get();
  }

  Texel draw(const PlacedGlyph& glyph, long size) {
    const FT_Face face = resized(glyph.weight, size);
    return store(glyph, loaded(face, glyph.index, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP | FT_LOAD_RENDER)->bitmap);
  }

  // Shelves: glyphs side by side until a row is full, then a new row below the tallest of them.
  Texel store(const PlacedGlyph& glyph, const FT_Bitmap& bitmap) {
    if (shelf_x + glyph.width > atlas_width) {
      shelf_top += shelf_height;
      shelf_height = shelf_x = 0;
    }
    shelf_height = std::max(shelf_height, glyph.height);
    atlas.resize(static_cast<std::size_t>(shelf_top + shelf_height) * atlas_width);
    const Texel place{shelf_x, shelf_top};
    shelf_x += glyph.width;
    const int width = std::min(glyph.width, static_cast<int>(bitmap.width));
    for (int y = 0; y < std::min(glyph.height, static_cast<int>(bitmap.rows)); ++y)
      std::copy_n(bitmap.buffer + y * bitmap.pitch, width, atlas.data() + (place.y + y) * atlas_width + place.x);
    return place;
  }
};

Font::Font(const std::string& directory) : source_(std::make_unique<Source>()) {
  const std::array<const char*, 2> files = {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf"};
  for (std::size_t i = 0; i < files.size(); ++i) {
    LoadedFace& loaded = source_->faces[i];
    loaded.file = (std::filesystem::path(directory) / files[i]).string();
    loaded.face = open_face(source_->library.get(), loaded.file);
    const FT_Face face = loaded.face.get();
    loaded.units = {face->units_per_EM, face->ascender, face->descender, static_cast<int>(cap_height_of(face))};
  }
}

Font::~Font() = default;

std::string Font::default_directory() {
  const char* chosen = std::getenv("GJKSTEP_FONT_DIR");
  return chosen != nullptr && *chosen != '\0' ? chosen : GJKSTEP_FONT_DIR_DEFAULT;
}

FaceUnits Font::face(Weight weight) const { return source_->of(weight).units; }

GlyphUnits Font::glyph(Weight weight, char32_t code) const {
  const FT_Face face = source_->of(weight).face.get();
  GlyphUnits glyph{.index = FT_Get_Char_Index(face, code)};
  glyph.parts = parts_of(face, glyph.index);
  const FT_GlyphSlot slot = loaded(face, glyph.index, FT_LOAD_NO_SCALE);
  glyph.advance = static_cast<int>(slot->advance.x);
  if (glyph.parts.empty()) return glyph;
  // What FreeType moves an outline by, to the left.
  const auto left_of = [](GlyphPart part) {
    for (const GlyphPart::Offset& offset : part.offsets) part.left += offset.x;
    return part.left;
  };
  glyph.origin =
      std::ranges::min(glyph.parts | std::views::transform(left_of)) - static_cast<int>(slot->metrics.horiBearingX);
  return glyph;
}

int Font::kerning(Weight weight, unsigned left, unsigned right) const {
  FT_Vector kerning{};
  FT_Get_Kerning(source_->of(weight).face.get(), left, right, FT_KERNING_UNSCALED, &kerning);
  return static_cast<int>(kerning.x);
}

const std::string& Font::file(Weight weight) const { return source_->of(weight).file; }

Font::Texel Font::in_atlas(const PlacedGlyph& glyph) {
  const long size = std::lround(glyph.size * 64);
  const auto key = std::tuple(glyph.weight, glyph.index, size);
  const auto found = source_->in_atlas.find(key);
  return found != source_->in_atlas.end() ? found->second
                                          : source_->in_atlas.emplace(key, source_->draw(glyph, size)).first->second;
}

int Font::atlas_height() const { return static_cast<int>(source_->atlas.size()) / atlas_width; }

const std::vector<std::uint8_t>& Font::atlas() const { return source_->atlas; }

std::string freetype_version() {
  const Library library = open_library();
  FT_Int major = 0, minor = 0, patch = 0;
  FT_Library_Version(library.get(), &major, &minor, &patch);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace render
