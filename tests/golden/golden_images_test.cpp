// The chosen pictures are what was accepted, pixel by pixel.

#include <functional>
#include <optional>
#include <set>

#include "render/compare.hpp"
#include "render/compare_report.hpp"
#include "render/file.hpp"
#include "render/rendered_by.hpp"
#include "tests/golden/pictures.hpp"
#include "tests/golden/store.hpp"
#include "tests/kit/catch.hpp"

namespace golden_images_test {

using namespace golden;

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 20 * 1024;

render::RenderedBy notes_of(const walkthroughs::output::Studio& studio) {
  return render::rendered_by(studio.context, studio.font_folder);
}

void accept_notes(const walkthroughs::output::Studio& studio) {
  accept("images/" + std::string(render::rendered_by_file), render::rendered_by_json(notes_of(studio)),
         "what drew the goldens");
}

/// Returns: what drew the goldens and what draws now, line by line.
std::string both_notes(const walkthroughs::output::Studio& studio) {
  std::string text;
  const auto golden = render::read_rendered_by(folder() / "images");
  for (const auto& line : render::side_by_side(golden.value_or(render::RenderedBy{}), notes_of(studio)))
    text += "  " + line.key + ": " + line.expected.value_or("not recorded") +
            (line.differs() ? "; now " + line.actual.value_or("not recorded") : "") + "\n";
  return text;
}

/// A picture that is kept: of a frame or of parts of the renderer.
struct Kept {
  std::string name, reason;
  std::function<render::Image(walkthroughs::output::Studio&)> draw;
};

std::vector<Kept> all_kept() {
  std::vector<Kept> all;
  for (const Picture& picture : pictures())
    all.push_back(
        {picture.name(), picture.reason, [&](walkthroughs::output::Studio& studio) { return draw(picture, studio); }});
  for (const Part& part : parts()) all.push_back({part.name, part.reason, part.draw});
  return all;
}

/// One picture, drawn now and compared. Returns: nothing where it passes or was accepted.
std::optional<render::ComparedFiles> check(const Kept& kept, walkthroughs::output::Studio& studio) {
  const std::string name = kept.name + ".png";
  const std::vector<std::uint8_t> png =
      render::encode_png(kept.draw(studio), {.title = kept.name, .description = kept.reason});
  CHECK(png.size() <= most_bytes);
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

}  // namespace

TEST_CASE("images of chosen frames and parts are the accepted ones", "[unsanitized]") {
  walkthroughs::output::Studio studio;
  render::CompareReport report({.expected = "tests/golden/images",
                                .actual = "drawn now",
                                .expected_by = render::read_rendered_by(folder() / "images"),
                                .actual_by = notes_of(studio)});
  int failures = 0;
  for (const Kept& kept : all_kept()) {
    const auto failed = check(kept, studio);
    if (!failed) continue;
    ++failures;
    report.add(*failed, command_to_accept("images"));
    FAIL_CHECK(kept.name << ": " << failed->words << "\n(" << kept.reason << ")");
  }
  CHECK(failures == 0);
  if (accepting()) accept_notes(studio);
  if (failures == 0) return;
  const fs::path page = leave_candidate("index.html", report.html());
  WARN("Look at: " << page.string() << "\nTo accept: " << command_to_accept("images") << "\nDrawn by:\n"
                   << both_notes(studio));
}

TEST_CASE("images that are accepted are those that are drawn") {
  std::set<std::string> drawn;
  for (const Kept& kept : all_kept()) CHECK(drawn.insert(kept.name + ".png").second);
  for (const std::string& name : render::pictures_in(folder() / "images")) CHECK(drawn.contains(name));
}

}  // namespace golden_images_test
