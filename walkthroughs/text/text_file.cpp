#include "walkthroughs/text/text_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>

namespace walkthroughs {
namespace {

/// A file that is open for reading.
class Descriptor {
 public:
  /// Does not wait where `file` is a pipe that nobody writes to.
  explicit Descriptor(const std::filesystem::path& file)
      : number_(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void fail_to_read(const std::filesystem::path& file, const std::string& what_to_do) {
  throw InputError(file.string() + ": cannot be read: " + std::strerror(errno) + "; " + what_to_do);
}

[[noreturn]] void fail_too_large(const std::filesystem::path& file, const TextFile& expected) {
  throw InputError(file.string() + ": is larger than " + std::to_string(expected.bytes >> 20) + " MiB; a " +
                   expected.kind + " has no need for so much");
}

}  // namespace

std::string read_text(const std::filesystem::path& file, const TextFile& expected) {
  const Descriptor descriptor(file);
  struct stat status;
  if (descriptor.number() < 0 || ::fstat(descriptor.number(), &status) != 0)
    fail_to_read(file, "check the name and the permissions");
  if (!S_ISREG(status.st_mode))
    throw InputError(file.string() + ": is " + (S_ISDIR(status.st_mode) ? "a folder" : "not a regular file") +
                     "; name a " + expected.kind);
  if (static_cast<std::uintmax_t>(status.st_size) > expected.bytes) fail_too_large(file, expected);
  std::string text;
  for (;;) {  // it may have grown, and files of /proc do not tell their size
    char part[1 << 16];
    const ssize_t count = ::read(descriptor.number(), part, sizeof part);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_to_read(file, "check the disk");
    if (count == 0) return text;
    text.append(part, static_cast<std::size_t>(count));
    if (text.size() > expected.bytes) fail_too_large(file, expected);
  }
}

}  // namespace walkthroughs
