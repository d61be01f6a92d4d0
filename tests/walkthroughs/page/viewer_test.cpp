#include <stdexcept>

#include "tests/kit/catch.hpp"
#include "walkthroughs/page/page.hpp"

namespace viewer_test {

using namespace walkthroughs::program;

TEST_CASE("A page takes what fills its places as it is, also where that looks like a place") {
  CHECK(filled("<h1>{{a}}</h1>{{b}}{{a}}", {{"a", "{{b}}"}, {"b", "}} {{c}}"}}) == "<h1>{{b}}</h1>}} {{c}}{{b}}");
  CHECK(filled("no place, { one } brace", {}) == "no place, { one } brace");
  CHECK_THROWS_AS(filled("{{a}}", {}), std::logic_error);
}

TEST_CASE("A page holds the files that it asks for where it did, also those of the viewer, and no others") {
  const std::map<std::string, std::string> files{{"x.js", "1;\n"}, {"y.js", "2;\n"}};
  const std::string html = with_inside(
      "script-src;style-src<script src=\"x.js\"></script>b<link rel=\"stylesheet\" href=\"colors.css\">c", files);
  const std::size_t begin = html.find("'nonce-") + 7;
  const std::string number = html.substr(begin, html.find('\'', begin) - begin);
  CHECK(html == "script-src 'nonce-" + number + "';style-src 'nonce-" + number + "'<script nonce=\"" + number +
                    "\">\n1;\n</script>b<style nonce=\"" + number + "\">\n" + viewer_files.at("colors.css") +
                    "</style>c");
}

TEST_CASE("What a page lets in is told by a number that follows from all that it holds") {
  const std::string page = "script-src<script src=\"x.js\"></script>";
  CHECK(with_inside(page, {{"x.js", "1;\n"}}) == with_inside(page, {{"x.js", "1;\n"}}));
  const auto number = [&](const std::string& text) { return with_inside(page, {{"x.js", text}}).substr(18, 18); };
  CHECK(number("1;\n") != number("2;\n"));
}

TEST_CASE("Links are text and URL, whatever they hold, and where there is no URL the text alone") {
  CHECK(html_of({{"a\"b", "<c>"}, {"", "d & e"}}) == "<a href=\"a&quot;b\">&lt;c&gt;</a>\n<code>d &amp; e</code>\n");
}

TEST_CASE("The viewer asks for nothing outside of the page") {
  REQUIRE(viewer_files.size() > 10);
  for (const auto& [name, content] : viewer_files) {
    INFO(name);
    REQUIRE_FALSE(content.empty());
    for (const char* outside :
         {"http:", "https:", "//cdn", "@import", "url(", "fetch(", "XMLHttpRequest", "innerHTML", "insertAdjacent"})
      CHECK(content.find(outside) == std::string::npos);
  }
}

}  // namespace viewer_test
