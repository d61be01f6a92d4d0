#include "render/compare_report.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"
#include "tests/kit/text.hpp"

namespace compare_report_test {

using namespace render;
using kit::has;

namespace {

Image plain(Color color) { return kit::plain({12, 8}, color); }

ComparedFiles compared(const std::string& name, const Image& expected, const Image& actual) {
  ComparedFiles pair{.files = {name, "e/" + name, "a/" + name}, .words = {}, .expected = expected, .actual = actual};
  pair.comparison = compare(expected, actual);
  pair.verdict = pair.comparison.verdict;
  pair.words = in_words(pair.comparison);
  return pair;
}

ComparedFiles different(const std::string& name) { return compared(name, plain({9, 9, 9}), plain({90, 90, 90})); }
ComparedFiles within(const std::string& name) { return compared(name, plain({9, 9, 9}), plain({8, 9, 9})); }
ComparedFiles same(const std::string& name) { return compared(name, plain({9, 9, 9}), plain({9, 9, 9})); }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

const ReportHead head{.expected = "e", .actual = "a"};

}  // namespace

TEST_CASE("Failures come first on the page and the same last whatever came first") {
  CompareReport report(head);
  report.add(same("1-same.png"), "");
  report.add(within("2-within.png"), "");
  report.add(different("3-different.png"), "cp 3");
  const std::string html = report.html();
  CHECK(html.find("3-different.png") < html.find("2-within.png"));
  CHECK(html.find("2-within.png") < html.find("1-same.png"));
  CHECK(has(html, "<h1>1 of 3 pictures differs</h1>"));
  CHECK(has(html, "<code>cp 3</code>"));
  CHECK(count(html, "<img ") == 6);
}

TEST_CASE("Names and words and commands cannot become part of the page") {
  CompareReport report({.expected = "<e>", .actual = "\"a\"", .expected_by = RenderedBy{{"<k>", "<v>"}}});
  report.add(different("<script>alert(1)</script> & \".png"), "cp '<b>'");
  const std::string html = report.html();
  for (const char* part : {"<script>alert", "<e>", "<k>", "<v>", "<b>"}) CHECK_FALSE(has(html, part));
  CHECK(has(html, "&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;.png"));
}

TEST_CASE("The page says in which folder its commands work, where it is known") {
  CompareReport report({.expected = "e", .actual = "a", .where = "/here & there"});
  report.add(different("a.png"), "cp");
  CHECK(has(report.html(), "Commands are to be run in <code>/here &amp; there</code>"));
  CompareReport nowhere(head);
  nowhere.add(different("a.png"), "cp");
  CHECK_FALSE(has(nowhere.html(), "Commands are to be run"));
}

TEST_CASE("What rendered each side is shown and marked where it differs and told where nobody recorded it") {
  CHECK(count(CompareReport(head).html(), "not recorded") == 2);
  const CompareReport report({.expected = "e",
                              .actual = "a",
                              .expected_by = RenderedBy{{"png", "1.6"}, {"cpu", "AVX2"}},
                              .actual_by = RenderedBy{{"png", "1.6"}, {"cpu", "none"}}});
  const std::string html = report.html();
  CHECK(count(html, "≠ differs") == 1);
  CHECK(html.find("<tr class=\"differs\"><th scope=\"row\">cpu") != std::string::npos);
  const CompareReport half({.expected = "e", .actual = "a", .expected_by = RenderedBy{{"png", "1.6"}}});
  CHECK(has(half.html(), "<td>1.6</td><td>not recorded</td>"));
  CHECK_FALSE(has(half.html(), "≠ differs"));
}

TEST_CASE("The page tells pixels off and largest group and bounding box and histogram") {
  Image actual = plain({9, 9, 9});
  for (int x : {2, 3, 4, 5, 6}) actual.row(3)[3 * x] = 14;
  CompareReport report(head);
  report.add(compared("a.png", plain({9, 9, 9}), actual), "cp");
  report.add(within("b.png"), "");
  const std::string html = report.html();
  CHECK(has(html, ">pixels off</th><td class=\"number over\">5</td><td>✗ at most 0 may be</td>"));
  CHECK(has(html, ">pixels off</th><td class=\"number\">0</td><td>at most 0 may be</td>"));
  CHECK(has(html, ">largest group of them</th><td class=\"number over\">5</td><td>✗ at most 4 may be</td>"));
  CHECK(has(html, "5×1 at (2, 3)"));
  // Bars are as long as logarithms, so that few pixels are seen beside many: 160 log 6 / log 97.
  const std::string bar = "<td><span class=\"bar\" style=\"width:";
  CHECK(has(html, "<th scope=\"row\">5–8</th><td class=\"number\">5</td>" + bar + "63px"));
  CHECK(has(html, "<th scope=\"row\">0</th><td class=\"number\">91</td>" + bar + "158px"));
}

TEST_CASE("The histogram of the page begins a bin where pixels begin to be off, and marks those bins alone") {
  CompareReport report(head);
  report.add(different("a.png"), "cp");
  const std::string html = report.html();
  std::string bins;
  for (std::size_t at = 0; (at = html.find("<tr", at)) != std::string::npos; ++at) {
    const std::string row = html.substr(at, html.find("</th>", at) - at);
    const bool is_off = row.starts_with("<tr class=\"off\">");
    if (const std::size_t name = row.find("<th scope=\"row\">");
        name != std::string::npos && std::isdigit(row[name + 16]))
      bins += (bins.empty() ? "" : " ") + std::string(is_off ? "!" : "") + row.substr(name + 16);
  }
  CHECK(bins == "0 1 2 !3–4 !5–8 !9–16 !17–32 !33–64 !65–128 !129–255");
}

TEST_CASE("Many pairs are shown with pictures up to a limit and the others in words and the page says so") {
  CompareReport report(head, {.failures = 2, .passes = 1});
  for (const char* name : {"1", "2", "3", "4"}) report.add(different(name), "cp");
  for (const char* name : {"5", "6"}) report.add(within(name), "");
  const std::string html = report.html();
  CHECK(count(html, "<img ") == 9);
  CHECK(count(html, "<section") == 6);
  CHECK(has(html, "3 pictures of those below are told in words only"));
}

TEST_CASE("No pictures are added to a page that is long already") {
  CompareReport report(head, {.bytes = 1});
  report.add(different("1.png"), "cp");
  report.add(different("2.png"), "cp");
  CHECK(count(report.html(), "<img ") == 3);
}

TEST_CASE("A missing or extra picture is shown beside an empty place and an unreadable one in words") {
  CompareReport report(head);
  report.add({.files = {"m.png", "e/m.png", "a/m.png", Sides::only_expected},
              .verdict = Verdict::missing,
              .words = "only the expected side has it",
              .expected = plain({9, 9, 9}),
              .actual = {}},
             "rm e/m.png");
  report.add({.files = {"u.png", "e/u.png", "a/u.png"},
              .verdict = Verdict::unreadable,
              .words = "cannot read a/u.png",
              .expected = {},
              .actual = {}},
             "");
  const std::string html = report.html();
  CHECK(count(html, "<img ") == 1);
  CHECK(has(html, "no actual picture"));
  CHECK(has(html, "Accept that it is gone:<code>rm e/m.png</code>"));
  CHECK(has(html, "cannot read a/u.png"));
  CHECK(count(html, "class=\"accept\"") == 1);
}

}  // namespace compare_report_test
