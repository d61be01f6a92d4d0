#include "render/html.hpp"

#include <vector>

#include "tests/kit/catch.hpp"

namespace html_test {

using namespace render;

TEST_CASE("Escaped text holds nothing that ends an element or an attribute, and else stays as it is") {
  CHECK(escaped("</script><img onerror=\"x\" src=y>&amp;") ==
        "&lt;/script&gt;&lt;img onerror=&quot;x&quot; src=y&gt;&amp;amp;");
  CHECK(escaped("a − b, ä ∞ _{}") == "a − b, ä ∞ _{}");
}

TEST_CASE("A data URL holds the bytes in base64, filled up to four digits") {
  const auto url = [](std::vector<std::uint8_t> bytes) {
    return data_url(bytes).substr(std::string("data:image/png;base64,").size());
  };
  CHECK(data_url({}) == "data:image/png;base64,");
  CHECK(url({'M'}) == "TQ==");
  CHECK(url({'M', 'a'}) == "TWE=");
  CHECK(url({'M', 'a', 'n'}) == "TWFu");
  CHECK(url({0xFB, 0xFF, 0xFE}) == "+//+");
}

}  // namespace html_test
