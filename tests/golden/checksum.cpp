#include "tests/golden/checksum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "render/rendered_by.hpp"
#include "tests/golden/store.hpp"
#include "tests/kit/catch.hpp"

namespace golden {

using render::CanvasVertex;

namespace {

void add(Checksum& sum, const CanvasVertex& v) {
  for (const float number : {v.x, v.y, v.half_length, v.radius}) sum.add(double{number});
  if (v.kind != CanvasVertex::Kind::glyph)
    for (const float number : {v.u, v.v}) sum.add(double{number});
  for (const int number : {int{v.color.r}, int{v.color.g}, int{v.color.b}, int{v.color.a}, static_cast<int>(v.kind)})
    sum.add(long{number});
}

}  // namespace

void Checksum::add(const std::string& text) {
  value_ = crc32_z(value_, reinterpret_cast<const Bytef*>(text.data()), text.size());
}

void Checksum::add(double number) {
  // A step that no number of a drawing is a multiple of, so that none lies on the border of two.
  if (std::abs(number) < 1e15)
    add(std::lround(std::floor(number / 0.0137 + 0.317)));
  else
    add(std::string(number > 0 ? "large " : number < 0 ? "-large " : "nan "));
}

void Checksum::add(const render::Canvas& canvas) {
  for (const CanvasVertex& v : canvas.vertices()) golden::add(*this, v);
  for (const render::Canvas::Run& run : canvas.runs())
    for (const int number : {run.first, run.left, run.top, run.right, run.bottom}) add(long{number});
}

std::string Checksum::text() const {
  char digits[9];
  std::snprintf(digits, sizeof digits, "%08lx", value_);
  return digits;
}

std::string checksum_of(const std::string& text) {
  Checksum sum;
  sum.add(text);
  return sum.text();
}

bool letters_are_those_accepted() {
  const auto notes = render::read_rendered_by(folder() / "images");
  const bool is_same = notes && std::ranges::any_of(*notes, [](const auto& note) {
                         return note.first == "FreeType" && note.second == render::freetype_version();
                       });
  if (!is_same) WARN("skipped: letters are as wide as another FreeType makes them");
  return is_same;
}

void check_lines(const std::string& file, const std::vector<std::string>& now, const std::string& tests,
                 const std::function<std::string(std::size_t line, const std::string& accepted)>& in_words) {
  constexpr int most_told = 5;
  std::string all, differences, line;
  for (const std::string& each : now) all += each + "\n";
  CHECK(all.size() <= 20 * 1024);
  const std::string accepted_lines = accepted_text(file);
  if (all == accepted_lines) return;
  if (accepting()) return accept(file, all, "what " + tests + " looks at has changed");
  std::istringstream accepted(accepted_lines);
  int told = 0;
  for (std::size_t i = 0; i < now.size() && told < most_told; ++i) {
    line.clear();
    std::getline(accepted, line);
    if (line != now[i] && ++told) differences += in_words(i, line) + "\n";
  }
  FAIL_CHECK(differences << "Look at it (gjkstep render), and accept it: "
                         << command_to_accept("golden-tests: " + tests));
}

}  // namespace golden
