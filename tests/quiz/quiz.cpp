// gjkstep-quiz: pictures of the moment before a decision, without words and numbers, and a key of what is decided then. Whoever can
// tell from the picture alone what the search will decide has seen the decision.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <random>
#include <sstream>

#include "render/file.hpp"
#include "walkthroughs/output/renderer.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/picture/pencil.hpp"
#include "walkthroughs/program/exit_code.hpp"
#include "walkthroughs/program/number_option.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace {

using namespace walkthroughs::program;
using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t count) { return static_cast<std::size_t>(random() % count); }

/// Points on a grid of quarters, so that no two machines round differently.
Points some_points(Random& random, Dimension dimension, std::size_t count) {
  const auto coordinate = [&] { return (static_cast<double>(below(random, 33)) - 16) / 4; };
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = coordinate(), y = coordinate();
    points.emplace_back(x, y, dimension == Dimension::space ? coordinate() : 0);
  }
  return points;
}

Walkthrough some_walkthrough(Random& random, Dimension dimension, Naming letters) {
  Points b = some_points(random, dimension, 4);
  const Point shift = some_points(random, dimension, 1)[0] / 2;
  for (Point& p : b) p += shift;
  return {.name = "question",
          .title = "question",
          .source = "",
          .summary = "",
          .panels = {.objects = false, .hull = true, .algorithm = false},
          .naming = letters,
          .scenes = {{.name = "question",
                      .a = {"a", some_points(random, dimension, 4), {}},
                      .b = {"b", std::move(b), {}},
                      .dimension = dimension}}};
}

/// The test of Algorithms 3 to 5 that ends the questions about this simplex or face; nothing where there is none.
const gjk::RegionTested<double>* chosen_after(const Trace& trace, std::size_t event, const gjk::Roles& face) {
  for (std::size_t i = event + 1; i < trace.events.size(); ++i) {
    if (std::holds_alternative<gjk::VertexAdded<double>>(trace.events[i])) return nullptr;
    const auto* tested = std::get_if<gjk::RegionTested<double>>(&trace.events[i]);
    if (tested && tested->verdict == gjk::Verdict::chosen && tested->face == face) return tested;
  }
  return nullptr;
}

struct Asked {
  std::string about, text, answer, kind = answer;
  std::optional<std::size_t> second = {};  ///< a frame that is shown beside
};

Asked about_triangle(const gjk::RegionTested<double>& chosen, Dimension dimension, const Names& names) {
  const double* const value = std::get_if<double>(&chosen.value);
  const bool is_inside = chosen.feature == "ABC";
  std::string answer = is_inside ? "inside" : names.sorted(chosen.feature);
  std::string kind = is_inside ? answer : std::string(to_string(label_of(chosen)));
  if (is_inside && dimension == Dimension::space && value)
    answer = kind = *value > 0 ? "above" : *value < 0 ? "below" : "in";
  return {"triangle",
          "Beyond which edge of the triangle does the origin lie, or is it inside (in space: above, below)?", answer,
          kind};
}

/// Where a search is stepped through: which vertices have gone when the next one is there.
std::optional<Asked> about_what_went(const Story& story, std::size_t index) {
  const Moment& now = story.frames[index].moments[0];
  for (std::size_t next = index + 1; next < story.frames.size(); ++next) {
    if (story.frames[next].focus != Focus::added) continue;
    const Moment& then = story.frames[next].moments[0];
    const Names before(story.walkthrough.naming, story.tellings[0].hull, now),
        after(story.walkthrough.naming, story.tellings[0].hull, then);
    std::string went, renamed;
    for (const Point& w : points_of(now.simplex)) {
      const bool is_kept = std::ranges::count(points_of(then.simplex), w) > 0;
      if (!is_kept) went += (went.empty() ? "" : ", ") + before.of(w);
      if (is_kept) renamed += (renamed.empty() ? "" : ", ") + before.of(w) + "=" + after.of(w);
    }
    if (went.empty() || renamed.empty()) return std::nullopt;
    return Asked{"what went",
                 "The second picture shows the search one iteration later. Which vertices of the first have gone "
                 "(letters of the "
                 "first), and which letters do those that stayed have in the second (first=second)?",
                 went + "; " + renamed, std::to_string(now.simplex.size()), next};
  }
  return std::nullopt;
}

