#include "tests/study/sweep/checksum.hpp"

#include <zlib.h>

#include <algorithm>

namespace study {
namespace {

/// Returns: how a text ends that begins like this.
std::string end_of(std::string_view begin) {
  const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(begin.data()), begin.size());
  return ",\"crc32\":" + std::to_string(sum) + "}\n";
}

}  // namespace

std::string with_checksum(std::string_view object) {
  const std::string begin(object.substr(0, object.rfind('}')));
  return begin + end_of(begin);
}

bool has_its_checksum(std::string_view text) {
  const std::size_t last_key = std::min(text.rfind(','), text.size());
  return text.substr(last_key) == end_of(text.substr(0, last_key));
}

}  // namespace study
