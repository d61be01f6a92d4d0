#include "tests/study/report/filter.hpp"

#include "tests/kit/catch.hpp"

namespace study::test {
namespace {

TEST_CASE("A filter is given all of its input, and all that it writes is returned", "[filter]") {
  CHECK(filtered("cat", "a\n\0b") == "a\n\0b");
  CHECK(filtered("sort", std::string(2'000'000, 'x') + "\n") == std::string(2'000'000, 'x') + "\n");
  CHECK(filtered("true", std::string(2'000'000, 'x')) == "");  // which it does not read
}

TEST_CASE("A filter that fails or is not there has no output", "[filter]") {
  CHECK(filtered("false", "") == std::nullopt);
  CHECK(filtered("false", std::string(2'000'000, 'x')) == std::nullopt);
  CHECK(filtered("there-is-no-such-program", "x") == std::nullopt);
}

}  // namespace
}  // namespace study::test