/// Returns: what can be asked of the picture after that event; nothing where the search decides nothing next.
std::optional<Asked> asked_of(const Story& story, const Frame& frame) {
  const Trace& trace = story.tellings[0].trace;
  const std::size_t event = frame.events[0].last;
  const Moment& now = frame.moments[0];
  const Dimension dimension = story.tellings[0].scene.dimension;
  const Names names(story.walkthrough.naming, story.tellings[0].hull, now);
  if (frame.focus == Focus::crossing && now.crossing->value && *now.crossing->value != 0)
    return Asked{"crossing", "Does P lie past the origin along d, or short of it?",
                 *now.crossing->value > 0 ? "past" : "short"};
  if (frame.focus == Focus::added) {
    const gjk::RegionTested<double>* const chosen = chosen_after(trace, event, {});
    if (!chosen) return std::nullopt;
    if (now.simplex.size() == 2 && dimension == Dimension::plane)
      return Asked{"segment",
                   "On which side of the segment, going from " + names.of(gjk::Role::B) + " to " +
                       names.of(gjk::Role::A) + ", does the origin lie?",
                   (now.simplex.point(gjk::Role::A) - now.simplex.point(gjk::Role::B))
                               .cross(-now.simplex.point(gjk::Role::B))
                               .z() > 0
                       ? "left"
                       : "right"};
    if (now.simplex.size() == 3) return about_triangle(*chosen, dimension, names);
    if (now.simplex.size() == 4)
      return Asked{"tetrahedron",
                   "Which face, the first of " + names.sorted("ABC") + ", " + names.sorted("ACD") + ", " +
                       names.sorted("ADB") + ", sees the origin? Or is it inside?",
                   chosen->feature == "ABCD" ? "inside" : names.sorted(chosen->feature),
                   chosen->feature == "ABCD" ? "inside" : to_string(chosen->feature)};
  }
  if (frame.focus == Focus::region && now.simplex.size() == 4 && now.regions.back().face.empty() &&
      now.regions.back().verdict == gjk::Verdict::chosen && now.regions.back().feature.size() == 3) {
    const gjk::Roles& face = now.regions.back().feature;
    const gjk::RegionTested<double>* const chosen = chosen_after(trace, event, face);
    return Asked{"edges of a face",
                 "Projected onto its plane, does the origin lie beyond " + names.sorted(gjk::Roles{gjk::Role::A, face[1]}) + ", beyond " +
                     names.sorted(gjk::Roles{gjk::Role::A, face[2]}) + ", or above the face " + names.sorted(face) +
                     "?",
                 names.sorted(chosen ? chosen->feature : face), chosen ? "edge" : "face"};
  }
  return std::nullopt;
}

/// Kinds are told apart by what is asked and by the answer: both sides of a test are drawn as often.
std::string kind_of(const Asked& asked, Dimension dimension) {
  const std::string where = dimension == Dimension::plane ? "plane, " : "space, ";
  return where + asked.about + ": " + asked.kind;
}

/// The moment before a decision: which frame of a walkthrough shows it, and what the search decides next.
struct Question {
  walkthroughs::model::Walkthrough walkthrough;
  std::size_t frame;
  std::string kind;                   ///< "space, triangle: below"
  std::string text;                   ///< what is asked
  std::string answer;                 ///< one of the words that the legend gives for it
  std::optional<std::size_t> second;  ///< a frame to look at beside the first
};

constexpr const char* kinds[] = {
    "plane, crossing: past",        "plane, crossing: short",     "plane, segment: left",
    "plane, segment: right",        "plane, triangle: inside",    "plane, triangle: R3",
    "plane, triangle: R7",          "space, crossing: past",      "space, crossing: short",
    "space, triangle: R3",          "space, triangle: R7",        "space, triangle: above",
    "space, triangle: below",       "space, tetrahedron: ABC",    "space, tetrahedron: ACD",
    "space, tetrahedron: ADB",      "space, tetrahedron: inside", "space, edges of a face: edge",
    "space, edges of a face: face", "plane, what went: 3",        "space, what went: 3",
    "space, what went: 4"};

/// Returns: at least `count` questions about random scenes, as many of each kind, in an order that tells nothing.
/// Deterministic. Requires: count >= 1.
std::vector<Question> questions(std::size_t count, std::uint64_t seed, Naming letters) {
  Random random(seed);
  const std::size_t each = (count + std::size(kinds) - 1) / std::size(kinds);
  std::map<std::string, std::size_t> missing;
  for (const char* const kind : kinds) missing[kind] = each;
  std::vector<Question> found;
  while (found.size() < each * std::size(kinds)) {
    const Dimension dimension = below(random, 4) == 0 ? Dimension::plane : Dimension::space;
    const Walkthrough walkthrough = some_walkthrough(random, dimension, letters);
    const Story story = tell(walkthrough);
    std::vector<Question> here;
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      std::vector<std::optional<Asked>> each_asked{asked_of(story, story.frames[i])};
      if (story.frames[i].focus == Focus::added) each_asked.push_back(about_what_went(story, i));
      for (const std::optional<Asked>& asked : each_asked)
        if (asked && missing[kind_of(*asked, dimension)] > 0)
          here.push_back({walkthrough, i, kind_of(*asked, dimension), asked->text, asked->answer, asked->second});
    }
    if (here.empty()) continue;
    Question& one = here[below(random, here.size())];  // one of each scene
    --missing[one.kind];
    found.push_back(std::move(one));
  }
  for (std::size_t i = found.size(); i > 1; --i)
    std::swap(found[i - 1], found[below(random, i)]);  // std::shuffle is not the same everywhere
  return found;
}

