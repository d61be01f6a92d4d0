#include "tests/study/report/results.hpp"

#include <iostream>
#include <utility>

#include "render/file.hpp"
#include "tests/study/report/pictures.hpp"
#include "tests/study/report/tables.hpp"
#include "tests/study/sweep/study_file.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace study {
namespace {

constexpr const char* whole = "study.json";
constexpr std::pair<const char*, std::string (*)(const Settings&)> texts[] = {
    {"study.csv", counts_csv},           {"timings.csv", timings_csv},       {"tables.md", counts_markdown},
    {"errors.md", errors_markdown},      {"settings.md", settings_markdown}, {"timings.md", timings_markdown},
    {"certified.md", certified_markdown}};

void write(const std::filesystem::path& file, const std::string& text) {
  render::write_file(file, text);
  std::cout << file.string() << '\n';
}

}  // namespace

std::vector<std::filesystem::path> result_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files = {folder / whole};
  for (const auto& [name, text] : texts) files.push_back(folder / name);
  for (const char* const picture : picture_files) files.push_back(folder / picture);
  return files;
}

void write_results(const std::filesystem::path& folder, const Study& study) {
  render::make_folder(folder, "choose another with --out");
  const Settings settings(study);
  write(folder / whole, to_json(study));
  for (const auto& [name, text_of] : texts)
    if (const std::string text = text_of(settings); !text.empty()) write(folder / name, text);
  for (const Picture& picture : {error_vs_time(settings), heat_map(settings), iterations(settings)})
    if (draw(picture, folder))
      std::cout << (folder / picture.file).string() << '\n';
    else
      std::cerr << "gjkstep-study: " << picture.file << " is left out: gnuplot is not there or failed; apt-get install "
                << "gnuplot-nox, then: gjkstep-study merge " << (folder / whole).string() << " --out "
                << folder.string() << '\n';
}

std::filesystem::path shard_file(const std::filesystem::path& folder, const Shard& shard) {
  return folder / ("shard-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.count) + ".json");
}

void write_shard(const std::filesystem::path& folder, const Study& study) {
  render::make_folder(folder, "choose another with --out");
  write(shard_file(folder, study.shard), to_json(study));
}

Study read_study(const std::filesystem::path& file) {
  constexpr std::size_t largest = std::size_t{64} << 20;  // many times that of a study of everything
  return from_json(walkthroughs::read_text(file, {"file that gjkstep-study wrote", largest}), file.string());
}

}  // namespace study
