// The report of gjkstep compare in a real browser, Chromium without a window. Skipped where there is none.

#include <fstream>

#include "render/image.hpp"
#include "tests/walkthroughs/program/program.hpp"

using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

constexpr render::Color magenta{200, 0, 200}, green{0, 160, 0}, slightly_other{200, 0, 201};
constexpr render::Size drawn{300, 200};

/// What a visitor of the page does and sees, as lines of text. Pixels are read back from the pictures, which shows that
/// they were decoded; the last lines try to reach the network.
constexpr const char* visitor = R"html(<pre id="seen"></pre><script>
const say = line => document.getElementById('seen').append(line + '\n');
const at = kind => { const box = document.querySelector('.fails .' + kind + ' img').getBoundingClientRect();
                     return [box.x, box.y, box.width, box.height].map(Math.round).join(' '); };
const pressed = () => document.querySelector('[data-key=s]').getAttribute('aria-pressed');
const key = (name, more) => document.dispatchEvent(new KeyboardEvent('keydown', {key: name, ...more}));
const pixel = img => { const canvas = document.createElement('canvas').getContext('2d');
                       canvas.drawImage(img, 0, 0);
                       return canvas.getImageData(5, 5, 1, 1).data.join(' '); };
document.addEventListener('securitypolicyviolation', event => say('blocked ' + event.effectiveDirective));
addEventListener('load', () => {
  for (const title of document.querySelectorAll('h3')) say('pair ' + title.textContent);
  for (const img of document.querySelectorAll('img')) say(`img ${img.naturalWidth}x${img.naturalHeight} ${pixel(img)}`);
  const expected = at('expected'), actual = at('actual');
  const swapped = () => at('expected') === actual && at('actual') === expected;
  const restored = () => at('expected') === expected && at('actual') === actual;
  say('apart ' + (expected !== actual));
  key('s'); say(`s ${swapped()} ${pressed()}`);
  key('S'); say(`S ${restored()} ${pressed()}`);
  key('s', {ctrlKey: true}); say(`ctrl-s ${restored()}`);
  key('"'); key('Escape'); say(`others ${restored()}`);
  document.querySelector('[data-key=s]').click(); say(`click ${swapped()} ${pressed()}`);
  key('f'); say('one to one ' + document.querySelector('.fails .expected img').getBoundingClientRect().width);
  say('resources ' + performance.getEntriesByType('resource').filter(r => !r.name.startsWith('data:')).length);
  new Image().src = 'http://127.0.0.1:9/picture.png';
  fetch('http://127.0.0.1:9/data').catch(() => {});
});
</script>
</body>)html";

/// Presses the key and does nothing else.
constexpr const char* swapper =
    "<script>document.dispatchEvent(new KeyboardEvent('keydown', {key: 's'}));</script></body>";

bool browser_is_there() {
  if (std::system("command -v chromium >/dev/null") == 0) return true;
  kit::skip("there is no browser; install the Debian package chromium");
  return false;
}

void draw(const fs::path& file, render::Color color) {
  fs::create_directories(file.parent_path());
  render::Image image(drawn);
  image.fill(color);
  render::write_png(file, image, {});
}

/// A report of three pairs, the one that fails last by name, and a browser to look at it.
class Page {
 public:
  Page() {
    const fs::path expected = folder_.path() / "expected", actual = folder_.path() / "actual";
    for (const char* name : {"1-within.png", "2-same.png", "3-different.png"}) draw(expected / name, magenta);
    draw(actual / "1-within.png", slightly_other);
    draw(actual / "2-same.png", magenta);
    draw(actual / "3-different.png", green);
    const Outcome outcome = run("compare " + quoted(expected.string()) + " " + quoted(actual.string()) + " --report " +
                                quoted(folder_.path().string()));
    REQUIRE(outcome.exit_code == 1);
    html_ = bytes_of(folder_.path() / "index.html");
  }

  /// Puts `script` at the end of the page.
  void append(const std::string& script) {
    const std::string end = "</body>";
    REQUIRE(has(html_, end));
    html_.replace(html_.rfind(end), end.size(), script);
  }

