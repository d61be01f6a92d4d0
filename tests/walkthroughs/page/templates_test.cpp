#include "walkthroughs/page/templates.hpp"

#include "tests/kit/catch.hpp"

using namespace walkthroughs;

TEST_CASE("A template takes what fills its places as it is, also where that looks like a place") {
  CHECK(filled("<h1>{{a}}</h1>{{b}}{{a}}", {{"a", "{{b}}"}, {"b", "}} {{c}}"}}) == "<h1>{{b}}</h1>}} {{c}}{{b}}");
  CHECK(filled("no place, { one } brace", {}) == "no place, { one } brace");
  CHECK_THROWS_AS(filled("{{a}}", {}), std::logic_error);
}

TEST_CASE("Subscripts of captions are subscripts in HTML, and nothing in them is read as HTML") {
  CHECK(html_of("AB_n·AO > 0") == "AB<sub>n</sub>·AO &gt; 0");
  CHECK(html_of("x_{<12>} y") == "x<sub>&lt;12&gt;</sub> y");
  CHECK(html_of("x_ä, x_∞") == "x<sub>ä</sub>, x<sub>∞</sub>");
  CHECK(html_of("a\\_b \\<") == "a_b \\&lt;");
  CHECK(html_of("ends in _") == "ends in _");
  CHECK(html_of("_{not closed") == "<sub>{</sub>not closed");
  CHECK(html_of("_<img>") == "<sub>&lt;</sub>img&gt;");
}

TEST_CASE("JSON in a page cannot end its script element nor begin a comment there") {
  const std::string json = json_for_html(R"({"t":"</script><!--<script>"})");
  CHECK(json.find('<') == std::string::npos);
  CHECK(json == R"({"t":"\u003c/script>\u003c!--\u003cscript>"})");
}

TEST_CASE("Templates ask for nothing outside of the page") {
  using namespace templates;
  for (const std::string_view each : {page_html, page_css, page_js, predict_js, index_html, index_css, index_js,
                                      compare_html, compare_css, compare_js, colors_css}) {
    REQUIRE_FALSE(each.empty());
    for (const char* outside : {"http:", "https:", "//cdn", "@import", "url(", "fetch(", "XMLHttpRequest"})
      CHECK(each.find(outside) == std::string_view::npos);
  }
}
