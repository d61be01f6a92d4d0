#include "tests/study/sweep/checksum.hpp"

#include "tests/kit/catch.hpp"

namespace study::test {
namespace {

TEST_CASE("The checksum is the CRC-32 of all that stands before it", "[checksum]") {
  CHECK(with_checksum("123456789}") == "123456789,\"crc32\":3421780262}\n");  // 0xCBF43926, the check value of CRC-32
  CHECK(has_its_checksum(with_checksum(R"({"a":[1,2]})")));
}

TEST_CASE("A text without a checksum has not its checksum", "[checksum]") {
  for (const std::string text : {"", "{}", ",", "{\"a\":1}", "{\"a\":1,\"b\":2}\n", "{\"a\":1,\"crc32\":0}\n"}) {
    INFO(text);
    CHECK_FALSE(has_its_checksum(text));
  }
}

}  // namespace
}  // namespace study::test
