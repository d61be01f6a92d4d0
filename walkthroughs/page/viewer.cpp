#include <algorithm>
#include <stdexcept>

#include "render/html.hpp"
#include "walkthroughs/page/page.hpp"

namespace walkthroughs::page {

std::string filled(std::string_view text, const std::vector<PageFile>& fillings) {
  std::string html;
  while (true) {
    const std::size_t begin = text.find("{{"), end = text.find("}}", begin);
    html += text.substr(0, begin);
    if (begin == std::string_view::npos || end == std::string_view::npos) return html;
    const auto filling = std::ranges::find(fillings, text.substr(begin + 2, end - begin - 2), &PageFile::name);
    if (filling == fillings.end()) throw std::logic_error("a page has a place that nothing fills");
    html += filling->content;
    text.remove_prefix(end + 2);
  }
}

std::string with_inside(std::string html, std::map<std::string, std::string> files) {
  files.insert(viewer_files.begin(), viewer_files.end());
  for (const auto& [name, content] : files) {
    const bool is_style = name.ends_with(".css");
    const std::string tag = is_style ? "style" : "script";
    const std::string asks =
        is_style ? "<link rel=\"stylesheet\" href=\"" + name + "\">" : "<script src=\"" + name + "\"></script>";
    if (const std::size_t at = html.find(asks); at != std::string::npos)
      html.replace(at, asks.size(), "<" + tag + ">\n" + content + "</" + tag + ">");
  }
  return html;
}

std::string html_of(const std::vector<PageLink>& links) {
  std::string html;
  for (const auto& [url, text] : links) {
    const std::string words = render::escaped(text);
    html +=
        (url.empty() ? "<code>" + words + "</code>" : "<a href=\"" + render::escaped(url) + "\">" + words + "</a>") +
        "\n";
  }
  return html;
}

}  // namespace walkthroughs::page
