#include "walkthroughs/page/index_page.hpp"

#include "render/html.hpp"
#include "walkthroughs/page/index_groups.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/page/templates.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs {
namespace {

using render::escaped;

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

std::string section(const IndexGroup& group) {
  std::string cards;
  for (const IndexEntry& entry : group.entries) cards += card(entry);
  return "<section class=\"group\">\n<h2>" + escaped(group.title) + "</h2>\n<ul class=\"cards\">\n" + cards +
         "</ul>\n</section>\n";
}

}  // namespace

std::string index_html(const std::vector<IndexEntry>& entries, const std::string& compare_url) {
  std::string sections, parts;
  for (const IndexGroup& group : in_groups(entries)) {
    sections += section(group);
    parts += "<option>" + escaped(group.title) + "</option>";
  }
  return filled(templates::index_html,
                {{"count", std::to_string(entries.size())},
                 {"compare", compare_url.empty() ? ""
                                                 : "<p><a href=\"" + escaped(compare_url) +
                                                       "\">Two searches beside each other</a></p>\n"},
                 {"parts", parts},
                 {"sections", sections},
                 {"css", std::string(templates::colors_css) + std::string(templates::index_css)},
                 {"js", std::string(templates::index_js)}});
}

}  // namespace walkthroughs
