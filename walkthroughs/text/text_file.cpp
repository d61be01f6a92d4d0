#include "walkthroughs/text/text_file.hpp"

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
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw InputError("cannot read standard input: " + std::generic_category().message(errno));
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
