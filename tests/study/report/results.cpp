#include "tests/study/report/results.hpp"

#include <iostream>

#include "render/file.hpp"
#include "tests/study/report/pictures.hpp"
#include "tests/study/report/tables.hpp"
#include "tests/study/sweep/folder.hpp"
#include "tests/study/sweep/study_file.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace study {
namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  render::write_file(file, text);
  std::cout << file.string() << '\n';
}

}  // namespace

void write_results(const std::filesystem::path& folder, const Study& study) {
  make_folder(folder);
  const Settings settings(study);
  write(folder / "study.json", to_json(study));
  write(folder / "study.csv", counts_csv(settings));
  write(folder / "timings.csv", timings_csv(settings));
  write(folder / "tables.md", counts_markdown(settings));
  write(folder / "errors.md", errors_markdown(settings));
  write(folder / "settings.md", settings_markdown(settings));
  write(folder / "timings.md", timings_markdown(settings));
  for (const Picture& picture : {error_vs_time(settings), heat_map(settings), iterations(settings)})
    if (draw(picture, folder))
      std::cout << (folder / picture.file).string() << '\n';
    else
      std::cerr << "gjkstep-study: " << picture.file << " is left out: gnuplot is not there or failed; apt-get install "
                << "gnuplot-nox, then: gjkstep-study merge " << (folder / "study.json").string() << " --out "
                << folder.string() << '\n';
}

void write_shard(const std::filesystem::path& folder, const Study& study) {
  make_folder(folder);
  write(folder / ("shard-" + std::to_string(study.shard.index) + "-of-" + std::to_string(study.shard.count) + ".json"),
        to_json(study));
}

Study read_study(const std::filesystem::path& file) {
  constexpr std::size_t largest = std::size_t{64} << 20;  // many times that of a study of everything
  return from_json(walkthroughs::read_text(file, {"file that gjkstep-study wrote", largest}), file.string());
}

}  // namespace study
