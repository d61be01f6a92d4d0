#include "walkthroughs/text/text_file.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace walkthroughs::text {
namespace {

std::string read_standard_input(std::size_t most) {
  std::string text;
  std::array<char, 1 << 16> bytes;
  while (true) {
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count == 0) return text;
    pollfd standard_input{STDIN_FILENO, POLLIN, 0};
    if (count < 0 && errno == EAGAIN)
      ::poll(&standard_input, 1, -1);  // a pipe that another program has set not to wait
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count < 0)
      throw InputError("cannot read standard input: " + std::generic_category().message(errno) + "; give it a text");
    text.append(bytes.data(), static_cast<std::size_t>(count));
    if (text.size() > most)
      throw InputError("standard input has more than " + std::to_string(most >> 20) + " MiB; give less");
  }
}

}  // namespace

std::string read_text(const std::filesystem::path& file, std::size_t most) {
  if (is_standard_input(file)) return read_standard_input(most);
  const std::vector<std::uint8_t> bytes = render::read_file(file, most);
  return {bytes.begin(), bytes.end()};
}

}  // namespace walkthroughs::text
