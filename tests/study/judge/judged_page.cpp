#include "tests/study/judge/judged_page.hpp"

#include "render/html.hpp"
#include "tests/study/judge/drawn_frame.hpp"
#include "tests/study/judge/judged_scenes.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_file.hpp"

namespace study {
namespace {

using render::escaped;

constexpr const char* style = R"html(<style>
:root { color-scheme: light; --ink: #222; --grey: #5c5c5c; --faint: #dedede; --bad: #a33f00; --good: #00694f; }
body { margin: 0 auto; max-width: 1300px; padding: 0 24px 48px; background: #fff; color: var(--ink);
       font: 15px/1.45 "DejaVu Sans", Verdana, sans-serif; }
h1 { font-size: 24px; margin: 24px 0 8px; overflow-wrap: anywhere; }
h2 { font-size: 20px; margin: 32px 0 8px; border-bottom: 2px solid var(--ink); }
.bad { color: var(--bad); } .good { color: var(--good); }
code { font: 13px/1.5 "DejaVu Sans Mono", monospace; }
table { border-collapse: collapse; font-size: 13px; }
th, td { padding: 2px 14px 2px 0; text-align: right; font-weight: normal; border-bottom: 1px solid var(--faint); }
th { color: var(--grey); vertical-align: bottom; }
th:first-child, td:first-child { text-align: left; }
table.words th, table.words td { text-align: left; vertical-align: top; }
table.words td { overflow-wrap: anywhere; }
figure { margin: 20px 0; }
figure img { max-width: 100%; height: auto; outline: 1px solid var(--faint); }
</style>
)html";

std::string row_of(const std::vector<std::string>& cells, const std::string& tag) {
  std::string html = "<tr>";
  for (const std::string& cell : cells) html += "<" + tag + ">" + escaped(cell) + "</" + tag + ">";
  return html + "</tr>\n";
}

std::string html_of(const Table& table) {
  std::string html = "<h2>" + escaped(table.heading) + "</h2>\n<table" +
                     (table.words == table.titles.size() ? " class=\"words\"" : "") + ">\n" +
                     row_of(table.titles, "th");
  for (const auto& cells : table.rows) html += row_of(cells, "td");
  html += "</table>\n";
  for (const std::string& sentence : table.sentences) html += "<p>" + escaped(sentence) + "</p>\n";
  return html;
}

std::string figure(const render::Image& image, const std::string& instead, const std::string& caption) {
  return "<figure>" + render::img(image, instead) + "<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

std::string pictures_of_steps(const ProgramJudged& judged) {
  std::string html;
  if (judged.steps)
    for (const JudgedSteps& each : *judged.steps)
      if (each.drawn)
        html += figure(*each.drawn, "Both searches side by side on " + walkthroughs::text::printable(each.pair),
                       walkthroughs::text::printable(each.pair) + ", iteration " + std::to_string(each.iteration) +
                           ": " + each.words + ".");
  return html;
}

std::string pictures_of(const ProgramJudged& judged, const std::string& program, std::size_t most) {
  const std::vector<JudgedScene> scenes = judged_scenes(judged, program, 1);
  if (scenes.empty() || most == 0) return "";
  std::string html =
      "<h2>The first failures</h2>\n<p>Each of another family or kind, as the report's algorithm ends on it; "
      "--save-failures "
      "saves all as scenes, which <code>gjkstep render</code> draws step by step.</p>\n";
  FrameDrawing drawing;
  for (std::size_t i = 0; i < std::min(most, scenes.size()); ++i) {
    const walkthroughs::text::SceneFile file = walkthroughs::text::parse_scene(scenes[i].text, scenes[i].name);
    const render::Image image = drawing(walkthroughs::story::tell(file.walkthrough, walkthroughs::story::Detail::iteration));
    html += figure(image, scenes[i].title, scenes[i].title + ". " + scenes[i].truth);
  }
  return html;
}

}  // namespace

std::string judged_page(const ProgramJudged& judged, const JudgedHead& head, std::size_t pictures) {
  const std::string program = walkthroughs::text::message_line(head.program);
  std::string html =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "http-equiv=\"Content-Security-Policy\" "
      "content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>" +
      escaped(program) + "</title>\n" + style + "</head>\n<body>\n<h1>" + escaped(program) + ": <span class=\"" +
      (judged.is_good() ? "good" : "bad") + "\">" + escaped(verdict_line(judged)) + "</span></h1>\n<ul>\n";
  for (const std::string& sentence : remarks(judged)) html += "<li>" + escaped(sentence) + "</li>\n";
  html += "<li>made by: <code>" + escaped(walkthroughs::text::message_line(head.command)) + "</code></li>\n</ul>\n";
  for (const Table& table : tables_of(judged, head.is_sample)) html += html_of(table);
  html += pictures_of_steps(judged) + pictures_of(judged, program, pictures);
  return html + "</body>\n</html>\n";
}

}  // namespace study
