#!/usr/bin/python3
"""Pages in a browser: for all who read them, on a phone, in the dark, printed, read aloud and without scripts.

    /usr/bin/python3 tests/walkthroughs/page/reading_in_browser_test.py build/gjkstep [NAME-OF-A-TEST...]
"""
import re, subprocess, sys, unittest

sys.dont_write_bytecode = True  # nothing is written into the project
from in_browser import apart, axe, By, hostile, Keys, last, PageInBrowser, run, searched

# The contrast of each text with what is behind it, by WCAG 2; the smallest comes first.
contrasts = """
const channel = c => (c /= 255) <= .04045 ? c / 12.92 : ((c + .055) / 1.055) ** 2.4;
const light = ([r, g, b]) => .2126 * channel(r) + .7152 * channel(g) + .0722 * channel(b);
const numbers = color => color.match(/[\\d.]+/g).map(Number);
const behind = e => { for (; e; e = e.parentElement) { const c = numbers(getComputedStyle(e).backgroundColor); if (c.length < 4 || c[3] > 0) return c; }
                      return matchMedia('(prefers-color-scheme: dark)').matches ? [18, 18, 18] : [255, 255, 255]; };
const found = [];
const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
while (walker.nextNode()) {
  const e = walker.currentNode.parentElement;
  if (!walker.currentNode.data.trim() || !e.checkVisibility() || e.closest('script, button:disabled')) continue;
  const [a, b] = [light(numbers(getComputedStyle(e).color)), light(behind(e))];
  found.push([(Math.max(a, b) + .05) / (Math.min(a, b) + .05), e.outerHTML.slice(0, 100)]);
}
return found.sort((a, b) => a[0] - b[0]);
"""


class Page(PageInBrowser):
    def test_without_scripts_all_steps_stand_below_each_other(self):
        self.cdp("Emulation.setScriptExecutionDisabled", value=True)
        self.open(searched)
        steps = self.all(".step")
        self.assertEqual(len(steps), last)
        for step in steps:
            self.assertTrue(step.is_displayed())
            self.assertTrue(step.find_element(By.TAG_NAME, "h2").text)
        self.assertFalse(self.find(".controls").is_displayed())
        self.browser.get(f"file://{self.out / 'index.html'}")
        self.assertEqual(len([page for page in self.all("#cards a") if page.is_displayed()]), 5)
        self.assertFalse(self.find("#filters").is_displayed())

    def test_on_a_phone_and_magnified_nothing_is_cut_off(self):
        for width in (390, 320, 700):
            self.look(width, 800)
            for name in (searched, apart, "mine", "."):
                self.open(name)
                self.assert_fits()
                for control in self.all("button, summary, select"):
                    if control.is_displayed():
                        self.assertGreaterEqual(min(control.size.values()), 24, control.get_attribute("outerHTML"))

    def test_contrast_in_light_and_dark(self):
        for scheme in ("light", "dark"):
            self.cdp("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            for name, address in [(searched, "#23"), (searched, f"#{last}"), (".", "")]:
                self.open(name, address)
                if name == searched:
                    self.predict()
                found = self.js(contrasts)
                self.assertGreater(len(found), 10)
                self.assertGreaterEqual(found[0][0], 4.5, f"{scheme}: {found[0]}")
            background = self.js("return getComputedStyle(document.body).backgroundColor")
            self.assertEqual(background, "rgb(255, 255, 255)" if scheme == "light" else "rgb(22, 25, 31)")

    def assert_axe_finds_nothing(self):
        self.js(axe.read_text())
        found = self.browser.execute_async_script("""
            const done = arguments[0];
            axe.run(document, {iframes: false, preload: false, resultTypes: ['violations']}).then(({passes, violations}) => done(
              passes.length ? violations.map(each => `${each.id}: ${each.help}: ${each.nodes.map(node => node.html)}`) : 'nothing looked at'))""")
        self.assertEqual(found, [])

    @unittest.skipUnless(axe.exists(), f"no {axe}; tests/run.sh installs it where npm is there")
    def test_axe_finds_no_barrier(self):
        def compare():
            self.browser.get(f"file://{self.out / 'compare.html'}")
        def ask():
            self.open(searched, "#11")
            self.predict()
            self.press(Keys.ARROW_RIGHT)
            self.assertTrue(self.find("#quiz").is_displayed())
        def answer_wrongly():
            ask()
            question = next(q for q in self.questions() if q["before"] == 11)
            self.press("1" if question["right"] else "2")
            self.assertIn("Not so", self.find("#verdict").text)
        places = [lambda: self.open("."), lambda: self.open(searched, "#23"), ask, answer_wrongly, compare,
                  lambda: self.open("figure-1")]
        for width, scheme in [(1400, "light"), (1400, "dark"), (390, "light")]:
            self.look(width, 850)
            self.cdp("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            for number, place in enumerate(places):
                with self.subTest(width=width, scheme=scheme, place=number):
                    self.js("localStorage.clear()")
                    place()
                    self.assert_axe_finds_nothing()

    def test_printed_all_steps_are_there(self):
        self.open(searched, "#3")
        text = self.printed()
        for number in range(1, last + 1):
            self.assertIn(f"Step {number} of {last} ", text)
        self.assertNotIn("Predict", text)
        self.assertNotIn("Handout", text)

    def test_printed_as_a_sheet_or_a_strip_as_one_chooses(self):
        def pages():
            said = subprocess.run(["pdfinfo", str(self.folder / "printed.pdf")], capture_output=True, text=True, check=True).stdout
            return int(re.search(r"Pages:\s*(\d+)", said).group(1))
        self.open(searched)
        fact, caption = "ruled out when the search kept BCD", "P joins the simplex"
        self.assertIn(fact, self.printed())
        of_sheet = pages()
        self.assertIn(of_sheet, range(last // 2 - 2, last // 2 + 6))
        self.find("#handout").send_keys("strip")  # by its first letters
        self.find("#handout").send_keys(Keys.ARROW_DOWN)
        self.assertEqual((self.step(), self.find("#handout").get_attribute("value")), (1, "strip"))
        text = self.printed()
        self.assertIn(caption, text)
        self.assertNotIn(fact, text)
        for number in range(1, last + 1):
            self.assertIn(f"Step {number} of {last} ", text)
        self.assertLess(3 * pages(), of_sheet)
        self.js("window.print = () => { printed = true; }")
        self.find("#handout").send_keys(Keys.TAB)
        self.browser.switch_to.active_element.send_keys(Keys.ENTER)
        self.assertTrue(self.js("return window.printed"))

    def test_texts_of_others_are_text(self):
        for name in ("mine", "."):
            self.open(name)
            self.assertIn(hostile, self.find("body").text if name == "." else self.find("h1").text)
            self.assertIsNone(self.js("return window.hacked"))
        self.open("mine")
        while int(self.find("#place").text.split(" ")[0]) < len(self.all(".step")):
            self.press(Keys.ARROW_RIGHT)
        self.assertIsNone(self.js("return window.hacked"))

    def test_tidy_has_no_complaint(self):
        for name in (f"{searched}/index.html", f"{apart}/index.html", "mine/index.html", "figure-1/index.html", "index.html", "compare.html"):
            said = subprocess.run(["tidy", "-q", "-e", "-utf8", str(self.out / name)], capture_output=True, text=True).stderr
            newer = 'proprietary attribute "loading"', 'proprietary attribute "nonce"'  # than tidy
            complaints = [line for line in said.splitlines() if not any(word in line for word in newer)]
            self.assertEqual(complaints, [], name)


if __name__ == "__main__":
    run()
