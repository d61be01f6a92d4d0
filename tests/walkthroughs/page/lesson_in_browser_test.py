#!/usr/bin/python3
"""The lesson in a browser: each screen is done as a person would do it, by mouse and by keys.

    /usr/bin/python3 tests/walkthroughs/page/lesson_in_browser_test.py build/gjkstep [NAME-OF-A-TEST...]
"""
from in_browser import *


class Page(PageInBrowser):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        render(cls.out, "lesson", "--page")

    def begin(self, screen):
        self.open("figure-1")
        self.open("lesson", f"#screen-{screen}")
        self.wait(lambda: self.find("#screen").text.startswith(f"{screen}."))
        self.wait(lambda: self.js("return document.activeElement.id") in ("screen", "question"))
        self.frame_drawn()
        self.assertFalse(self.is_done())

    def frame_drawn(self):
        self.browser.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")

    def is_done(self):
        return self.find("#lesson .done").text.startswith("✓ Done.")

    def button(self, name):
        return next(each for each in self.all("#lesson button") if each.text == name)

    def drag(self, element, right, down, steps=10):
        actions = ActionChains(self.browser, duration=5).move_to_element(element).click_and_hold()
        for _ in range(steps):
            actions.move_by_offset(right / steps, down / steps)
        actions.release().perform()
        self.frame_drawn()

    def drag_grip(self, name, right, down):
        self.drag(self.find(f'.grip[data-name="{name}"]'), right, down)

    def choose(self, key, text):
        self.js("document.getElementById('switches-box').open = true")
        next(each for each in self.all(f"#switches [data-key='{key}'] option") if each.text.startswith(text)).click()
        self.js("document.getElementById('switches-box').open = false")

    def aim(self, name):
        return next(each for each in self.all(".aim") if each.text == name)

    # What does a screen, and on the way what does not.

    def move_b_to_the_left(self):
        self.drag_grip("b", -60, 0)
        self.assertFalse(self.is_done())
        for _ in range(3):
            self.drag_grip("b", -75, 0)

    def draw_toward_the_origin(self):
        self.drag(self.find(".from"), -90, 0)
        self.assertFalse(self.is_done())
        self.drag(self.find(".from"), -40, 80)

    def press_above_then_below(self):
        self.aim("above").click()
        self.assertFalse(self.is_done())
        self.aim("below").click()

    def test_each_screen_is_done(self):
        ways = {1: self.move_b_to_the_left,
                2: lambda: self.drag_grip("b", 75, -75),
                3: lambda: self.drag_grip("first_direction", -60, -80),
                4: self.draw_toward_the_origin,
                5: lambda: self.drag_grip("b", 20, 0),
                6: lambda: self.drag_grip("b", 0, -150),
                7: self.press_above_then_below,
                8: lambda: self.aim("ACD").click(),
                10: lambda: self.choose("rules", "complete"),
                11: lambda: self.choose("scalar", "double")}
        for screen, do in ways.items():
            with self.subTest(screen=screen):
                self.begin(screen)
                do()
                self.wait(self.is_done)
                self.assertTrue(self.find("#lesson [aria-current]").get_attribute("aria-label").endswith("done"))
        self.open("figure-1")
        self.open("lesson")  # goes on where something is left
        self.wait(lambda: self.find("#screen").text.startswith("9."))
        self.assertEqual(len(self.all("#lesson .screens .finished")), len(ways))

    def test_by_keys_alone(self):
        self.begin(4)
        self.js("document.querySelector('.from').focus()")
        for _ in range(8):
            self.press(Keys.ARROW_DOWN)
        self.press(Keys.ENTER)
        self.wait(self.is_done)
        self.begin(7)
        self.assertEqual(self.js("return document.activeElement.id"), "question")
        self.press(str(1 + [each.text for each in self.all(".aim")].index("below")))
        self.wait(self.is_done)
        self.begin(1)
        self.js("document.querySelector('.grip[data-name=\"b\"]').focus()")
        for _ in range(5):
            ActionChains(self.browser).key_down(Keys.SHIFT).send_keys(Keys.ARROW_LEFT).key_up(Keys.SHIFT).perform()
            self.frame_drawn()
        self.wait(self.is_done)

    def test_hints_and_the_way_on(self):
        self.begin(2)
        self.assertNotIn("Hint:", self.find("#lesson").text)
        self.button("Hint").click()
        self.assertIn("Hint:", self.find("#lesson").text)
        self.button("Next →").click()
        self.wait(lambda: self.find("#screen").text.startswith("3."))
        self.assertEqual(self.address(), "#screen-3")
        self.browser.back()
        self.wait(lambda: self.find("#screen").text.startswith("2."))

    def test_begins_again_after_a_question_was_passed(self):
        self.begin(7)
        for _ in range(3):
            self.press(Keys.ARROW_RIGHT)
            self.find("#onward").click() if self.find("#onward").is_displayed() else None
        self.wait(lambda: not self.all(".aim"))
        self.button("Begin again").click()
        self.wait(lambda: self.all(".aim"))
        self.aim("below").click()
        self.wait(self.is_done)

    def test_a_scene_of_ones_own_belongs_to_the_last_screen(self):
        self.begin(3)
        (self.out / "own.json").write_text('{"a": {"points": [[0, 0], [1, 0]]}, "b": {"points": [[0, 1], [3, 1]]}}')
        self.find("#open-file").send_keys(str(self.out / "own.json"))
        self.wait(lambda: self.find("#screen").text.startswith("12."))
        self.assertIn("apart", self.find("#answers").text)
        link = self.browser.execute_async_script("packed({a: {points: [[0, 0]]}, b: {points: [[0, 0]]}, dimension: 2}).then(arguments[0])")
        self.open("figure-1")
        self.open("lesson", f"#scene={link}&step=1")
        self.wait(lambda: self.find("#screen").text.startswith("12."))
        self.wait(lambda: "together" in self.find("#answers").text)

    def test_screens_fit(self):
        for width, height in [(1366, 768), (390, 844)]:
            self.look(width, height)
            for screen in (1, 4, 7, 8, 10):
                self.begin(screen)
                self.assert_fits()


run()
