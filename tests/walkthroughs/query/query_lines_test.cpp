// gjkstep query: streams of lines, in constant memory.

#include "walkthroughs/query/query_lines.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/walkthroughs/program/program.hpp"
#include "tests/walkthroughs/query/queries.hpp"
#include "walkthroughs/query/query.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using Json = nlohmann::json;

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

std::string answers_to(const std::string& text, std::size_t count = 1 << 16) {
  std::string out;
  answer_lines({}, parts_of(text, count), [&](std::string_view part) { out += part; });
  return out;
}

}  // namespace

TEST_CASE("There is a line out for each line in, in the same order, however the input comes in parts") {
  const std::string text = pair_of(ball, ball_ten_away) + "\n\nnonsense\r\n" + pair_of(dot, dot) + "\r\n\n" +
                           pair_of(ball, ball);  // without a line feed
  const std::string whole = answers_to(text);
  const std::vector<std::string> said = lines(whole);
  REQUIRE(said.size() == 6);
  for (const std::size_t i : {0u, 3u, 5u}) CHECK(Json::parse(said[i]).contains("status"));
  for (const std::size_t i : {1u, 2u, 4u}) CHECK(Json::parse(said[i])["line"] == i + 1);
  for (std::size_t count = 1; count < text.size(); ++count) CHECK(answers_to(text, count) == whole);
}

TEST_CASE("Bad lines are counted and the first is remembered") {
  const QueryTally tally =
      answer_lines({}, parts_of(pair_of(dot, dot) + "\nx\n" + pair_of(dot, dot) + "\ny", 5), [](std::string_view) {});
  CHECK(tally.lines == 4);
  CHECK(tally.bad == 2);
  CHECK(tally.first_bad == 2);
}

TEST_CASE("A byte order mark is passed over as files of some editors have one") {
  CHECK(Json::parse(answers_to("\xEF\xBB\xBF" + pair_of(dot, dot) + "\n")).contains("status"));
}

TEST_CASE("No input is no line") {
  CHECK(answers_to("").empty());
  CHECK(answer_lines({}, parts_of("", 1), [](std::string_view) {}).lines == 0);
}

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
  const std::string line = pair_of(R"({"points":[[0,0,0],[1,0,0],[0,1,0]]})", ball_ten_away) + "\n";
  CHECK(growth_of_heap(line, 200000) < 200000);
}

TEST_CASE("Memory does not grow with a line that is too long") {
  CHECK(growth_of_heap(std::string(1 << 20, ' '), 200) < 3 * query_limits::line);
}

TEST_CASE("A line that is too long is an error and the next one is answered") {
  const std::string said =
      answers_to(std::string(query_limits::line, ' ') + "\n" + std::string(query_limits::line + 1, ' ') + "\n" +
                 pair_of(dot, dot) + "\n" + std::string(query_limits::line + 1, ' '));
  REQUIRE(lines(said).size() == 4);
  CHECK(has(lines(said)[0], "blank"));
  CHECK(lines(said)[1] == R"({"error":"the line is longer than 16 MiB; give fewer points","line":2})");
  CHECK(has(lines(said)[2], "intersecting"));
  CHECK(has(lines(said)[3], "longer than 16 MiB"));
}

TEST_CASE("All answers so far are written before more is read") {
  const std::string line = pair_of(dot, dot) + "\n";
  std::string out;
  std::size_t asked = 0;
  const auto read = [&](std::span<char> bytes) -> std::size_t {
    CHECK(lines(out).size() == asked);
    if (asked == 3) return 0;
    ++asked;
    std::memcpy(bytes.data(), line.data(), line.size());
    return line.size();
  };
  answer_lines({}, read, [&](std::string_view part) { out += part; });
  CHECK(asked == 3);
}
