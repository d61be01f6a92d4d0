#include "walkthroughs/page/index_page.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "walkthroughs/page/viewer.hpp"

namespace walkthroughs {
namespace {

struct Known {
  std::string_view prefix, title;
};

/// As the report goes; a walkthrough belongs to the first whose prefix its name has, and what has none is the user's own.
constexpr std::array<Known, 14> groups{{{"figure-", "Figures of the report"},
                                        {"regions/0-simplex", "Regions of a 0-simplex, a vertex"},
                                        {"regions/1-simplex", "Regions of a 1-simplex, a segment"},
                                        {"regions/2-simplex", "Regions of a 2-simplex, a triangle"},
                                        {"regions/3-simplex", "Regions of a 3-simplex, a tetrahedron"},
                                        {"vehicle-and-threat/", "In space: vehicles and threats"},
                                        {"cycle-", "Where it goes wrong"},
                                        {"as-printed-", "Where it goes wrong"},
                                        {"failures/", "Where it goes wrong"},
                                        {"complete/", "The remedy: rules that end"},
                                        {"certified/", "Answers that are proven"},
                                        {"eager-", "A shortcut of ours"},
                                        {"mistakes/", "Mistakes"},
                                        {"", "Scenes of your own"}}};

const Known& group_of(const std::string& name) {
  return *std::ranges::find_if(groups, [&](const Known& group) { return name.starts_with(group.prefix); });
}

/// What stands in the index as long as no script has made its cards.
std::string cards_without_scripts(const std::vector<PageJson>& entries) {
  std::vector<PageLink> pages;
  for (const PageJson& entry : entries) pages.push_back({entry["name"].get<std::string>() + "/index.html", entry["title"]});
  return html_of(pages);
}

}  // namespace

PageJson in_groups(const std::vector<PageJson>& entries) {
  PageJson found = PageJson::array();
  for (const Known& group : groups)
    for (const PageJson& entry : entries) {
      if (&group_of(entry["name"]) != &group) continue;
      if (found.empty() || found.back()["title"] != group.title)
        found.push_back({{"title", group.title}, {"entries", PageJson::array()}});
      found.back()["entries"].push_back(entry);
    }
  return found;
}

std::string page_over(const std::vector<PageJson>& entries, const std::string& viewer_page) {
  const std::string name = viewer_page.substr(0, viewer_page.find('.'));
  std::vector<PageFile> files{
      {"entries.js", "'use strict';\nwindow.gjkstepGroups = " + json_in_script(in_groups(entries)) + ";\n"}};
  for (const std::string& file : {std::string("colors.css"), std::string("page.css"), name + ".css",
                                  std::string("pages.js"), name + ".js"})
    files.push_back({file, viewer_file(file)});
  return with_inside(filled(viewer_file(viewer_page), {{"cards", cards_without_scripts(entries)}}), files);
}

}  // namespace walkthroughs
