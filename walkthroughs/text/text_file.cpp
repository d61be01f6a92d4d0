#include "walkthroughs/text/text_file.hpp"

#include "render/file.hpp"

namespace walkthroughs::text {

std::string read_text(const std::filesystem::path& file, std::size_t most) try {
  const std::vector<std::uint8_t> bytes = render::read_file(file, most);
  return {bytes.begin(), bytes.end()};
} catch (const render::ReadError& error) {
  throw InputError(error.what());
}

}  // namespace walkthroughs::text
