#include "tests/study/sweep/failure_files.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "render/file.hpp"
#include "tests/study/sweep/folder.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace study {
namespace {

std::string list_of(const Vec& v) {
  return "[" + walkthroughs::number_text(v.x()) + ", " + walkthroughs::number_text(v.y()) + ", " +
         walkthroughs::number_text(v.z()) + "]";
}

struct ShapeText {
  std::string operator()(const Points& points) const {
    std::string text = "{\"points\": [";
    for (std::size_t i = 0; i < points.size(); ++i) text += (i == 0 ? "" : ",\n    ") + list_of(points[i]);
    return text + "]}";
  }
  std::string operator()(const Ball& ball) const {
    return "{\"sphere\": {\"center\": " + list_of(ball.center) +
           ", \"radius\": " + walkthroughs::number_text(ball.radius) + "}}";
  }
  std::string operator()(const Can& can) const {
    return "{\"cylinder\": {\"center\": " + list_of(can.center) + ", \"axis\": " + list_of(can.axis) +
           ", \"radius\": " + walkthroughs::number_text(can.radius) +
           ", \"height\": " + walkthroughs::number_text(can.height) + "}}";
  }
};

std::string to_string(Truth truth) {
  return truth == Truth::intersecting ? "they have a point in common" : "they are apart";
}

std::string answer_of(Kind kind) {
  switch (kind) {
    case Kind::false_positive: return "intersecting";
    case Kind::false_negative: return "separated";
    case Kind::undecided: return "undecided";
  }
  return "";
}

double largest(const Vec& v) { return v.cwiseAbs().maxCoeff(); }

double largest_number(const Body& body) {
  if (const Points* const points = std::get_if<Points>(&body)) {
    double most = 0;
    for (const Vec& p : *points) most = std::max(most, largest(p));
    return most;
  }
  if (const Ball* const ball = std::get_if<Ball>(&body)) return std::max(largest(ball->center), ball->radius);
  const Can& can = std::get<Can>(body);
  return std::max({largest(can.center), largest(can.axis), can.radius, can.height});
}

std::string comments(const Failure& failure, std::uint64_t seed) {
  const Method& method = *failure.method;
  std::string text = "// Truth: " + to_string(failure.truth) + ". Answer: " + answer_of(failure.kind) + ".\n// Pair " +
                     std::to_string(failure.index) + " of family " + failure.family + ", seed " + std::to_string(seed) +
                     ". Rules " + method.rules + ", scalar " + method.scalar.name + ", zero test " + method.zero_test +
                     ", at most " + std::to_string(failure.limit) + " iterations.\n";
  if (method.scalar.name != "float" && method.scalar.name != "double")
    text += "// A scene cannot run in this scalar: what is drawn is the run in double, which may end in another way.\n";
  return text;
}

/// Keys that have no default are written where they are needed only.
std::string keys_of(const Failure& failure) {
  const Method& method = *failure.method;
  std::string text =
      "  \"iteration_limit\": " + std::to_string(failure.limit) + ",\n  \"rules\": \"" + method.rules + "\"";
  if (method.scalar.name == "float") text += ",\n  \"scalar\": \"float\"";
  if (method.zero_test != "exact") text += ",\n  \"zero_test\": \"" + method.zero_test + "\"";
  return text;
}

}  // namespace

std::string to_string(Kind kind) {
  switch (kind) {
    case Kind::false_positive: return "false positive";
    case Kind::false_negative: return "false negative";
    case Kind::undecided: return "undecided";
  }
  return "";
}

std::string scene_of(const Failure& failure, std::uint64_t seed) {
  return comments(failure, seed) + "{\n  \"title\": \"" + to_string(failure.kind) + ": " + failure.family + ", pair " +
         std::to_string(failure.index) + "\",\n  \"a\": " + std::visit(ShapeText{}, failure.pair.a) +
         ",\n  \"b\": " + std::visit(ShapeText{}, failure.pair.b) + ",\n" + keys_of(failure) + "\n}\n";
}

std::string scene_name(const Failure& failure) {
  std::string name = failure.family + "-" + failure.method->name() + "-" + to_string(failure.kind) + "-" +
                     std::to_string(failure.index) + ".json";
  std::ranges::replace(name, ' ', '-');
  return name;
}

bool fits_scene(const Failure& failure) {
  return std::max(largest_number(failure.pair.a), largest_number(failure.pair.b)) <=
         walkthroughs::scene_limits::magnitude;
}

Saved write_failures(const std::filesystem::path& folder, const std::vector<Failure>& failures, std::uint64_t seed) {
  make_folder(folder);
  Saved saved;
  for (const Failure& failure : failures) {
    if (!fits_scene(failure)) {
      ++saved.left_out;
      continue;
    }
    render::write_file(folder / scene_name(failure), scene_of(failure, seed));
    ++saved.files;
  }
  return saved;
}

std::string left_out_words(const Saved& saved) {
  if (saved.left_out == 0) return "";
  return std::to_string(saved.left_out) + (saved.left_out == 1 ? " failure is" : " failures are") +
         " not saved: a number in them is beyond " + walkthroughs::number_text(walkthroughs::scene_limits::magnitude) +
         ", the largest that a scene file may hold";
}

}  // namespace study
