#include "tests/study/report/pictures.hpp"

#include <optional>
#include <string>
#include <system_error>

#include "render/file.hpp"
#include "tests/study/report/filter.hpp"

namespace study {

bool draw(const Picture& picture, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / picture.file;
  std::error_code error;
  std::filesystem::remove(file, error);  // a picture of other data must not stay beside new tables
  const std::optional<std::string> drawn = filtered("gnuplot", picture.script);
  if (!drawn || drawn->empty()) return false;
  render::write_file(file, *drawn);
  return true;
}

}  // namespace study
