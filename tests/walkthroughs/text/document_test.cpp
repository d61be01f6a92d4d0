// Document::of_line() has a quick way through lines, which must not be seen but in the time it takes.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/walkthroughs/text/same_tree.hpp"

namespace document_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

std::string complaint_of(const Document& document) {
  const auto& complaint = document.complaint();
  return complaint ? std::to_string(complaint->line) + ":" + complaint->text() : "";
}

void check_both_ways(const std::string& text) {
  INFO(text.substr(0, 200));
  const Document quick = Document::of_line(text), slow(text, Document::Comments::refused);
  CHECK(complaint_of(quick) == complaint_of(slow));
  CHECK(same_tree(quick.root(), slow.root()));
}

std::string repeated(const std::string& text, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

/// Returns: a list or object of `count` values.
std::string list_of(std::size_t count) { return "[" + repeated("0,", count - 1) + "0]"; }
std::string object_of(std::size_t count) {
  std::string text = "{";
  for (std::size_t i = 0; i < count; ++i) text += (i ? ",\"" : "\"") + std::to_string(i) + "\":0";
  return text + "}";
}

}  // namespace

TEST_CASE("A line is read as the other reader reads it, number by number") {
  for (const char* number :
       {"0", "-0", "-0.0", "0.0", "-0e5", "1", "-1", "1.5", "0.1", "1e5", "1E+5", "1e-5", "9007199254740993",
        "18446744073709551615", "18446744073709551616", "-9223372036854775808", "-9223372036854775809",
        "123456789012345678901234567890", "1e308", "1.7976931348623157e308", "1.7976931348623159e308", "1e400",
        "-1e400", "1e-400", "-1e-400", "5e-324", "4.9e-324", "2.4e-324", "2.2250738585072011e-308",
        "0.1000000000000000055511151231257827", "1.00000000000000011102230246251565404236316680908203125", "0e400",
        // which JSON does not have
        "01", "-01", "+1", ".5", "5.", "1e", "1e+", "-", "--1", "0x10", "1_000", "1,5", "nan", "NaN", "inf", "-inf",
        "Infinity", "-Infinity", "1f", "1e5.5", "٣"}) {
    check_both_ways(number);
    check_both_ways("[" + std::string(number) + "]");
    check_both_ways("{\"a\":" + std::string(number) + "}");
    check_both_ways(" [0, " + std::string(number) + " ] ");
  }
}

TEST_CASE("A line is read as the other reader reads it where it is odd or wrong") {
  const std::string apart_by_two_blanks =
      R"~([]  {}  [[],{}]  "text"  ""  "a\n\u00e9"  "é"  "\ud800\udc00"  "\ud800"  "\udc00"  "\ud800\u0041"  "\u0000\/\b\x"  )~"
      R"~({"\u0000":1,"\u0000":2}  null  true  [false]  {"a":1,"b":2}  {"":1}  {"a":1,"a":2}  {"a":1,"\u0061":2}  [1,]  )~"
      R"~([,1]  [1 2]  {"a"}  {"a":}  {"a":1,}  {a:1}  {1:1}  [  ]  {  }  [1}  {"a":1]  "  "a  "\  [] []  []x  )~"
      R"~([/* no */]  ['a']  )~";
  for (std::size_t at = 0, end; (end = apart_by_two_blanks.find("  ", at)) != std::string::npos; at = end + 2)
    check_both_ways(apart_by_two_blanks.substr(at, end - at));
  for (const char* text : {"[1 ,\t2]\r", "\"\xED\xA0\x80\"", "\"\xC0\x80\"", "\"\x7f\"", "// no\n[]", "\xEF\xBB\xBF[1]",
                           "\xEF\xBB[1]", "\xFF\xFE[", "[\"\xFF\"]", "[\"\t\"]"})
    check_both_ways(text);
  check_both_ways(std::string("[\0]", 3));
  check_both_ways(std::string("[1]\0", 4));
}

TEST_CASE("The limits of a document are those of a line") {
  using namespace document_limits;
  for (const std::size_t more : {0u, 1u}) {
    check_both_ways(repeated("[", depth + more) + repeated("]", depth + more));
    check_both_ways(repeated("{\"a\":", depth + more) + "1" + repeated("}", depth + more));
    check_both_ways(list_of(elements + more));
    check_both_ways(object_of(members + more));
    check_both_ways("[" + repeated(list_of(elements) + ",", values / elements - 1) +
                    list_of(elements - 1 - values / elements + more) + "]");
  }
  check_both_ways(repeated("[", 1000000));
}

TEST_CASE("Wherever a letter of a line is changed both readers agree") {
  const std::string line = R"({"a": {"points": [[1.25e-3, -2, 0.5], [0,1,2]], "name":"x"}, "b":{"sphere":null}})";
  const std::string letters = "\"\\{}[]:,.eE+-019 \tx\x01\x80\xC3";
  kit::Dice dice(21);
  for (int i = 0; i < 4000; ++i) {
    std::string changed = line;
    const int changes = dice.between(1, 3);
    for (int k = 0; k < changes; ++k) {
      const auto at = static_cast<std::size_t>(dice.between(0, static_cast<int>(changed.size()) - 1));
      const char letter = letters[static_cast<std::size_t>(dice.between(0, static_cast<int>(letters.size()) - 1))];
      if (dice.between(0, 2) == 0)
        changed.erase(at, 1);
      else if (dice.between(0, 1) == 0)
        changed.insert(at, 1, letter);
      else
        changed[at] = letter;
    }
    check_both_ways(changed);
  }
}

}  // namespace document_test
