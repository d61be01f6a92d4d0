// PDF and SVG files: a reader of PDF files finds in them what the rasterizer draws, and the letters.
#include "render/vector.hpp"

#include <array>
#include <cstdlib>
#include <limits>
#include <optional>
#include <regex>

#include "render/rasterizer.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"
#include "tests/kit/program.hpp"

namespace vector_test {

using namespace render;

namespace {

constexpr Size size{240, 160};
const Box whole{{0, 0}, {240, 160}};

struct Page {
  Font font{Font::default_directory()};
  Canvas canvas{size, size, palette::white, font};
};

std::string text_of(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

std::string pdf_of(const OnPaper& part, std::size_t pages = 1) {
  return text_of(encode_pdf(std::vector(pages, PdfPage{part}), {240, 160}, palette::white, {"its title", ""}));
}
std::string pdf_of(const Canvas& canvas, std::size_t pages = 1) { return pdf_of({&canvas, whole, {0, 0}, 1}, pages); }

std::string svg_of(const Canvas& canvas) { return text_of(encode_svg(canvas, {"<its> title", "what \"it\" shows"})); }

/// Returns: its pixels, as poppler draws them; nothing where there is no poppler.
std::optional<Image> drawn(const std::string& pdf) {
  if (!kit::has(kit::shell("pdftoppm -v").err, "pdftoppm version")) {
    kit::skip("there is no pdftoppm");
    return std::nullopt;
  }
  const kit::Folder folder;
  kit::write(folder / "it.pdf", pdf);
  kit::shell("cd " + kit::quoted(folder.path().string()) + " && pdftoppm -png -r 72 -singlefile it.pdf it");
  return read_png(folder / "it.png").image;
}

/// Checks that nowhere, in squares of 8 pixels, the two differ by more than that share of the square.
void check_alike(const Image& one, const Image& other, double share) {
  REQUIRE(one.size() == other.size());
  for (int y = 0; y < size.height; y += 8)
    for (int x = 0; x < size.width; x += 8) {
      const Box square{{x, y}, {x + 8, y + 8}};
      INFO("at " << x << ", " << y);
      CHECK(kit::darkness(one, square) == Approx(kit::darkness(other, square)).margin(64 * share));
    }
}

void draw_one_of_each(Canvas& canvas) {
  canvas.polygon(std::array{Vec2(20, 20), Vec2(70, 25), Vec2(40, 70)}, palette::black.with_alpha(120));
  canvas.line({90, 20}, {150, 60}, {.color = palette::black, .width = 9});
  canvas.polyline(std::array{Vec2(20, 90), Vec2(80, 90), Vec2(80, 130)}, {.width = 4, .dash = {12, 9}});
  canvas.outline(std::array{Vec2(100, 90), Vec2(140, 90), Vec2(140, 130)}, {.width = 4, .dash = {12, 9}});
  canvas.arrow({170, 20}, {220, 70}, {.color = palette::black, .width = 5});
  canvas.arrow({170, 60}, {180, 60}, {.color = palette::black, .width = 5});
  canvas.disc({180, 110}, 14, palette::black);
  canvas.circle({215, 110}, 14, {.color = palette::black, .width = 5});
  canvas.clip({{0, 140}, {120, 160}});
  canvas.rectangle({{0, 150}, {240, 160}}, palette::black);
  canvas.unclip();
  canvas.line({-5e6, 145.5}, {5e6, 145.5}, {.color = palette::black, .width = 3, .dash = {20, 10}});
}

}  // namespace

TEST_CASE_METHOD(Page, "shapes of a PDF page lie where their pixels do") {
  draw_one_of_each(canvas);
  OffscreenContext context;
  if (const auto page = drawn(pdf_of(canvas))) check_alike(*page, Rasterizer(context).draw(canvas), 0.06);
}

TEST_CASE("letters of a PDF page stand where their pixels do, with their halo and subscripts, at any scale") {
  Font font(Font::default_directory());
  Canvas canvas(size, {120, 80}, palette::white, font);
  canvas.rectangle({{0, 0}, {120, 80}}, palette::grey);
  canvas.text({60, 20}, "AB_n", {.size = 22, .weight = Weight::bold, .color = palette::white, .align = Align::center});
  canvas.text({115, 50}, "above", {.size = 18, .align = Align::right, .halo = palette::white});
  OffscreenContext context;
  if (const auto page = drawn(pdf_of({&canvas, {{0, 0}, {120, 80}}, {0, 0}, 2})))
    check_alike(*page, Rasterizer(context).draw(canvas), 0.16);  // pixels are whole
}

TEST_CASE_METHOD(Page, "a part of a canvas is drawn alone, from its corner on") {
  canvas.rectangle(whole, palette::black);
  if (const auto page = drawn(pdf_of({&canvas, {{100, 50}, {140, 70}}, {20, 10}, 2}))) {
    CHECK(kit::darkness(*page, whole) == Approx(80 * 40).margin(10));
    CHECK(kit::darkness(*page, {{20, 10}, {100, 50}}) == Approx(80 * 40).margin(1));
  }
}

TEST_CASE_METHOD(Page, "the texts of a PDF file are found, also those of other scripts, and the font is inside") {
  canvas.text({20, 40}, "not A_1·d, but −½ → ∞", {.size = 14});
  canvas.text({20, 80}, "שלום", {.size = 14});
  const kit::Folder folder;
  kit::write(folder / "it.pdf", pdf_of(canvas));
  const std::string file = kit::quoted((folder / "it.pdf").string());
  if (!kit::has(kit::shell("pdftotext -v").err, "pdftotext version")) return kit::skip("there is no pdftotext");
  const std::string found = kit::shell("pdftotext " + file + " -").out;
  INFO(found);
  for (const char* words : {"not A", "·d, but −½ → ∞", "שלום"}) CHECK(kit::has(found, words));
  CHECK(std::regex_search(kit::shell("pdffonts " + file).out, std::regex("DejaVuSans .* yes +yes +yes")));
}

TEST_CASE_METHOD(Page, "the same canvas is the same file, without a date, and each page adds to it") {
  draw_one_of_each(canvas);
  canvas.text({20, 40}, "A_1", {.size = 14, .halo = palette::white});
  const std::string two = pdf_of(canvas, 2);
  CHECK(two.starts_with("%PDF-"));
  CHECK(two.ends_with("%%EOF\n"));
  CHECK_FALSE(kit::has(two, "CreationDate"));
  CHECK(two == pdf_of(canvas, 2));
  CHECK(pdf_of(canvas, 3).size() > two.size() + 100);
  CHECK(svg_of(canvas) == svg_of(canvas));
}

TEST_CASE("an SVG picture is as large as its pixels, and says what it is") {
  Font font(Font::default_directory());
  const std::string svg = svg_of(Canvas({64, 36}, {640, 360}, palette::sky, font));
  CHECK(kit::has(svg, "width=\"64px\" height=\"36px\" viewBox=\"0 0 64 36\""));
  CHECK(kit::has(svg, ">\n<title>&lt;its&gt; title</title>\n<desc>what &quot;it&quot; shows</desc>\n"));
  CHECK(svg.ends_with("</svg>\n"));
}

TEST_CASE_METHOD(Page, "what lies far outside of an SVG picture is cut off, so that any program can read its numbers") {
  const double far = 1e10;
  canvas.line({-far, 20}, {far, 30}, {.width = 2, .dash = {9, 4}});
  canvas.polyline(std::array{Vec2(10, 10), Vec2(far, 20), Vec2(30, far), Vec2(20, 30)}, {});
  canvas.polygon(std::array{Vec2(50, 50), Vec2(far, 60), Vec2(-far, far)}, palette::sky);
  canvas.disc({far, 5}, 3, palette::ink);
  canvas.text({-far, 5}, "text", {.size = 9});
  const std::string svg = svg_of(canvas);
  const std::regex number("-?[0-9]+(\\.[0-9]+)?");
  const std::string paths = svg.substr(svg.find("<path"));
  double farthest = 0;
  for (auto at = std::sregex_iterator(paths.begin(), paths.end(), number); at != std::sregex_iterator(); ++at)
    farthest = std::max(farthest, std::abs(std::stod(at->str())));
  CHECK(farthest > 240);
  CHECK(farthest < 2000);
}

}  // namespace vector_test