  /// Returns: the page after its scripts have run, as HTML.
  std::string dom() const {
    const fs::path file = folder_.path() / "dom.html";
    browse("--virtual-time-budget=3000 --dump-dom", file);
    return bytes_of(file);
  }

  render::Image screenshot() const {
    const fs::path file = folder_.path() / "screenshot.png";
    browse("--hide-scrollbars --window-size=1200,1400 --screenshot=" + quoted(file.string()), "/dev/null");
    return render::read_png(file);
  }

 private:
  void browse(const std::string& options, const fs::path& out) const {
    const fs::path page = folder_.path() / "page.html", messages = folder_.path() / "messages";
    std::ofstream(page, std::ios::binary) << html_;
    // The sandbox does not work for root, and the page is our own.
    const std::string command = "timeout 100 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage " +
                                ("--user-data-dir=" + quoted((folder_.path() / "profile").string())) + " " + options +
                                " " + quoted("file://" + page.string()) + " >" + quoted(out.string()) + " 2>" +
                                quoted(messages.string());
    const int status = std::system(command.c_str());
    INFO(bytes_of(messages));
    REQUIRE(status == 0);
  }

  Folder folder_;
  std::string html_;
};

/// Returns: what the visitor has told.
std::vector<std::string> seen(const std::string& dom) {
  const std::string begin = "<pre id=\"seen\">";
  const std::size_t at = dom.find(begin);
  REQUIRE(at != std::string::npos);
  return lines(dom.substr(at + begin.size(), dom.find("</pre>", at) - at - begin.size()));
}

/// Pixels of one colour: how many, and where their middle is.
struct Patch {
  int count = 0;
  double x = 0;
};

Patch patch(const render::Image& image, render::Color color) {
  Patch found;
  for (int y = 0; y < image.size().height; ++y)
    for (int x = 0; x < image.size().width; ++x)
      if (image.pixel(x, y) == color) {
        ++found.count;
        found.x += x;
      }
  found.x /= std::max(1, found.count);
  return found;
}

}  // namespace

TEST_CASE("In a browser the report shows failures first and decoded pictures and swaps them by key or button") {
  if (!browser_is_there()) return;
  Page page;
  page.append(visitor);
  const std::vector<std::string> lines_seen = seen(page.dom());
  const std::vector<std::string> expected{
      "pair 3-different.png",
      "pair 1-within.png",
      "img 300x200 200 0 200 255",  // expected
      "img 300x200 0 160 0 255",    // actual
      "img 300x200 255 255 255 255",
      "img 300x200 200 0 200 255",
      "img 300x200 200 0 201 255",
      "img 300x200 0 0 16 255",
      "apart true",
      "s true true",
      "S true false",
      "ctrl-s true",
      "others true",
      "click true true",
      "one to one 300",
      "resources 0",
  };
  REQUIRE(lines_seen.size() >= expected.size());
  CHECK(std::vector(lines_seen.begin(), lines_seen.begin() + static_cast<std::ptrdiff_t>(expected.size())) == expected);
  CHECK(std::ranges::count(lines_seen, "blocked img-src") == 1);
  CHECK(std::ranges::count(lines_seen, "blocked connect-src") == 1);
}

TEST_CASE("On a screenshot of the report the actual picture is right of the expected one and left of it when swapped") {
  if (!browser_is_there()) return;
  Page page;
  const render::Image before = page.screenshot();
  page.append(swapper);
  const render::Image after = page.screenshot();
  constexpr int pixels = drawn.width * drawn.height;
  CHECK(patch(before, magenta).count == 2 * pixels);  // of 3-different.png, and of 1-within.png
  CHECK(patch(before, green).count == pixels);
  CHECK(patch(before, magenta).x + drawn.width < patch(before, green).x);
  CHECK(patch(after, green).x + drawn.width < patch(after, magenta).x);
  CHECK(patch(after, green).count == pixels);
}
