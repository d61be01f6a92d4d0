/// Whatever a file for `gjkstep-study merge` holds: it is read, added up and told, or it is turned away with a StudyError that
/// names it. What is read says all that the file says. Texts get a right checksum first, which would turn almost all away.
///
///     cmake -S . -B build/fuzz -G Ninja -DGJKSTEP_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++
///     ninja -C build/fuzz shard-file-fuzz
///     mkdir -p build/fuzz/found-shards
///     build/fuzz/shard-file-fuzz -dict=tests/fuzz/shard_file.dict -max_len=8192 -timeout=10 -rss_limit_mb=512
///         build/fuzz/found-shards tests/fuzz/shards
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "tests/study/report/pictures.hpp"
#include "tests/study/report/tables.hpp"
#include "tests/study/sweep/checksum.hpp"
#include "tests/study/sweep/study_file.hpp"

namespace {

using namespace study;

void require(bool holds) {
  if (!holds) std::abort();
}

template <class Make>
std::optional<Study> study_or_reason(Make&& make) {
  try {
    return make();
  } catch (const StudyError& error) {
    require(std::string_view(error.what()).find("fuzz.json") != std::string_view::npos ||
            std::string_view(error.what()).find(" is missing; make it with: ") != std::string_view::npos);
    return std::nullopt;
  }
}

std::optional<Study> read(const std::string& text) {
  return study_or_reason([&] { return from_json(text, "fuzz.json"); });
}

void require_told(const Study& study) {
  const Settings settings(study);
  for (const auto& table :
       {counts_csv, timings_csv, counts_markdown, errors_markdown, settings_markdown, timings_markdown})
    require(!table(settings).empty());
  require(certified_markdown(settings).empty() == settings.certified().empty());
  for (const auto& picture : {error_vs_time, heat_map, iterations}) require(!picture(settings).script.empty());
  contradiction(study);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read(text);
  const std::size_t sum = text.rfind(",\"crc32\":");
  const std::optional<Study> shard = read(with_checksum(sum == std::string::npos ? text : text.substr(0, sum) + "}"));
  if (!shard) return 0;
  const std::string again = to_json(*shard);
  require(to_json(from_json(again, "again")) == again);
  const auto sum_of_one = study_or_reason([&] { return merged({{"fuzz.json", *shard}}); });
  if (sum_of_one) require_told(*sum_of_one);
  require_told(*shard);
  return 0;
}
