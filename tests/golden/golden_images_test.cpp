// The chosen pictures are what was accepted, pixel by pixel.

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>

#include "render/compare.hpp"
#include "render/compare_files.hpp"
#include "render/compare_report.hpp"
#include "render/file.hpp"
#include "render/rendered_by.hpp"
#include "tests/golden/pictures.hpp"
#include "tests/golden/store.hpp"
#include "tests/kit/catch.hpp"

using namespace golden;

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 20 * 1024;

render::RenderedBy notes_of(const walkthroughs::Studio& studio) {
  return render::rendered_by(studio.context, studio.font_folder);
}

void accept_notes(const walkthroughs::Studio& studio) {
  accept("images/" + std::string(render::rendered_by_file), render::rendered_by_json(notes_of(studio)),
         "what drew the goldens");
}

/// Returns: what drew the goldens and what draws now, line by line.
std::string both_notes(const walkthroughs::Studio& studio) {
  std::string text;
  const auto golden = render::read_rendered_by(folder() / "images");
  for (const auto& line : render::side_by_side(golden.value_or(render::RenderedBy{}), notes_of(studio)))
    text += "  " + line.key + ": " + line.expected.value_or("not recorded") +
            (line.differs() ? "; now " + line.actual.value_or("not recorded") : "") + "\n";
  return text;
}

/// One picture, drawn now and compared. Returns: nothing where it passes or was accepted.
std::optional<render::ComparedFiles> check(const Picture& picture, walkthroughs::Studio& studio) {
  const std::string name = picture.name() + ".png";
  const std::vector<std::uint8_t> png =
      render::encode_png(draw(picture, studio), {.title = picture.name(), .description = picture.reason});
  const fs::path candidate = leave_candidate("images/" + name, png);
  const fs::path golden = folder() / "images" / name;
  const render::Sides sides = fs::exists(golden) ? render::Sides::both : render::Sides::only_actual;
  render::ComparedFiles compared = render::compare_files({name, golden, candidate, sides});
  if (compared.verdict == render::Verdict::extra) compared.words = "there is no accepted picture";
  if (render::passes(compared.verdict)) return std::nullopt;
  if (!accepting()) return compared;
  accept("images/" + name, png, compared.words);
  return std::nullopt;
}

/// Returns: the picture's name, what is wrong, and what to do where there is nothing to compare with.
std::string in_words(const Picture& picture, const render::ComparedFiles& failed) {
  const std::string words = picture.name() + ": " + failed.words + "\n(" + picture.reason + ")";
  if (failed.verdict != render::Verdict::extra) return words;
  return words + "\nTo accept " + failed.files.actual.string() + ": " + command_to_accept("golden-tests: images");
}

}  // namespace

TEST_CASE("images of the chosen frames are the accepted ones", "[unsanitized]") {
  walkthroughs::Studio studio;
  render::CompareReport report({.expected = "tests/golden/images",
                                .actual = "drawn now",
                                .expected_by = render::read_rendered_by(folder() / "images"),
                                .actual_by = notes_of(studio)});
  int failures = 0;
  for (const Picture& picture : pictures()) {
    const auto failed = check(picture, studio);
    if (!failed) continue;
    ++failures;
    report.add(*failed, command_to_accept("golden-tests: images"));
    FAIL_CHECK(in_words(picture, *failed));
  }
  CHECK(failures == 0);
  if (accepting()) accept_notes(studio);
  if (failures == 0) return;
  const fs::path page = leave_candidate("index.html", report.html());
  WARN("Look at: " << page.string() << "\nTo accept: " << command_to_accept("golden-tests: images") << "\nDrawn by:\n"
                   << both_notes(studio));
}

TEST_CASE("images are the same whatever of OSMesa and EGL draws them") {
  if (render::built_in_backends().size() == 1) WARN("skipped: this build has one of them alone");
  for (const render::Backend backend : render::built_in_backends()) {
    if (backend == render::default_backend()) continue;
    walkthroughs::Studio studio{.backend = backend};
    for (const Picture& picture : pictures()) {
      INFO(picture.name());
      const render::Image golden = render::read_png(folder() / "images" / (picture.name() + ".png"));
      CHECK(render::passes(render::compare(golden, draw(picture, studio)).verdict));
    }
  }
}

TEST_CASE("images and traces are never accepted where CI is set") {
  const char* const names[] = {"CI", "GJKSTEP_UPDATE_GOLDENS"};
  std::vector<std::optional<std::string>> before;
  for (const char* name : names) {
    const char* value = std::getenv(name);
    before.push_back(value ? std::optional<std::string>(value) : std::nullopt);
  }
  setenv("GJKSTEP_UPDATE_GOLDENS", "1", 1);
  setenv("CI", "true", 1);
  CHECK_THROWS(accepting());
  unsetenv("CI");
  CHECK(accepting());
  unsetenv("GJKSTEP_UPDATE_GOLDENS");
  CHECK_FALSE(accepting());
  for (std::size_t i = 0; i < 2; ++i) before[i] ? setenv(names[i], before[i]->c_str(), 1) : unsetenv(names[i]);
}

TEST_CASE("images that are accepted are listed with a reason and are small") {
  std::set<std::string> listed;
  for (const Picture& picture : pictures()) {
    INFO(picture.name());
    CHECK(listed.insert(picture.name() + ".png").second);
    CHECK(picture.reason.size() > 10);
    const fs::path file = folder() / "images" / (picture.name() + ".png");
    if (fs::exists(file)) CHECK(fs::file_size(file) <= most_bytes);
  }
  for (const std::string& name : render::pictures_in(folder() / "images")) CHECK(listed.count(name) == 1);
  const auto without = std::ranges::count(pictures(), Letters::left_out, &Picture::letters);
  CHECK(2 * without >= static_cast<std::ptrdiff_t>(pictures().size()));
  CHECK(pictures().size() >= 20);
  CHECK(pictures().size() <= 40);
  for (const char* theme : {"report", "slides", "dark"})
    CHECK(std::ranges::count(pictures(), theme, &Picture::theme) >= 2);
}
