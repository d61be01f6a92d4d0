#include "walkthroughs/page/compare_page.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "render/html.hpp"
#include "render/json_text.hpp"
#include "walkthroughs/page/index_groups.hpp"
#include "walkthroughs/page/templates.hpp"

namespace walkthroughs {

std::vector<IndexEntry> comparable(const std::vector<IndexEntry>& entries) {
  std::vector<IndexEntry> searches;
  std::ranges::copy_if(entries, std::back_inserter(searches),
                       [](const IndexEntry& entry) { return !entry.iteration_ends.empty(); });
  return searches;
}

std::string compare_html(const std::vector<IndexEntry>& entries) {
  nlohmann::ordered_json data = nlohmann::ordered_json::array();
  std::string options;
  for (const IndexGroup& group : in_groups(entries)) {
    options += "<optgroup label=\"" + render::escaped(group.title) + "\">\n";
    for (const IndexEntry& entry : group.entries) {
      data.push_back({{"name", entry.name}, {"last", entry.iteration_ends}});
      options += "<option>" + render::escaped(entry.title) + "</option>\n";
    }
    options += "</optgroup>\n";
  }
  return filled(templates::compare_html,
                {{"options", options},
                 {"data", json_for_html(render::json_text(data))},
                 {"css", std::string(templates::colors_css) + std::string(templates::page_css) +
                             std::string(templates::compare_css)},
                 {"js", std::string(templates::compare_js)}});
}

}  // namespace walkthroughs
