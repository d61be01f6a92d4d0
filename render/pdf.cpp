#include "render/pdf.hpp"

#include <cairo-pdf.h>

#include <algorithm>
#include <new>
#include <string>

#include "render/limits.hpp"

namespace render {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

void expect(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw FileError(std::string("cannot make a PDF file: ") + cairo_status_to_string(status) + memory_limit());
}

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  try {
    auto& all = *static_cast<std::vector<std::uint8_t>*>(bytes);
    all.insert(all.end(), data, data + length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

/// Returns: a copy in the format of the library, a 32-bit word a pixel.
Surface surface_of(const Image& image) {
  const auto [width, height] = image.size();
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy);
  expect(cairo_surface_status(surface.get()));
  unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* from = image.row(y);
    auto* const to = reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(y) * stride);
    for (int x = 0; x < width; ++x, from += 3)
      to[x] = static_cast<std::uint32_t>(from[0] << 16 | from[1] << 8 | from[2]);
  }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

}  // namespace

struct Pdf::Impl {
  std::vector<std::uint8_t> bytes;
  Surface surface{cairo_pdf_surface_create_for_stream(append, &bytes, 1, 1), cairo_surface_destroy};
};

Pdf::Pdf(const PngText& text) : impl_(std::make_unique<Impl>()) {
  cairo_surface_t* const surface = impl_->surface.get();
  expect(cairo_surface_status(surface));
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, text.title.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, text.description.c_str());
}

Pdf::~Pdf() = default;

void Pdf::add(const Image& image, const PaperSize& paper) {
  const Surface picture = surface_of(image);
  cairo_pdf_surface_set_size(impl_->surface.get(), paper.width, paper.height);
  const Context page(cairo_create(impl_->surface.get()), cairo_destroy);
  cairo_scale(page.get(), paper.width / image.size().width, paper.height / image.size().height);
  cairo_set_source_surface(page.get(), picture.get(), 0, 0);
  cairo_paint(page.get());
  cairo_show_page(page.get());
  expect(cairo_status(page.get()));
}

std::vector<std::uint8_t> Pdf::finish() {
  cairo_surface_finish(impl_->surface.get());
  expect(cairo_surface_status(impl_->surface.get()));
  return std::move(impl_->bytes);
}

}  // namespace render
