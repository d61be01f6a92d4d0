#include "walkthroughs/judge/report_page.hpp"

#include <algorithm>
#include <filesystem>

#include "render/html.hpp"

namespace walkthroughs::judge {
namespace {

using render::escaped;
using Pictures = std::map<std::string, ShownPicture>;

std::string element(const std::string& tag, const std::string& text) {
  return "<" + tag + ">" + escaped(text) + "</" + tag + ">\n";
}

std::string link_to(const std::string& url, const std::string& text) {
  return "<a href=\"" + escaped(url) + "\">" + text + "</a>";
}

std::string causes_html(const Told& told, bool is_wrong) {
  std::string items;
  for (const ToldCause& each : told.causes)
    items += "<li><strong>" + escaped(each.name) + "</strong><br>\n" + escaped(each.evidence) + "; agreement " +
             std::to_string(each.agreement) + " %\n" +
             (each.next.empty() ? "" : "<br><code>" + escaped(each.next) + "</code>\n") + "</li>\n";
  if (!items.empty()) return "<ol>\n" + items + "</ol>\n";
  return is_wrong ? element("p", no_cause) : "";
}

std::string notes_html(const Told& told) {
  std::string items;
  for (const std::string& note : told.notes) items += element("li", note);
  return items.empty() ? "" : "<ul>\n" + items + "</ul>\n";
}

// -- Pictures ---------------------------------------------------------------------------------------------------------

std::string picture_html(const std::string& name, const ShownPicture& picture) {
  return "<a class=\"light-pictures\" href=\"" + escaped(picture.step) + "\"><span class=\"shot of-" + name +
         "\"><img src=\"" + escaped(picture.url) + "\" alt=\"" + escaped(picture.alt) +
         "\" loading=lazy></span></a>\n" + element("p", picture.caption);
}

/// What of each picture is shown.
std::string cuts(const Pictures& pictures) {
  std::string css;
  for (const auto& [name, picture] : pictures) {
    css += ".of-" + name + " { --aspect: " + picture.cut["aspect"].dump();
    for (const char* const side : {"left", "top", "width"})
      css += std::string("; --") + side + ": " + picture.cut[side].dump() + "%";
    css += "; }\n";
  }
  return css;
}

std::string pair_html(const ToldPair& pair, const Pictures& pictures) {
  std::string html =
      "<li class=\"card\">\n<h3 dir=\"auto\">" + escaped(pair.name) + "</h3>\n" + element("p", pair.what);
  if (pair.file.empty()) return html + element("p", not_drawn) + "</li>\n";
  const std::string name = std::filesystem::path(pair.file).stem();
  return html + picture_html(name, pictures.at(name)) + "<p>" +
         link_to(name + "/" + page_file, page_programs().empty() ? "all steps" : "all steps, live") + " · " +
         link_to(pair.file, "scene file") + "</p>\n</li>\n";
}

std::string pairs_html(const Told& told, const Pictures& pictures) {
  std::string items;
  for (const ToldPair& each : told.pairs) items += pair_html(each, pictures);
  if (items.empty()) return "";
  const std::string hold = page_programs().empty() ? "" : ", and there you can take hold of corners";
  const std::string intro =
      "<p>Each picture is the last of a search by the algorithm of ARL-TR-7474. Its page has all steps" + hold + ". " +
      link_to(page_file, "All in one list") + ".</p>\n";
  return (pictures.empty() ? "" : intro) + "<ul class=\"cards\">\n" + items + "</ul>\n";
}

std::string step_html(const Told& told, const Pictures& pictures) {
  if (told.first_wrong_step.empty()) return "";
  const std::string html = element("p", told.first_wrong_step);
  const auto step = pictures.find(parting_name);  // not there where what it tells are no numbers
  if (step == pictures.end()) return html;
  return html + "<div class=\"card first\">\n" + picture_html(step->first, step->second) + "<p>" +
         link_to(std::string(parting_name) + "/" + page_file, "all steps") + "</p>\n</div>\n";
}

// -- The table --------------------------------------------------------------------------------------------------------

/// Columns in which nothing stands are left out. `all`: a last row, or null.
std::string table_html(const Row& columns, const std::vector<Row>& rows, const Row* all) {
  if (rows.empty()) return "";
  const auto row_html = [&](const Row& row, const std::string& scope, const std::string& tag) {
    std::string html;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto says_more = [i](const Row& each) { return !each[i].empty() && each[i] != "0"; };
      if (i == 0)
        html += "<th scope=\"" + scope + "\">" + escaped(row[i]) + "</th>";
      else if (std::ranges::any_of(rows, says_more))
        html += "<" + tag + ">" + escaped(row[i]) + "</" + tag + ">";
    }
    return "<tr>" + html + "</tr>\n";
  };
  std::string html = "<table>\n<thead>\n" + row_html(columns, "col", "th") + "</thead>\n<tbody>\n";
  for (const Row& row : rows) html += row_html(row, "row", "td");
  html += "</tbody>\n";
  if (all) html += "<tfoot>\n" + row_html(*all, "row", "td") + "</tfoot>\n";
  return html + "</table>\n";
}

/// Families with faults first; all others are folded away.
std::string families_html(const Told& told) {
  const std::string others = table_html(told.columns, told.without_faults, nullptr);
  const std::string count = std::to_string(told.without_faults.size());
  return table_html(told.columns, told.with_faults, &told.all) +
         (others.empty() ? ""
                         : "<details><summary>Without a fault: " + count + "</summary>\n" + others + "</details>\n");
}

}  // namespace

std::string report_page(const Report& report, const Pictures& pictures) {
  const Told told = judge::told(report);
  struct Section {
    std::string id, title, html;
  };
  std::vector<PageLink> ways;
  std::string sections = told.accepted.empty() ? "" : element("p", told.accepted);
  for (const auto& [id, title, html] :
       {Section{"causes", "Probable causes", causes_html(told, report.judgement.all.wrong() > 0)},
        Section{"step", "The first wrong step", step_html(told, pictures)},
        Section{"pairs", "The worst pairs", pairs_html(told, pictures)},
        Section{"families", "Families of pairs", families_html(told)},
        Section{"behaviour", "How it behaves", notes_html(told)}}) {
    if (html.empty()) continue;
    ways.push_back({"#" + id, title});
    sections += "<section id=\"" + id + "\">\n<h2>" + title + "</h2>\n" + html + "</section>\n";
  }
  const std::string html = filled(viewer_files.at("report.html"), {{"verdict", escaped(told.verdict)},
                                                                   {"ways", html_of(ways)},
                                                                   {"sections", sections},
                                                                   {"command", escaped(told.command)}});
  return with_inside(html, {{"report.css", viewer_files.at("report.css") + cuts(pictures)}});
}

}  // namespace walkthroughs::judge
