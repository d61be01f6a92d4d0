#include "walkthroughs/output/zip_file.hpp"

#include <zip.h>

#include <memory>
#include <string>

#include "render/file.hpp"
#include "walkthroughs/output/manifest.hpp"

namespace walkthroughs::output {
namespace {

constexpr zip_int64_t to_the_end = -1;
constexpr zip_uint16_t no_time = 0, first_day = (1 << 5) + 1;  // 1980-01-01, as MS-DOS has it

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& why) {
  throw render::FileError(file.string() + ": cannot be written: " + why + "; choose another with --zip");
}

/// Requires: files of less than 4 GiB.
void add(zip_t* archive, const std::filesystem::path& file, const std::string& name) {
  zip_source_t* const source = zip_source_file(archive, file.c_str(), 0, to_the_end);
  const zip_int64_t index = source ? zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
  if (index < 0) {
    zip_source_free(source);
    fail(file, zip_strerror(archive));
  }
  zip_file_set_dostime(archive, static_cast<zip_uint64_t>(index), no_time, first_day, 0);
}

}  // namespace

void write_zip(const std::filesystem::path& file, const std::filesystem::path& folder,
               const std::vector<std::filesystem::path>& files) {
  int error = 0;
  std::unique_ptr<zip_t, void (*)(zip_t*)> archive(
      zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error), zip_discard);
  if (!archive) {
    zip_error_t reason;
    zip_error_init_with_code(&reason, error);
    const std::string text = zip_error_strerror(&reason);
    zip_error_fini(&reason);
    fail(file, text);
  }
  for (const std::filesystem::path& each : files) add(archive.get(), each, each.lexically_relative(folder).generic_string());
  if (zip_close(archive.get()) != 0) fail(file, zip_strerror(archive.get()));
  static_cast<void>(archive.release());  // closed, it is no more
  adopt(file);
}

}  // namespace walkthroughs::output
