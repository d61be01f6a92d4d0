#!/usr/bin/python3
"""The pages over pages in a browser: the index, and the page on which two searches step together.

    /usr/bin/python3 tests/walkthroughs/page/index_in_browser_test.py build/gjkstep [NAME-OF-A-TEST...]
"""
import sys

sys.dont_write_bytecode = True  # nothing is written into the project
from in_browser import apart, By, hit, Keys, PageInBrowser, run, searched


class Page(PageInBrowser):
    def test_the_index(self):
        self.open(".")
        cards = lambda: [card.find_element(By.TAG_NAME, "strong").text for card in self.all(".card") if card.is_displayed()]
        self.assertEqual(len(cards()), 5)
        self.press(Keys.TAB, Keys.TAB)  # past the page that compares two, into the search field
        self.press(*"adb-edge-ad")
        self.assertEqual(len(cards()), 1)
        self.assertEqual(self.find("#found").text, "1 shown")
        self.press(*[Keys.BACKSPACE] * 11)
        self.press(Keys.TAB, "i")  # the answer: intersecting
        self.assertEqual(len(cards()), 3)
        self.press(Keys.TAB, Keys.TAB, Keys.ENTER)
        self.wait(lambda: self.all("#slider"))
        self.browser.back()
        self.wait(lambda: self.all(".card"))
        self.wait(lambda: len(cards()) == 3)  # what was looked for is still there
        self.browser.get(f"file://{self.out / 'index.html'}#words=tetrahedron+regions")  # of a heading
        self.browser.refresh()
        self.wait(lambda: 0 < len(cards()) < 5)
        self.browser.get(f"file://{self.out / 'index.html'}#words=figure+4")  # a number is whole, and not that of the report
        self.browser.refresh()
        self.wait(lambda: len(cards()) == 1)
        self.browser.get(f"file://{self.out / 'index.html'}#words=nowhere")
        self.browser.refresh()
        self.wait(lambda: self.find("#found").text.startswith("none fits"))
        self.browser.get(f"file://{self.out / 'index.html'}#words=EPA")  # which GJK is often asked together with
        self.browser.refresh()
        self.wait(lambda: self.find("#found").text == "nothing about “epa”: gjkstep decides whether objects intersect, not how deep")
        for words in ("support+point", "voronoi", "separating+axis"):  # of captions, and as others call it
            self.browser.get(f"file://{self.out / 'index.html'}#words={words}")
            self.browser.refresh()
            self.wait(lambda: len(cards()) >= 1)
        self.browser.get(f"file://{self.out / 'index.html'}")
        self.browser.refresh()
        self.wait(lambda: len(cards()) == 5)
        self.press(Keys.TAB, Keys.TAB, Keys.TAB, Keys.TAB, "i")  # of the parts that in space
        self.wait(lambda: len(cards()) == 1)
        self.assertIn("part=In+space", self.browser.current_url)
        self.browser.refresh()
        self.wait(lambda: len(cards()) == 1)

    def test_two_searches_step_together(self):
        self.browser.get(f"file://{self.out / 'compare.html'}#{hit},{searched},2")
        shown = {}

        def steps():
            for frame in self.all("iframe"):
                title = frame.get_attribute("title")
                self.browser.switch_to.frame(frame)
                shown[title] = self.js("return [document.querySelector('.now h2')?.textContent, location.hash]")
                self.browser.switch_to.default_content()
            return [shown["Left walkthrough"][1], shown["Right walkthrough"][1]]

        def end(name, iteration):
            numbers = [i + 1 for i, step in enumerate(self.frames_of(name)) if step["iterations"][0] <= iteration]
            return f"#{numbers[-1]}&bare"

        self.wait(lambda: steps() == [end(hit, 2), end(searched, 2)])
        self.press(Keys.ARROW_RIGHT)
        self.wait(lambda: steps() == [end(hit, 3), end(searched, 3)])
        self.assertEqual(self.address(), f"#{hit},{searched},3")
        self.assertEqual(self.printed().count("Step "), 2)  # the pair that is shown
        self.find("#last").click()
        self.wait(lambda: steps() == [end(hit, 9), end(searched, 9)])  # where each has ended, though one has fewer
        self.browser.switch_to.frame(self.all("iframe")[1])
        self.find(".now h2").click()
        self.press(Keys.HOME)  # pressed in one walkthrough, it moves both
        self.browser.switch_to.default_content()
        self.wait(lambda: steps() == [end(hit, 1), end(searched, 1)])
        self.press(Keys.SPACE)
        self.assertEqual(self.find("#play").text, "Pause")
        self.wait(lambda: steps() == [end(hit, 2), end(searched, 2)])
        self.press(Keys.SPACE)
        self.assertEqual(self.find("#play").text, "Play")
        self.press(Keys.ARROW_LEFT)
        self.find("#left").send_keys("Figure 4")
        self.wait(lambda: steps() == [end(apart, 1), end(searched, 1)])


if __name__ == "__main__":
    run()
