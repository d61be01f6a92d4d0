#include "walkthroughs/output/zip_file.hpp"

#include <minizip/zip.h>

#include <string>

#include "render/file.hpp"
#include "walkthroughs/output/manifest.hpp"

namespace walkthroughs::output {
namespace {

constexpr unsigned long first_day = 33UL << 16;  // 1980-01-01, as MS-DOS has it
constexpr unsigned long names_are_utf8 = 1UL << 11;

/// Returns: whether it could be written.
bool add(zipFile archive, const std::filesystem::path& file, const std::string& name) {
  const std::vector<std::uint8_t> bytes = render::read_file(file);
  zip_fileinfo info{};
  info.dosDate = first_day;
  return zipOpenNewFileInZip4(archive, name.c_str(), &info, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                              Z_DEFAULT_COMPRESSION, 0, -MAX_WBITS, DEF_MEM_LEVEL, Z_DEFAULT_STRATEGY, nullptr, 0, 0,
                              names_are_utf8) == ZIP_OK &&
         zipWriteInFileInZip(archive, bytes.data(), static_cast<unsigned>(bytes.size())) == ZIP_OK &&
         zipCloseFileInZip(archive) == ZIP_OK;
}

}  // namespace

void write_zip(const std::filesystem::path& file, const std::filesystem::path& folder,
               const std::vector<std::filesystem::path>& files) {
  const std::filesystem::path unfinished = file.string() + ".unfinished";
  const zipFile archive = zipOpen64(unfinished.c_str(), APPEND_STATUS_CREATE);
  bool is_whole = archive != nullptr;
  for (const std::filesystem::path& each : files)
    is_whole = is_whole && add(archive, each, each.lexically_relative(folder).generic_string());
  if (archive) is_whole = zipClose(archive, nullptr) == ZIP_OK && is_whole;
  std::error_code failed;
  if (is_whole) std::filesystem::rename(unfinished, file, failed);
  if (!is_whole || failed) {
    std::filesystem::remove(unfinished, failed);
    throw render::FileError("cannot write " + file.string() +
                            "; check that its folder may be written to and has space left");
  }
  adopt(file);
}

}  // namespace walkthroughs::output
