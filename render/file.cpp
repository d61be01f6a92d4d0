#include "render/file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace render {
namespace {

std::string reason(int error_number) { return std::generic_category().message(error_number); }

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

/// A file that disappears unless it is renamed to its final name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target) : target_(target), path_(target) {
    path_ += "." + std::to_string(getpid()) + ".tmp";
  }
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::span<const std::uint8_t> bytes) const {
    File file(std::fopen(path_.c_str(), "wb"));
    if (file == nullptr) fail("create " + path_.string(), errno);
    if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) fail("write " + path_.string(), errno);
    if (std::fclose(file.release()) != 0) fail("write " + path_.string(), errno);
  }

  void rename_to_target() const {
    std::error_code error;
    std::filesystem::rename(path_, target_, error);
    if (error) fail("rename " + path_.string() + " to it", error.value());
  }

 private:
  [[noreturn]] void fail(const std::string& step, int error_number) const {
    throw FileError("cannot write " + target_.string() + ": could not " + step + ": " + reason(error_number) +
                    "; check that the folder exists, may be written to and has space left");
  }

  std::filesystem::path target_, path_;
};

}  // namespace

void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  const TemporaryFile file(path);
  file.write(bytes);
  file.rename_to_target();
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::vector<std::uint8_t> read_file(const std::filesystem::path& path) {
  const auto fail = [&](int error_number) {
    throw ReadError("cannot read " + path.string() + ": " + reason(error_number) +
                    "; check that the file exists and may be read");
  };
  const File file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) fail(errno);
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint8_t> block(1 << 16);
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), file.get())) {
    bytes.insert(bytes.end(), block.begin(), block.begin() + static_cast<std::ptrdiff_t>(size));
  }
  if (std::ferror(file.get()) != 0) fail(errno);
  return bytes;
}

}  // namespace render
