#include "render/compare_report.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "render/html.hpp"

namespace render {
namespace {

// ---------------------------------------------------------------------------------------------- the page

constexpr const char* head_html = R"html(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy"
      content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="gjkstep">
<title>Comparison of pictures</title>
<style>
:root { color-scheme: light; --ink: #222; --grey: #5c5c5c; --faint: #dedede; --bad: #a33f00; --good: #00694f; }
body { margin: 0 auto; max-width: 1600px; padding: 0 24px 48px; background: #fff; color: var(--ink);
       font: 15px/1.45 "DejaVu Sans", Verdana, sans-serif; }
h1 { font-size: 26px; margin: 24px 0 4px; }
h2 { font-size: 20px; margin: 40px 0 8px; border-bottom: 2px solid var(--ink); }
h3 { font-size: 16px; margin: 0 0 2px; overflow-wrap: anywhere; }
p { margin: 4px 0 10px; max-width: 100ch; }
code, kbd { font: 13px/1.5 "DejaVu Sans Mono", monospace; }
kbd { border: 1px solid var(--grey); border-radius: 3px; padding: 0 5px; background: #fff; }
.accept code { display: block; padding: 6px 10px; background: #f4f4f4; border-left: 4px solid var(--grey);
               max-height: 12em; overflow: auto; white-space: pre; user-select: all; }
.tools { position: sticky; top: 0; z-index: 1; padding: 8px 0; background: #fff; border-bottom: 1px solid var(--faint); }
button { font: inherit; padding: 3px 12px; border: 1px solid var(--ink); border-radius: 4px; background: #fff; cursor: pointer; }
button[aria-pressed=true] { background: var(--ink); color: #fff; }
button[aria-pressed=true] kbd { color: var(--ink); }
.pair { margin: 18px 0 0; padding: 14px 16px 12px; border: 1px solid var(--faint); border-left: 6px solid var(--bad); border-radius: 4px; }
.pair.passes { border-left-color: var(--good); }
.verdict { color: var(--bad); font-weight: bold; }
.passes .verdict { color: var(--good); }
.pictures { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: 12px; margin: 8px 0 12px; }
figure { margin: 0; grid-row: 1; }
figcaption { color: var(--grey); }
figure img { display: block; max-width: 100%; height: auto; outline: 1px solid var(--faint); }
figure .none { padding: 24px 12px; border: 1px dashed var(--grey); color: var(--grey); text-align: center; }
.frame { position: relative; width: fit-content; }
.box { position: absolute; outline: 2px dashed #e69f00; outline-offset: 4px; }
.expected { grid-column: 1; } .actual { grid-column: 2; } .difference { grid-column: 3; }
.swapped .expected { grid-column: 2; } .swapped .actual { grid-column: 1; }
.full .pictures { grid-template-columns: repeat(3, max-content); overflow-x: auto; padding: 8px; }
.full figure img { max-width: none; image-rendering: pixelated; }
.facts { display: flex; flex-wrap: wrap; gap: 8px 48px; align-items: start; }
table { border-collapse: collapse; font-size: 13px; }
th, td { padding: 1px 14px 1px 0; text-align: left; font-weight: normal; vertical-align: top; }
th { color: var(--grey); }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
td.over, tr.differs td { color: var(--bad); font-weight: bold; }
.bar { display: block; height: 9px; margin-top: 5px; background: #0072b2; }
.off .bar { background: #d55e00; }
caption { text-align: left; color: var(--ink); }
</style>
</head>
<body>
)html";

/// A button of the page toggles a class of the body; its key does the same.
constexpr const char* tools_html = R"html(<div class="tools">
<button type="button" data-class="swapped" data-key="s" aria-pressed="false">Swap expected and actual, in place <kbd>S</kbd></button>
<button type="button" data-class="full" data-key="f" aria-pressed="false">One to one <kbd>F</kbd></button>
</div>
)html";

constexpr const char* script_html = R"html(<script>
'use strict';
function toggle(button) {
  button.setAttribute('aria-pressed', document.body.classList.toggle(button.dataset.class));
}
for (const button of document.querySelectorAll('button')) button.addEventListener('click', () => toggle(button));
document.addEventListener('keydown', event => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.repeat) return;
  const button = document.querySelector(`button[data-key="${CSS.escape(event.key.toLowerCase())}"]`);
  if (button) toggle(button);
});
</script>
</body>
</html>
)html";

// ---------------------------------------------------------------------------------------------- its parts

std::string none(const std::string& why) { return "<div class=\"none\">" + escaped(why) + "</div>"; }

std::string figure(const std::string& kind, const std::string& caption, const std::string& content) {
  return "<figure class=\"" + kind + "\"><figcaption>" + caption + "</figcaption>" + content + "</figure>\n";
}

std::string side(const std::optional<Image>& image, const std::string& kind, const std::string& name) {
  return figure(kind, kind, image ? img(*image, name + ", " + kind) : none("no " + kind + " picture"));
}

std::string percent(int part, int whole) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f%%", 100.0 * part / whole);
  return text;
}

/// A frame around the pixels that are off, in parts of the picture.
std::string box(const Comparison& c) {
  if (c.off == 0) return "";
  return "<span class=\"box\" style=\"left:" + percent(c.box.min_x, c.actual.width) +
         ";top:" + percent(c.box.min_y, c.actual.height) + ";width:" + percent(c.box.width(), c.actual.width) +
         ";height:" + percent(c.box.height(), c.actual.height) + "\"></span>";
}

std::string difference_figure(const ComparedFiles& pair) {
  const std::string caption = "difference ×" + std::to_string(difference_gain);
  if (!pair.expected || !pair.actual) return figure("difference", caption, none("there is one picture only"));
  if (pair.verdict == Verdict::other_size) return figure("difference", caption, none("the sizes differ"));
  const std::string alt = pair.files.name + ", difference: " + pair.words;
  return figure(
      "difference", caption,
      "<div class=\"frame\">" + img(difference(*pair.expected, *pair.actual), alt) + box(pair.comparison) + "</div>");
}

std::string pictures(const ComparedFiles& pair) {
  return "<div class=\"pictures\">\n" + side(pair.expected, "expected", pair.files.name) +
         side(pair.actual, "actual", pair.files.name) + difference_figure(pair) + "</div>\n";
}

/// A row of a table; `kind` is its class.
std::string row(const std::string& head, const std::string& cells, const std::string& kind = "") {
  return (kind.empty() ? "<tr>" : "<tr class=\"" + kind + "\">") + "<th scope=\"row\">" + head + "</th>" + cells +
         "</tr>\n";
}

std::string fact(const std::string& what, std::int64_t value, std::int64_t limit) {
  const bool over = value > limit;
  return row(what, std::string("<td class=\"") + (over ? "number over" : "number") + "\">" + std::to_string(value) +
                       "</td><td>" + (over ? "✗ " : "") + "at most " + std::to_string(limit) + " may be</td>");
}

std::string facts(const Comparison& c) {
  std::string html = "<table>\n" + fact("pixels off", c.off, c.allowed) +
                     fact("largest group of them", c.largest_group, tolerance::group);
  if (c.off > 0)
    html += row("bounding box", "<td colspan=\"2\">" + std::to_string(c.box.width()) + "×" +
                                    std::to_string(c.box.height()) + " at (" + std::to_string(c.box.min_x) + ", " +
                                    std::to_string(c.box.min_y) + ")</td>");
  return html + "</table>\n";
}

/// One row of the histogram: the pixels whose most different channel differs by `from`, …, `to`.
std::string bin(const Comparison& c, int from, int to) {
  std::int64_t count = 0;
  for (int d = from; d <= to; ++d) count += c.histogram[static_cast<std::size_t>(d)];
  const double all = static_cast<double>(c.expected.width) * c.expected.height;
  const double part = std::log1p(static_cast<double>(count)) / std::log1p(all);
  const std::string range = from == to ? std::to_string(from) : std::to_string(from) + "–" + std::to_string(to);
  return row(range,
             "<td class=\"number\">" + std::to_string(count) + "</td><td><span class=\"bar\" style=\"width:" +
                 std::to_string(static_cast<int>(std::lround(160 * part))) + "px\"></span></td>",
             from > tolerance::channel ? "off" : "");
}

/// Bins grow by powers of two, and one ends where pixels begin to be off.
std::string histogram(const Comparison& c) {
  static_assert(std::has_single_bit(unsigned{tolerance::channel}));
  std::string html =
      "<table class=\"histogram\"><caption>Histogram: difference of the most different channel, pixels; bars "
      "logarithmic; orange: off</caption>\n";
  html += bin(c, 0, 0);
  for (int from = 1, to = 0; from <= 255; from = to + 1) {
    to = std::min(255, from == 1 ? 1 : 2 * (from - 1));
    html += bin(c, from, to);
  }
  return html + "</table>\n";
}

std::string details(const ComparedFiles& pair) {
  const bool counted = pair.verdict == Verdict::different || pair.verdict == Verdict::within_tolerance;
  return counted ? "<div class=\"facts\">\n" + facts(pair.comparison) + histogram(pair.comparison) + "</div>\n" : "";
}

std::string accept_block(const std::string& what, const std::string& command) {
  return "<div class=\"accept\">" + what + ":<code>" + escaped(command) + "</code></div>\n";
}

std::string accept_line(Verdict verdict, const std::string& command) {
  if (command.empty()) return "";
  return accept_block(verdict == Verdict::missing ? "Accept that it is gone" : "Accept the new picture", command);
}

std::string cell(const std::optional<std::string>& value) {
  return "<td>" + (value ? escaped(*value) : "not recorded") + "</td>";
}

/// What rendered each side.
std::string origin(const ReportHead& head) {
  std::string html =
      "<table class=\"origin\"><tr><th></th><th scope=\"col\">expected</th><th scope=\"col\">actual</th>"
      "<th></th></tr>\n";
  html += row("pictures", cell(head.expected) + cell(head.actual) + "<td></td>");
  if (!head.expected_by && !head.actual_by) html += row("rendered by", cell({}) + cell({}) + "<td></td>");
  const bool both = head.expected_by && head.actual_by;
  for (const RenderedByLine& line :
       side_by_side(head.expected_by.value_or(RenderedBy{}), head.actual_by.value_or(RenderedBy{}))) {
    const bool marked = both && line.differs();
    const std::string last = marked ? "<td>≠ differs</td>" : "<td></td>";
    html += row(escaped(line.key), cell(line.expected) + cell(line.actual) + last, marked ? "differs" : "");
  }
  return html + "</table>\n";
}

/// The rule, in the words of the page.
std::string rule() {
  return "<p>A pixel is off when a channel differs by more than " + std::to_string(tolerance::channel) +
         ". Two pictures pass when at most one of " + std::to_string(tolerance::one_in) +
         " pixels is off, of a small picture none, and no group of them, joined by edges or corners, is larger than " +
         std::to_string(tolerance::group) + ".</p>\n";
}

std::string pictures_in_words(int count) { return std::to_string(count) + (count == 1 ? " picture" : " pictures"); }

}  // namespace

bool CompareReport::take_pictures(const ComparedFiles& compared) {
  int& shown = passes(compared.verdict) ? passes_shown_ : failures_shown_;
  const int limit = passes(compared.verdict) ? limits_.passes : limits_.failures;
  const bool room = shown < limit && failures_.size() + passes_.size() < limits_.bytes;
  ++(room ? shown : without_pictures_);
  return room;
}

void CompareReport::add(const ComparedFiles& compared, const std::string& accept) {
  const bool good = passes(compared.verdict);
  ++(good ? passed_ : failed_);
  if (!good && !accept.empty()) accept_all_ += (commands_++ == 0 ? "" : " &&\n") + accept;
  if (compared.verdict == Verdict::same) {
    same_ += "<li>" + escaped(compared.files.name) + "</li>\n";
    return;
  }
  const bool shown = compared.verdict != Verdict::unreadable && take_pictures(compared);
  (good ? passes_ : failures_) +=
      std::string("<section class=\"pair") + (good ? " passes" : " fails") + "\">\n<h3>" +
      escaped(compared.files.name) + "</h3>\n<p><span class=\"verdict\">" + (good ? "✓ " : "✗ ") +
      name(compared.verdict) + "</span>: " + escaped(compared.words) + "</p>\n" + (shown ? pictures(compared) : "") +
      details(compared) + (good ? "" : accept_line(compared.verdict, accept)) + "</section>\n";
}

std::string CompareReport::html() const {
  const int all = failed_ + passed_;
  std::string page = head_html;
  page += "<h1>" +
          (failed_ == 0
               ? pictures_in_words(all) + ": no difference that counts"
               : std::to_string(failed_) + " of " + pictures_in_words(all) + (failed_ == 1 ? " differs" : " differ")) +
          "</h1>\n" + rule() + origin(head_);
  if (without_pictures_ > 0)
    page += "<p><strong>" + pictures_in_words(without_pictures_) + " of those below " +
            (without_pictures_ == 1 ? "is" : "are") + " told in words only, to keep this page small.</strong></p>\n";
  page += tools_html;
  if (!failures_.empty()) {
    page += "<h2>Different</h2>\n";
    if (!head_.where.empty()) page += "<p>Commands are to be run in <code>" + escaped(head_.where) + "</code>.</p>\n";
    if (commands_ > 1)
      page += accept_block("Accept all: the " + std::to_string(commands_) + " commands below in one", accept_all_);
    page += failures_;
  }
  if (!passes_.empty()) page += "<h2>Within the tolerance</h2>\n" + passes_;
  if (!same_.empty()) page += "<h2>The same</h2>\n<ul>\n" + same_ + "</ul>\n";
  return page + script_html;
}

}  // namespace render
