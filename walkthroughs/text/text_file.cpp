#include "walkthroughs/text/text_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace walkthroughs::text {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why, const std::string& what_to_do) {
  throw InputError("cannot read " + called(file) + ": " + why + "; " + what_to_do);
}

std::string reason() { return std::generic_category().message(errno); }

std::string read_standard_input(std::size_t most) {
  const OpenFile file("-");
  std::string text;
  std::array<char, 1 << 16> bytes;
  while (const std::size_t count = file.read_some(bytes)) {
    text.append(bytes.data(), count);
    if (text.size() > most)
      throw InputError("standard input has more than " + std::to_string(most >> 20) + " MiB; give less");
  }
  return text;
}

}  // namespace

OpenFile::OpenFile(const std::filesystem::path& file)
    : file_(file),
      descriptor_(is_standard_input(file) ? STDIN_FILENO : ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
  if (descriptor_ < 0) refuse(file_, reason(), "check that the file exists and may be read");
  struct stat status {};
  if (is_standard_input(file_) || (::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode))) return;
  ::close(descriptor_);
  S_ISDIR(status.st_mode) ? refuse(file_, "it is a folder", "name a file")
                          : refuse(file_, "it is not a regular file", "let standard input read it, and name -");
}

OpenFile::~OpenFile() {
  if (!is_standard_input(file_)) ::close(descriptor_);
}

std::size_t OpenFile::read_some(std::span<char> bytes) const {
  for (;;) {
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    pollfd polled{descriptor_, POLLIN, 0};
    if (errno == EAGAIN)
      ::poll(&polled, 1, -1);  // a pipe that another program has set not to wait
    else if (errno != EINTR)
      refuse(file_, reason(), is_standard_input(file_) ? "give it a text" : "check the disk");
  }
}

std::string read_text(const std::filesystem::path& file, std::size_t most) {
  if (is_standard_input(file)) return read_standard_input(most);
  const std::vector<std::uint8_t> bytes = render::read_file(file, most);
  return {bytes.begin(), bytes.end()};
}

}  // namespace walkthroughs::text
