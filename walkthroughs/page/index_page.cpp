#include "walkthroughs/page/index_page.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "render/html.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/page/templates.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs {
namespace {

using render::escaped;

struct Group {
  std::string_view prefix, title;
};

/// As the report goes; a walkthrough belongs to the first whose prefix its name has, and what has none is the user's own.
constexpr std::array<Group, 14> groups{{{"figure-", "Figures of the report"},
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

std::string_view group_of(const IndexEntry& entry) {
  return std::ranges::find_if(groups, [&](const Group& group) { return entry.name.starts_with(group.prefix); })->title;
}

std::string card(const IndexEntry& entry) {
  const std::string steps = std::to_string(entry.steps) + (entry.steps == 1 ? " step" : " steps");
  const std::string pictures = entry.is_dark ? "dark-pictures" : "light-pictures";
  std::string html = "<li class=\"card " + pictures + "\" data-answer=\"" + escaped(entry.answer) + "\">\n<a href=\"" +
                     escaped(entry.name) + "/index.html\">\n<span class=\"shot\" style=\"" + escaped(entry.cut) +
                     "\"><img src=\"" + escaped(entry.picture_url) +
                     "\" alt=\"\" loading=\"lazy\"></span>\n<strong dir=\"auto\">" + escaped(entry.title) +
                     "</strong></a>\n";
  html += "<p>" + html_of(entry.sentence) + "</p>\n<p class=\"small\">" + escaped(entry.section);
  html += (entry.section.empty() ? "" : " · ") + steps;
  if (!entry.answer.empty()) html += " · <b>" + escaped(entry.answer) + "</b>";
  return html + "<br>\n<code>" + escaped(entry.name) + "</code></p>\n</li>\n";
}

std::string section(std::string_view title, const std::vector<IndexEntry>& entries) {
  std::string cards;
  for (const IndexEntry& entry : entries)
    if (group_of(entry) == title) cards += card(entry);
  if (cards.empty()) return "";
  return "<section class=\"group\">\n<h2>" + escaped(title) + "</h2>\n<ul class=\"cards\">\n" + cards +
         "</ul>\n</section>\n";
}

}  // namespace

std::string index_html(const std::vector<IndexEntry>& entries, const std::string& compare_url) {
  std::string sections;
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (i == 0 || groups[i].title != groups[i - 1].title) sections += section(groups[i].title, entries);
  return filled(templates::index_html,
                {{"count", std::to_string(entries.size())},
                 {"compare", compare_url.empty() ? ""
                                                 : "<p><a href=\"" + escaped(compare_url) +
                                                       "\">Two searches beside each other</a></p>\n"},
                 {"sections", sections},
                 {"css", std::string(templates::colors_css) + std::string(templates::index_css)},
                 {"js", std::string(templates::index_js)}});
}

}  // namespace walkthroughs
