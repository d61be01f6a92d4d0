#include "walkthroughs/catalogue/catalogue.hpp"

#include <algorithm>
#include <iterator>

#include "walkthroughs/text/names.hpp"

namespace walkthroughs::catalogue {
namespace {

std::vector<Walkthrough> all_walkthroughs() {
  std::vector<Walkthrough> all;
  for (const auto family :
       {lesson, two_triangles, figure_1, figure_2, figure_3, figures_4_and_5, figures_6_and_7, figure_8, region_cases,
        vehicle_and_threat, other_rules, failures, certified_answers, mistakes})
    std::ranges::move(family(), std::back_inserter(all));
  return all;
}

constexpr const char* report = "ARL-TR-7474, ";

}  // namespace

const std::vector<Walkthrough>& whole_catalogue() {
  static const std::vector<Walkthrough> all = all_walkthroughs();
  return all;
}

std::vector<const Walkthrough*> find_walkthroughs(std::string_view name) {
  std::vector<const Walkthrough*> found;
  const std::string folder = std::string(name) + (name.ends_with('/') ? "" : "/");
  for (const Walkthrough& each : whole_catalogue())
    if (each.name == name || each.name.starts_with(folder)) found.push_back(&each);
  return found;
}

const Walkthrough* find_walkthrough(std::string_view name) {
  const auto& all = whole_catalogue();
  const auto found = std::ranges::find(all, name, &Walkthrough::name);
  return found == all.end() ? nullptr : &*found;
}

std::vector<const Walkthrough*> walkthroughs_that_say(std::string_view word) {
  std::vector<const Walkthrough*> found;
  const std::string wanted = text::in_small_letters(word);
  for (const Walkthrough& w : whole_catalogue()) {
    const std::string said =
        w.name + "\n" + w.title + "\n" + w.summary + "\n" + (w.region_case ? w.region_case->text : "");
    if (text::in_small_letters(said).find(wanted) != std::string::npos) found.push_back(&w);
  }
  return found;
}

std::string nearest_name(std::string_view name) {
  std::vector<std::string> spellings;  // all names, then all without their folders
  for (const Walkthrough& w : whole_catalogue()) spellings.push_back(w.name);
  for (const Walkthrough& w : whole_catalogue()) spellings.push_back(w.name.substr(w.name.rfind('/') + 1));
  // A word such as R7 is no name that somebody spelled wrongly.
  const bool begins_one =
      std::ranges::any_of(spellings, [&](const std::string& each) { return each.starts_with(name); });
  const std::vector<const Walkthrough*> saying = walkthroughs_that_say(name);
  if (!begins_one && !saying.empty()) return saying.front()->name;
  const std::string near = nearest(name, spellings);
  if (near.empty()) return near;
  const auto found = std::ranges::find(spellings, near) - spellings.begin();
  return spellings[static_cast<std::size_t>(found) % whole_catalogue().size()];
}

Walkthrough diagrams_of(const std::string& name, const std::string& title, const std::string& place,
                        const std::string& summary, std::vector<Diagram> (*draw)()) {
  return {.name = name,
          .title = title,
          .source = report + place,
          .summary = summary,
          .layout = Layout::diagrams,
          .diagrams = draw};
}

Walkthrough search_of(const std::string& name, const std::string& title, const std::string& place,
                      const std::string& summary, Scene scene, std::vector<Remark> remarks) {
  return {.name = name,
          .title = title,
          .source = report + place,
          .summary = summary,
          .naming = Naming::roles,
          .scenes = {std::move(scene)},
          .remarks = std::move(remarks)};
}

Scene scene_of(const std::string& a, const std::vector<Corner>& corners_of_a, const std::string& b,
               const std::vector<Corner>& corners_of_b, const std::string& name) {
  Scene scene{.name = name, .a = {a, Points()}, .b = {b, Points()}};
  const auto add = [&](Object& object, const std::vector<Corner>& corners) {
    std::vector<Point> vertices;
    for (const auto& [x, y, z] : corners) {
      vertices.emplace_back(x, y, z);
      if (z != 0) scene.dimension = Dimension::space;
    }
    object.form = points(std::move(vertices));
  };
  add(scene.a, corners_of_a);
  add(scene.b, corners_of_b);
  return scene;
}

}  // namespace walkthroughs::catalogue
