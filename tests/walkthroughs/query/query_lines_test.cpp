// gjkstep query: streams of lines, in constant memory.

#include "walkthroughs/query/query_lines.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstring>

#include "tests/kit/catch.hpp"
#include "walkthroughs/query/query.hpp"

namespace query_lines_test {

using namespace walkthroughs::program;

namespace {

/// Gives a text in parts of that many bytes.
ReadSome parts_of(const std::string& text, std::size_t count) {
  return [=, at = std::size_t{0}](std::span<char> bytes) mutable {
    const std::size_t n = std::min({count, bytes.size(), text.size() - at});
    std::memcpy(bytes.data(), text.data() + at, n);
    at += n;
    return n;
  };
}

}  // namespace

TEST_CASE("Lines may be as long as said and longer ones are passed over, in parts of any size") {
  const std::string text = "12345\n123456\n\n1234567890\n12345";
  for (std::size_t count = 1; count <= text.size(); ++count) {
    LineReader reader(parts_of(text, count), 5);
    std::string seen;
    while (const auto line = reader.next()) seen += (line->is_too_long ? "too long" : std::string(line->text)) + ";";
    CHECK(seen == "12345;too long;;too long;12345;");
  }
  LineReader reader(parts_of("1\n123456", 2), 5);
  CHECK(reader.next()->text == "1");
  CHECK(reader.next()->is_too_long);
  CHECK_FALSE(reader.next().has_value());
}

namespace {

/// Returns: the bytes that the heap has handed out. (None are known under AddressSanitizer.)
std::size_t heap() {
  const auto info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

/// Answers `line`, `count` times over. Returns: by how much the heap was larger than before, at its largest.
std::size_t growth_of_heap(const std::string& line, std::size_t count) {
  const std::size_t before = heap();
  std::size_t most = 0, lines_left = count;
  std::string_view rest;
  const auto read = [&](std::span<char> bytes) {
    most = std::max(most, heap() - std::min(before, heap()));
    if (rest.empty() && lines_left > 0) {
      rest = line;
      --lines_left;
    }
    const std::size_t n = std::min(bytes.size(), rest.size());
    std::memcpy(bytes.data(), rest.data(), n);
    rest.remove_prefix(n);
    return n;
  };
  answer_lines({}, read, [](std::string_view) {});
  return most;
}

}  // namespace

TEST_CASE("Memory does not grow with the number of lines") {
  const std::string line = R"({"a":{"points":[[0,0,0],[1,0,0],[0,1,0]]},"b":{"sphere":{"center":[10,0,0],"radius":1}}})"
                           "\n";
  CHECK(growth_of_heap(line, 200000) < 200000);
}

TEST_CASE("Memory does not grow with a line that is too long") {
  CHECK(growth_of_heap(std::string(1 << 20, ' '), 200) < 3 * query_limits::line);
}

/// What is asked for most has a reader of its own. A name makes the line one for the other reader, and changes no answer.
TEST_CASE("Two sets of points are answered as any other line is, complaints included") {
  const char* sets[] = {"[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]",
                        "[[0.25,0.25,0.25],[2,2,2]]",
                        "[[-0.0,1e-300,5],[18446744073709551615,-3,0.1]]",
                        "[[1e200,0,0]]",
                        "[[1e39,0,0],[0,1,0]]",
                        "[[0,0],[1,1]]",
                        "[[0,0,0,0]]",
                        "[]",
                        "[[0,0,\"0\"]]",
                        "[[0,0,null]]",
                        "[0,0,0]",
                        "{}"};
  const auto line = [](const std::string& a, const std::string& b, const std::string& name) {
    return R"({"a":{)" + name + R"("points":)" + a + R"(},"b":{"points":)" + b + "}}";
  };
  for (const QueryEvidence evidence :
       {QueryEvidence::of_the_search, QueryEvidence::certificate, QueryEvidence::fractions})
    for (const QueryScalar scalar : {QueryScalar::binary64, QueryScalar::binary32})
      for (const char* a : sets)
        for (const char* b : sets) {
          QueryOptions options;
          options.evidence = evidence;
          options.scalar = scalar;
          std::string usual, named;
          answer_line(line(a, b, ""), 7, options, usual);
          answer_line(line(a, b, R"("name":"one",)"), 7, options, named);
          CAPTURE(a, b);
          CHECK(usual == named);
        }
}

}  // namespace query_lines_test
