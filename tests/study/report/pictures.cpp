#include "tests/study/report/pictures.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "render/file.hpp"
#include "render/image.hpp"
#include "tests/study/report/filter.hpp"

namespace study {
namespace {

/// Returns: the same picture in fewer bytes: of lines the encoder of render makes smaller files than gnuplot's, of areas in few
/// colours gnuplot's palettes are smaller.
std::string smaller(const std::string& png, const std::string& name) {
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(png.data()), png.size());
  const std::vector<std::uint8_t> again = render::encode_png(render::decode_png(bytes, name), {});
  return again.size() < png.size() ? std::string(again.begin(), again.end()) : png;
}

}  // namespace

bool draw(const Picture& picture, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / picture.file;
  std::error_code error;
  std::filesystem::remove(file, error);  // a picture of other data must not stay beside new tables
  const std::optional<std::string> drawn = filtered("gnuplot", picture.script);
  if (!drawn || drawn->empty()) return false;
  render::write_file(file, smaller(*drawn, file.string()));
  return true;
}

}  // namespace study
