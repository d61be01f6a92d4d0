// Parts of the renderer give what was accepted, on numbers that nobody chose: crowded lattices, on which things coincide, and the
// wide plane around them.

#include <array>
#include <cmath>
#include <limits>
#include <regex>

#include "render/apng.hpp"
#include "render/camera.hpp"
#include "render/compare_report.hpp"
#include "render/coverage.hpp"
#include "render/html.hpp"
#include "render/panel.hpp"
#include "render/utf8.hpp"
#include "tests/core/support.hpp"
#include "tests/golden/checksum.hpp"
#include "tests/kit/catch.hpp"

using namespace golden;
using namespace render;
using gjk::test::Dice;

namespace {

constexpr int rounds = 1000;

// -- Things at random -------------------------------------------------------------------------------------------------

// No two dice are thrown where a compiler may choose which is first.

Vec2 place(Dice& dice) {
  const double x = dice.between(-2, 8) * 20.0, y = dice.between(-2, 8) * 15.0;
  if (dice.between(0, 1) == 0) return {x, y};
  const double right = dice.between(-9.0, 9.0), down = dice.between(-9.0, 9.0);
  return {x + right, y + down};
}

/// Anything, also what is not finite.
Vec2 any_place(Dice& dice) {
  Vec2 point = place(dice);
  if (dice.between(0, 40) == 0) point.x() = std::numeric_limits<double>::quiet_NaN();
  if (dice.between(0, 40) == 0) point.y() = dice.between(0, 1) == 0 ? 1e9 : -std::numeric_limits<double>::infinity();
  return point;
}

Box box(Dice& dice) {
  const Vec2 one = place(dice), other = place(dice);
  return {one.cwiseMin(other), one.cwiseMax(other)};
}

/// Corners of a convex polygon, on a circle; some twice, some on a line with their neighbours, perhaps all at one place.
std::vector<Vec2> convex(Dice& dice) {
  const Vec2 middle = place(dice);
  const double size = dice.between(0, 9) == 0 ? 0 : dice.between(0.2, 90.0), sense = dice.between(0, 1) == 0 ? 1 : -1;
  std::vector<Vec2> corners;
  double angle = 0;
  for (int left = dice.between(1, 9); left > 0; --left) {
    angle += dice.between(0, 4) == 0 ? 0 : dice.between(0.05, 0.9);
    corners.emplace_back(middle + size * Vec2(std::cos(angle), sense * std::sin(angle)));
    if (corners.size() > 1 && dice.between(0, 5) == 0) corners.back() = corners[corners.size() - 2];
  }
  return corners;
}

Color color(Dice& dice) {
  const auto part = [&] { return static_cast<std::uint8_t>(dice.between(0, 255)); };
  Color c;
  c.r = part();
  c.g = part();
  c.b = part();
  c.a = dice.between(0, 4) == 0 ? part() : 255;
  return c;
}

Stroke stroke(Dice& dice) {
  Stroke s;
  s.color = color(dice);
  s.width = dice.between(0.0, 6.0);
  if (dice.between(0, 1) == 0) return s;
  s.dash.length = dice.between(0.5, 12.0);
  s.dash.gap = dice.between(0, 3) == 0 ? 0 : dice.between(0.5, 12.0);
  return s;
}

std::string words(Dice& dice) {
  static const std::array<std::string, 16> parts{"A",        "AB_n",   "ABC_{n·AO}", " ",      "x\\_1", "−3.25",
                                                 "ä",        "√2",     "שלום",       "\xFF",   "سلام",  "R_2 ",
                                                 "\xF0\x9F", "<&>\"'", "_{",         "origin "};
  std::string text;
  for (int left = dice.between(0, 7); left > 0; --left) text += parts[static_cast<std::size_t>(dice.between(0, 15))];
  return text;
}

TextStyle text_style(Dice& dice) {
  TextStyle style{.size = dice.between(4.0, 40.0)};
  style.weight = dice.between(0, 1) == 0 ? Weight::regular : Weight::bold;
  style.color = color(dice);
  style.align = std::array{Align::left, Align::center, Align::right}[static_cast<std::size_t>(dice.between(0, 2))];
  if (dice.between(0, 1) == 0) style.halo = palette::white;
  return style;
}

// -- What is made of them ---------------------------------------------------------------------------------------------

void add(Checksum& sum, const Vec2& point) {
  sum.add(point.x());
  sum.add(point.y());
}

void add(Checksum& sum, const std::vector<Vec2>& points) {
  sum.add(static_cast<long>(points.size()));
  for (const Vec2& point : points) add(sum, point);
}

void add(Checksum& sum, const Box& box) {
  add(sum, box.min);
  add(sum, box.max);
}

void clipping(Checksum& sum, Dice& dice) {
  const Vec2 from = place(dice), to = dice.between(0, 9) == 0 ? from : place(dice);
  const auto part = clip_segment(from, to, box(dice));
  sum.add(part ? 1000 * part->from : -1);
  sum.add(part ? 1000 * part->to : -1);
  sum.add(distance_to_segment(place(dice), from, to));
  const Vec2 gradient = place(dice);
  const double offset = dice.between(-9, 9) * 20.0, tolerance = dice.between(0.01, 9.0);
  add(sum, clip_polygon(convex(dice), gradient, offset));
  add(sum, simplified(convex(dice), tolerance));
}

void coverage(Checksum& sum, Dice& dice) {
  const std::vector<Vec2> corners = convex(dice);
  for (const CoverageCell& cell : coverage_cells(corners, box(dice)))
    for (const CoveragePoint& point : cell) {
      add(sum, point.position);
      sum.add(1000 * point.coverage);
    }
}

void canvas(Checksum& sum, Dice& dice, Font& font) {
  const Size pixels{dice.between(16, 400), dice.between(16, 400)};
  Canvas canvas(pixels, {dice.between(50, 300), dice.between(50, 300)}, palette::white, font);
  if (dice.between(0, 2) == 0) canvas.clip(box(dice));
  for (int left = 12; left > 0; --left) {
    const Vec2 a = any_place(dice), b = dice.between(0, 9) == 0 ? a : any_place(dice);
    const Stroke s = stroke(dice);
    const double length = dice.between(0.0, 60.0);
    const std::vector<Vec2> corners = convex(dice);
    switch (dice.between(0, 9)) {
      case 0: canvas.line(a, b, s); break;
      case 1: canvas.arrow(a, b, s); break;
      case 2: canvas.disc(a, length, s.color); break;
      case 3: canvas.circle(a, length, s); break;
      case 4: canvas.plus(a, length, s); break;
      case 5: canvas.rectangle({a.cwiseMin(b), a.cwiseMax(b)}, s.color); break;
      case 6:
        if (corners.size() >= 3) canvas.polygon(corners, s.color);
        break;
      case 7: canvas.outline(corners, s); break;
      case 8: canvas.polyline(corners, s); break;
      default:
        const TextStyle style = text_style(dice);
        const std::string text = words(dice);
        canvas.text(a, text, style);
        add(sum, canvas.text_box(place(dice), text, style));
        add(sum, canvas.ink_box(place(dice), text, style));
        sum.add(canvas.cap_height(style));
        for (const std::string& line : wrap(canvas, text, style, length)) sum.add(line + "\n");
    }
    if (dice.between(0, 12) == 0) canvas.unclip();
  }
  sum.add(canvas.smallest_text());
  sum.add(canvas);
}

void draw_at_random(Panel& panel, Dice& dice) {
  const Vec2 a = place(dice), b = dice.between(0, 9) == 0 ? a : place(dice);
  const Stroke s = stroke(dice);
  const std::vector<Vec2> corners = convex(dice);
  const double length = dice.between(0.0, 30.0);
  switch (dice.between(0, 9)) {
    case 0: return panel.line(a, b, s);
    case 1: return panel.outline(corners, s);
    case 2: return panel.arrow(a, b, s);
    case 3: return panel.disc(a, length, s.color);
    case 4: return panel.circle(a, length, s);
    case 5: return panel.plus(a, length, s);
    case 6: return panel.hatch(corners, length, s);
    case 7: return panel.grid(length + 3, s, a);
    case 8: return panel.keep_clear({a.cwiseMin(b), a.cwiseMax(b)});
    default:
      if (corners.size() >= 3) panel.polygon(corners, s.color);
  }
}

void name_at_random(Panel& panel, Dice& dice) {
  const Vec2 anchor = place(dice), toward = place(dice);
  TextStyle style = text_style(dice);
  style.size = dice.between(8.0, 22.0);
  const std::string text = words(dice);
  const std::vector<Vec2> area = convex(dice);
  switch (dice.between(0, 3)) {
    case 0: return panel.label(anchor, toward, text, style);
    case 1: return panel.label(anchor, toward, text, style, dice.between(2.0, 40.0));
    case 2: return panel.label_on_its_side(anchor, toward, text, style);
    default:
      std::vector<std::string> shorter;
      for (int left = dice.between(0, 2); left > 0; --left) shorter.push_back(words(dice));
      if (area.size() >= 3) panel.name_area(area, text, style, shorter);
  }
}

void panel(Checksum& sum, Dice& dice, Font& font) {
  Canvas canvas({300, 220}, {300, 220}, palette::white, font);
  const Vec2 low = place(dice), high = low + place(dice).cwiseAbs();
  const Box frame{{10, 10}, {dice.between(120.0, 290.0), dice.between(80.0, 210.0)}};
  {
    Panel panel(canvas, frame, View::fit(low, high, frame, dice.between(0.2, 5.0)));
    for (int left = dice.between(0, 14); left > 0; --left) draw_at_random(panel, dice);
    for (int left = dice.between(0, 5); left > 0; --left) name_at_random(panel, dice);
    sum.add(long{panel.place_labels(dice.between(0, 1) == 0 ? 1 : dice.between(0.5, 1.0))});
    const Vec2 held = place(dice);
    sum.add(long{panel.holds(held, dice.between(0.0, 20.0))});
    add(sum, panel.corners());
  }
  sum.add(canvas);
}

void camera(Checksum& sum, Dice& dice) {
  const int azimuth = dice.between(-18, 18), elevation = dice.between(-17, 17), turn = dice.between(-3, 3);
  const Camera camera = Camera(10 * azimuth, 5 * elevation).turned(30 * turn);
  const auto point = [&] { return gjk::test::vec<double>(dice.point(3)); };
  std::vector<Face> faces;
  for (int left = dice.between(1, 7); left > 0; --left) {
    const Vec3 a = point(), ab = point(), ac = point();
    faces.push_back(dice.between(0, 1) == 0 ? Face{{a, a + ab, a + ac}} : Face{{a, a + ab, a + ab + ac, a + ac}});
    for (int i = 0; i < 3; ++i) sum.add(faces.back().outward()[i]);
    for (int i = 0; i < 3; ++i) sum.add(faces.back().middle()[i]);
    sum.add(camera.depth(a));
    sum.add(long{camera.sees(ab)});
  }
  for (const std::size_t place : back_to_front(faces, camera)) sum.add(static_cast<long>(place));
  for (const Edge& edge : edges_of(faces, camera)) {
    add(sum, camera(edge.from));
    add(sum, camera(edge.to));
    sum.add(long{edge.hidden});
  }
}

Image picture(Dice& dice, Size size) {
  Image image(size);
  image.fill(dice.between(0, 1) == 0 ? palette::white : color(dice));
  return image;
}

void add(Checksum& sum, const Image& image) {
  for (int y = 0; y < image.size().height; ++y)
    sum.add(std::string(reinterpret_cast<const char*>(image.row(y)), static_cast<std::size_t>(3 * image.size().width)));
}

void pictures(Checksum& sum, Dice& dice) {
  const Size size{dice.between(1, 9), dice.between(1, 9)},
      small{dice.between(1, size.width), dice.between(1, size.height)};
  Image image = picture(dice, size);
  const int x = dice.between(0, size.width - small.width), y = dice.between(0, size.height - small.height);
  image.paste(picture(dice, small), x, y);
  add(sum, image);
  add(sum, part_of(image, x / 2, y / 2, small));
  const Color last = image.pixel(size.width - 1, size.height - 1);
  for (const int channel : {last.r, last.g, last.b, last.a}) sum.add(long{channel});
}

/// The files themselves, as this zlib packs them.
void files(Checksum& sum, Dice& dice) {
  const Size size{dice.between(1, 30), dice.between(1, 30)};
  const PngText text{words(dice), words(dice)};
  Animation animation(text);
  for (int left = dice.between(1, 4); left > 0; --left) {
    const std::vector<std::uint8_t> png = encode_png(picture(dice, size), text);
    add(sum, decode_png(png, "a picture"));
    animation.add(png, dice.between(0.0, 90.0));
  }
  sum.add(std::string(animation.bytes().begin(), animation.bytes().end()));
}

/// A picture like `image`, of which some pixels differ by a little or by much.
Image like(const Image& image, Dice& dice) {
  Image other = image;
  const Size size = image.size();
  const int groups = dice.between(0, 12), size_of_group = dice.between(0, 3);
  for (int left = groups * size_of_group; left > 0; --left) {
    const int row = dice.between(0, size.height - 1), place = dice.between(0, 3 * size.width - 1);
    std::uint8_t& channel = other.row(row)[place];
    channel = static_cast<std::uint8_t>(channel ^ (1 << dice.between(0, 7)));
  }
  return other;
}

Tolerance tolerance(Dice& dice) {
  if (dice.between(0, 1) == 0) return {};
  return {.channel = dice.between(0, 70), .few = dice.between(0, 20), .group = dice.between(1, 9), .reason = "tried"};
}

ComparedFiles compared(Dice& dice) {
  const Size size{dice.between(1, 40), dice.between(1, 40)};
  const Image image = picture(dice, size);
  ComparedFiles files;
  files.expected = image;
  files.actual = dice.between(0, 9) == 0 ? Image({size.width, size.height + 1}) : like(image, dice);
  files.comparison = compare(*files.expected, *files.actual, tolerance(dice));
  files.verdict = files.comparison.verdict;
  files.words = in_words(files.comparison);
  files.files.name = words(dice) + ".png";
  if (dice.between(0, 9) == 0) {
    files.actual.reset();
    files.verdict = dice.between(0, 1) == 0 ? Verdict::missing : Verdict::unreadable;
  }
  return files;
}

void comparison(Checksum& sum, Dice& dice) {
  const ComparedFiles files = compared(dice);
  const Comparison& found = files.comparison;
  for (const std::int64_t number : {found.off, found.allowed, found.largest_group}) sum.add(static_cast<long>(number));
  for (const int number : {found.largest_difference(), found.box.min_x, found.box.max_y}) sum.add(long{number});
  sum.add(name(found.verdict) + files.words);
  if (found.expected != found.actual || !files.actual) return;
  add(sum, difference(*files.expected, *files.actual));
}

/// Without the pictures' bytes, which another zlib packs otherwise.
void report(Checksum& sum, Dice& dice) {
  CompareReport report({.expected = words(dice), .actual = words(dice)}, {.failures = 3, .passes = 2});
  for (int left = dice.between(0, 9); left > 0; --left) {
    const std::string command = dice.between(0, 1) == 0 ? "" : "cp " + words(dice);
    report.add(compared(dice), command);
  }
  sum.add(std::regex_replace(report.html(), std::regex("base64,[^\"]*"), ""));
}

void letters(Checksum& sum, Dice& dice) {
  const std::string text = words(dice);
  sum.add(escaped(text));
  for (std::string_view left = text; !left.empty();) sum.add(static_cast<long>(next_code_point(left)));
}

/// A font of its own: where its letters stand in the atlas depends on all that it has set.
void atlas(Checksum& sum, Dice& dice) {
  Font font(Font::default_directory());
  for (int left = 25; left > 0; --left) {
    const double size = dice.between(0, 9) == 0 ? dice.between(0.0, 500.0) : dice.between(5.0, 60.0);
    const Weight weight = dice.between(0, 1) == 0 ? Weight::regular : Weight::bold;
    const TextLine line = font.set(words(dice), size, weight);
    for (const double number : {line.advance, line.ascent, line.descent, line.cap_height}) sum.add(number);
    for (const PlacedGlyph& g : line.glyphs)
      for (const int number : {g.x, g.y, g.width, g.height, g.atlas_x, g.atlas_y}) sum.add(long{number});
  }
  sum.add(long{font.atlas_height()});
  sum.add(std::string(font.atlas().begin(), font.atlas().end()));
  for (const char32_t missing : font.missing()) sum.add(static_cast<long>(missing));
}

// -- All of them ------------------------------------------------------------------------------------------------------

template <class Part>
std::string line_of(const std::string& name, int times, Part part) {
  Dice dice(41);
  Checksum sum;
  for (int i = 0; i < times; ++i) part(sum, dice);
  return sum.text() + " " + name;
}

void check_parts(const std::string& file, const std::vector<std::string>& now) {
  check_lines(file, now, "parts", [&](std::size_t i, const std::string&) { return now[i].substr(9) + " changed"; });
}

}  // namespace

TEST_CASE("parts of the renderer do what was accepted") {
  check_parts("parts.txt", {line_of("clipping", rounds, clipping), line_of("coverage", rounds, coverage),
                            line_of("camera", rounds, camera), line_of("comparison", rounds, comparison),
                            line_of("report", 60, report), line_of("letters", rounds, letters),
                            line_of("pictures", rounds, pictures)});
}

TEST_CASE("parts of the renderer that set letters do what was accepted") {
  if (!letters_are_those_accepted()) return;
  Font font(Font::default_directory());
  const auto with = [&](auto part) { return [&font, part](Checksum& sum, Dice& dice) { part(sum, dice, font); }; };
  check_parts("parts_with_letters.txt", {line_of("canvas", rounds, with(canvas)), line_of("panel", rounds, with(panel)),
                                         line_of("atlas", 5, atlas), line_of("files", rounds, files)});
}
