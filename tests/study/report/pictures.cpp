#include "tests/study/report/pictures.hpp"

#include <cstdio>
#include <memory>
#include <system_error>

#include "tests/study/report/gnuplot.hpp"

namespace study {

bool draw(const Picture& picture, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / picture.file, unfinished = file.string() + ".unfinished";
  std::error_code error;
  std::filesystem::remove(file, error);  // a picture of other data must not stay beside new tables
  if (const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe{popen("gnuplot 1>&2", "w"), pclose}; pipe) {
    const std::string text =
        "set output " + in_quotes(unfinished.string()) + "\n" + picture.script + "\nunset output\n";
    std::fputs(text.c_str(), pipe.get());
  }
  const bool is_drawn = std::filesystem::file_size(unfinished, error) > 0 && !error;
  if (is_drawn) std::filesystem::rename(unfinished, file, error);
  std::error_code ignored;
  std::filesystem::remove(unfinished, ignored);
  return is_drawn && !error;
}

}  // namespace study
