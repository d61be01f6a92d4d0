#include "render/vector.hpp"

#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <numbers>
#include <string>
#include <string_view>

#include "render/file.hpp"
#include "render/html.hpp"
#include "render/utf8.hpp"

namespace render {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using FontFace = std::unique_ptr<cairo_font_face_t, decltype(&cairo_font_face_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

constexpr double reach = 1000;  // pixels around the picture: nothing is drawn farther away, as cairo's numbers end

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  try {
    auto& all = *static_cast<std::vector<std::uint8_t>*>(bytes);
    all.insert(all.end(), data, data + length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

/// Cairo reads the file itself: it sets sizes of its own, and keeps what it has read.
FontFace face_of(const std::filesystem::path& file) {
  const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> pattern(FcPatternCreate(), FcPatternDestroy);
  if (!pattern) throw std::bad_alloc();
  FcPatternAddString(pattern.get(), FC_FILE, reinterpret_cast<const FcChar8*>(file.c_str()));
  FcPatternAddBool(pattern.get(), FC_HINTING, FcFalse);
  return {cairo_ft_font_face_create_for_pattern(pattern.get()), cairo_font_face_destroy};
}

/// Glyphs of one size, and the letters that they stand for.
struct GlyphRun {
  double size;
  std::vector<cairo_glyph_t> glyphs = {};
  std::vector<cairo_text_cluster_t> clusters = {};
  std::string letters = {};
};

std::vector<GlyphRun> runs_of(const Canvas::PlacedText& text) {
  std::vector<GlyphRun> runs;
  for (const PlacedGlyph& glyph : text.line.glyphs) {
    if (runs.empty() || runs.back().size != glyph.size) runs.push_back({glyph.size});
    GlyphRun& run = runs.back();
    const std::string letter = utf8_of(glyph.code);
    run.glyphs.push_back({glyph.index, text.pen.x() + glyph.pen.x(), text.pen.y() + glyph.pen.y()});
    run.clusters.push_back({static_cast<int>(letter.size()), 1});
    run.letters += letter;
  }
  return runs;
}

/// Draws each shape where `cairo` has the pixels of the canvas.
class Drawing {
 public:
  Drawing(cairo_t* cairo, const Canvas& canvas) : cairo_(cairo), canvas_(canvas) {}

  void operator()(const shape::Polygon& polygon) {
    for (const Vec2& corner : clip_polygon(canvas_.to_pixels(polygon.corners), surroundings()))
      cairo_line_to(cairo_, corner.x(), corner.y());
    set_color(polygon.fill);
    cairo_fill(cairo_);
  }

  /// Where a segment begins far away a path of its own begins, whose dashes go on as if it had come all the way.
  void operator()(const shape::Polyline& line) {
    const std::vector<Vec2> corners = canvas_.to_pixels(line.corners);
    double travelled = 0;
    bool goes_on = false;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Vec2 &from = corners[i - 1], way = corners[i] - from;
      const auto near = clip_segment(from, corners[i], surroundings());
      if (near && !(goes_on && near->from == 0)) {
        cairo_stroke(cairo_);
        set_line(line.stroke, travelled + near->from * way.norm());
        cairo_move_to(cairo_, from.x() + near->from * way.x(), from.y() + near->from * way.y());
      }
      if (near) cairo_line_to(cairo_, from.x() + near->to * way.x(), from.y() + near->to * way.y());
      goes_on = near && near->to == 1;
      travelled += way.norm();
    }
    cairo_stroke(cairo_);
  }

  void operator()(const shape::Disc& disc) {
    circle(disc.center, disc.radius);
    set_color(disc.fill);
    cairo_fill(cairo_);
  }

  void operator()(const shape::Ring& ring) {
    circle(ring.center, ring.radius);
    set_line(ring.stroke, 0);
    cairo_stroke(cairo_);
  }

  void operator()(const shape::Text& text) {
    const std::vector<GlyphRun> runs = runs_of(canvas_.place(text.position, text.text, text.style));
    cairo_set_font_face(cairo_, face_of(canvas_.font().file(text.style.weight)).get());
    if (text.style.halo.a > 0)
      for (const GlyphRun& run : runs) draw_halo(run, text.style.halo);
    set_color(text.style.color);
    for (const GlyphRun& run : runs) {
      cairo_set_font_size(cairo_, run.size);
      cairo_show_text_glyphs(cairo_, run.letters.data(), static_cast<int>(run.letters.size()), run.glyphs.data(),
                             static_cast<int>(run.glyphs.size()), run.clusters.data(),
                             static_cast<int>(run.clusters.size()), cairo_text_cluster_flags_t{});
    }
  }

  void operator()(const shape::Clip& clip) {
    cairo_restore(cairo_);  // what was clipped before
    cairo_save(cairo_);
    const Vec2 low = canvas_.to_pixels(clip.box.min), size = canvas_.to_pixels(clip.box.max) - low;
    if (size.x() >= canvas_.pixels().width && size.y() >= canvas_.pixels().height) return;  // which clips itself
    cairo_rectangle(cairo_, low.x(), low.y(), size.x(), size.y());
    cairo_clip(cairo_);
  }

 private:
  void set_color(Color color) {
    cairo_set_source_rgba(cairo_, color.r / 255.0, color.g / 255.0, color.b / 255.0, color.a / 255.0);
  }

  /// `travelled`: pixels that the dashes have come already.
  void set_line(const Stroke& stroke, double travelled) {
    set_color(stroke.color);
    const double width = stroke.width * canvas_.scale(), dash = stroke.dash.length * canvas_.scale();
    cairo_set_line_width(cairo_, width);
    const double straight = std::max(0.0, dash - width), period = dash + stroke.dash.gap * canvas_.scale();
    const double lengths[] = {straight, period - straight};  // the caps belong to the dash
    const bool is_dashed = stroke.dash.gap > 0;
    cairo_set_dash(cairo_, lengths, is_dashed ? 2 : 0, is_dashed ? std::fmod(travelled, period) : 0);
  }

  void circle(const Vec2& center, double radius) {
    const Vec2 middle = canvas_.to_pixels(center);
    if ((middle.array().abs() < 1e6).all())
      cairo_arc(cairo_, middle.x(), middle.y(), radius * canvas_.scale(), 0, 2 * std::numbers::pi);
  }

  void draw_halo(const GlyphRun& run, Color color) {
    cairo_set_font_size(cairo_, run.size);
    cairo_glyph_path(cairo_, run.glyphs.data(), static_cast<int>(run.glyphs.size()));
    set_line({.color = color, .width = 2 * halo_width}, 0);
    cairo_stroke(cairo_);
  }

  Box surroundings() const {
    const auto [width, height] = canvas_.pixels();
    return Box{Vec2::Zero(), Vec2(width, height)}.grown(reach);
  }

  cairo_t* cairo_;
  const Canvas& canvas_;
};

void draw(cairo_t* cairo, const Canvas& canvas) {
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
  cairo_save(cairo);
  Drawing drawing(cairo, canvas);
  for (const Shape& shape : canvas.shapes()) std::visit(drawing, shape);
  cairo_restore(cairo);
}

void paint(cairo_t* cairo, Color color) {
  cairo_set_source_rgb(cairo, color.r / 255.0, color.g / 255.0, color.b / 255.0);
  cairo_paint(cairo);
}

void draw_part(cairo_t* cairo, const OnPaper& on_paper) {
  const auto& [canvas, part, corner, scale] = on_paper;
  const Vec2 low = canvas->to_pixels(part.min), size = canvas->to_pixels(part.max) - low;
  cairo_save(cairo);
  cairo_translate(cairo, corner.x(), corner.y());
  cairo_scale(cairo, scale / canvas->scale(), scale / canvas->scale());
  cairo_translate(cairo, -low.x(), -low.y());
  cairo_rectangle(cairo, low.x(), low.y(), size.x(), size.y());
  cairo_clip(cairo);
  draw(cairo, *canvas);
  cairo_restore(cairo);
}

/// Errors: FileError, whatever went wrong before: cairo then did nothing more.
void finish(const Surface& surface, const Context& cairo) {
  cairo_surface_finish(surface.get());
  for (const cairo_status_t status : {cairo_status(cairo.get()), cairo_surface_status(surface.get())})
    if (status != CAIRO_STATUS_SUCCESS)
      throw FileError(std::string("cannot make a PDF or SVG file: ") + cairo_status_to_string(status) + memory_limit());
}

}  // namespace

std::vector<std::uint8_t> encode_pdf(std::span<const PdfPage> pages, const PaperSize& paper, Color color,
                                     const PngText& text) {
  std::vector<std::uint8_t> bytes;
  const Surface surface(cairo_pdf_surface_create_for_stream(append, &bytes, paper.width, paper.height),
                        cairo_surface_destroy);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, text.title.c_str());
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_SUBJECT, text.description.c_str());
  const Context cairo(cairo_create(surface.get()), cairo_destroy);
  for (const PdfPage& page : pages) {
    paint(cairo.get(), color);
    for (const OnPaper& part : page) draw_part(cairo.get(), part);
    cairo_show_page(cairo.get());
  }
  finish(surface, cairo);
  return bytes;
}

std::vector<std::uint8_t> encode_svg(const Canvas& canvas, const PngText& text) {
  std::vector<std::uint8_t> bytes;
  const auto [width, height] = canvas.pixels();
  const Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, width, height), cairo_surface_destroy);
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PX);
  const Context cairo(cairo_create(surface.get()), cairo_destroy);
  paint(cairo.get(), canvas.background());
  draw(cairo.get(), canvas);
  finish(surface, cairo);
  // Cairo knows neither of the two; they stand first in the picture.
  const std::string words =
      "\n<title>" + escaped(text.title) + "</title>\n<desc>" + escaped(text.description) + "</desc>";
  const std::string_view beginning = "<svg ";
  const auto tag = std::ranges::search(bytes, beginning).begin();
  bytes.insert(std::find(tag, bytes.end(), '>') + 1, words.begin(), words.end());
  // And it numbers the pictures of a process.
  const std::string_view number = " id=\"surface";
  if (const auto found = std::ranges::search(bytes, number); !found.empty())
    bytes.erase(found.begin(), std::find(found.end(), bytes.end(), '"') + 1);
  return bytes;
}

}  // namespace render