/// Returns: what readers are told before they look: the letters, the signs, and the words for answers.
std::string legend() {
  return R"(Each picture shows one moment of a search for the origin O in a convex set, just before a decision.
Green: the simplex (segment, triangle or tetrahedron) that the search holds. A ring marks its newest vertex.
Grey: the whole set. Red: the point that was found last in direction d; nothing of the set lies in the orange part.
Scenes in space are drawn twice: on the left as space is seen, on the right as the plane in which the decision is plain.
- Plane of d and OP: d points to the right. The red point lies past the origin where it is to the right of O, short of it where
  it is left. The grey bar is the way from O to it along d.
- "edge-on": the triangle is seen as a line, its normal (blue arrow) up. A face sees the origin where O is above the line.
  "heights x8": they are drawn eight times as high. The fourth vertex of a tetrahedron lies below. The picture in which a part is
  hatched only shows where the search comes from: the origin is not in the hatched part.
- "true shape": the triangle seen straight down its normal; O stands where its foot is.
- A small picture in a corner, with "x8", is the part in the thin circle, so many times as large.
- O is a filled disc where it lies above the triangle (where the normal points), a ring where it lies below, a ring around a
  dot where it lies in the triangle's plane, which is not above.
- Coloured or crossed out: what was tested before this decision.
Of a triangle the origin lies beyond one of the two edges at its newest vertex, or inside (in space: straight above or below it).
All other regions were ruled out before.
Answers: past, short | left, right | an edge by its letters, or inside, above, below | a face by its letters, or inside |
of a face: an edge or the face by its letters | what went: letters; first=second, first=second.
)";
}

// -- The program ----------------------------------------------------------------------------------------------------------

std::string number_of(std::size_t index) {
  std::ostringstream name;
  name << std::setw(3) << std::setfill('0') << index;
  return name.str();
}

render::Image picture_of(const Question& question, std::size_t frame, Studio& studio, const Look& look) {
  const StagedStory story(tell(question.walkthrough));
  const render::Size page = page_of_frame(look);
  render::Canvas canvas(page, page, look.style.theme.paper, studio.font);
  draw_frame(canvas, story, frame, look);
  return studio.rasterizer.draw(canvas);
}

int run(int argc, char** argv) {
  CLI::App app("Draws questions: the moment before a decision, without words and numbers; and a key.");
  std::size_t count = 60;
  std::uint64_t seed = 1;
  std::string out = "quiz", letters = "roles";
  expect_number(app.add_option("--count", count, "at least so many, as many of each kind")->capture_default_str(),
                std::size_t{1}, std::size_t{999});
  expect_number(app.add_option("--seed", seed, "which scenes are made")->capture_default_str(), std::uint64_t{0},
                ~std::uint64_t{0});
  app.add_option("--letters", letters, "what vertices are called")
      ->check(CLI::IsMember({"roles", "fixed"}))
      ->capture_default_str();
  app.add_option("--out", out, "folder: 000.png, 001.png, …, legend.txt, questions.txt; key.txt is not for readers")
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help);
    return ok;
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + "; 'gjkstep-quiz --help' shows the options");
  }
  render::make_folder(out, "choose another with --out");
  Studio studio;
  const Look look{.text = Text::none, .values = false};
  std::string texts, key;
  const std::vector<Question> all = questions(count, seed, letters == "fixed" ? Naming::fixed : Naming::roles);
  const std::filesystem::path folder = out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto draw = [&](const std::string& file, std::size_t frame) {
      render::write_file(folder / file, render::encode_png(picture_of(all[i], frame, studio, look), {}));
    };
    draw(number_of(i) + ".png", all[i].frame);
    if (all[i].second) draw(number_of(i) + "-second.png", *all[i].second);
    texts += number_of(i) + ": " + all[i].text + "\n";
    key += number_of(i) + ": " + all[i].answer + " (" + all[i].kind + ")\n";
  }
  render::write_file(folder / "legend.txt", legend());
  render::write_file(folder / "questions.txt", texts);
  render::write_file(folder / "key.txt", key);
  std::cout << out << ": " << all.size() << " questions, seed " << seed << '\n';
  return ok;
}

}  // namespace

int main(int argc, char** argv) {
  return exit_code_of("gjkstep-quiz", "ask for fewer questions", [&] { return run(argc, argv); });
}
