#include "walkthroughs/page/templates.hpp"

#include <algorithm>
#include <stdexcept>

#include "render/html.hpp"
#include "render/utf8.hpp"

namespace walkthroughs {

std::string filled(std::string_view page, const std::vector<Filling>& fillings) {
  std::string html;
  while (true) {
    const std::size_t begin = page.find("{{"), end = page.find("}}", begin);
    html += page.substr(0, begin);
    if (begin == std::string_view::npos || end == std::string_view::npos) return html;
    const auto filling = std::ranges::find(fillings, page.substr(begin + 2, end - begin - 2), &Filling::name);
    if (filling == fillings.end()) throw std::logic_error("a template has a place that nothing fills");
    html += filling->text;
    page.remove_prefix(end + 2);
  }
}

std::string html_of(std::string_view text) {
  std::string html;
  const auto take = [&text](std::size_t bytes) {
    const std::string_view taken = text.substr(0, bytes);
    text.remove_prefix(std::min(bytes, text.size()));
    return taken;
  };
  while (!text.empty()) {
    if (text.starts_with("\\_")) {
      take(1);
      html += take(1);
    } else if (text.starts_with("_{") && text.find('}') != std::string_view::npos) {
      take(2);
      html += "<sub>" + render::escaped(take(text.find('}'))) + "</sub>";
      take(1);
    } else if (text.starts_with('_') && text.size() > 1) {
      take(1);
      html += "<sub>" + render::escaped(take(render::first_letter(text).bytes.size())) + "</sub>";
    } else {
      html += render::escaped(take(1));
    }
  }
  return html;
}

std::string json_for_html(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) json.replace(at, 1, "\\u003c");
  return json;
}

}  // namespace walkthroughs
