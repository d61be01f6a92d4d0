#!/usr/bin/python3
"""Pages in a browser: what comes next, predicted before it is shown.

    /usr/bin/python3 tests/walkthroughs/page/predicting_in_browser_test.py build/gjkstep [NAME-OF-A-TEST...]
"""
import re, sys

sys.dont_write_bytecode = True  # nothing is written into the project
from in_browser import Keys, last, PageInBrowser, render, run, searched


class Page(PageInBrowser):
    def answer_all(self, choose):
        """Presses → until the end and answers each question by its key. Returns how many there were."""
        count, questions = 0, self.questions()
        while self.step() < last:
            self.press(Keys.ARROW_RIGHT)
            while self.find("#quiz").is_displayed():
                at = self.step()
                self.assertEqual(questions[count]["before"], at)
                self.press(str(1 + choose(questions[count])))
                if self.find("#onward").text == "Show the answer":
                    self.find("#onward").click()
                self.assertEqual(len(self.all("#choices .right")), 1)
                self.assertTrue(self.find("#verdict").text)
                count += 1
                self.find("#onward").click()
        return count

    def choose(self, place):
        """In words, which stand folded where the picture can be pressed."""
        self.js("document.getElementById('in-words').open = true")
        self.all("#choices button")[place].click()

    def test_while_a_question_stands_nothing_read_aloud_tells_the_answer(self):
        self.open(searched, "#11")
        self.live()
        name = lambda: self.find("#picture .drawn").accessible_name
        words = name()
        self.predict()
        self.press(Keys.ARROW_RIGHT)
        self.assertTrue(self.find("#quiz").is_displayed())
        self.assertEqual(name(), "The picture; it is told in words once the question is answered.")
        self.assertFalse(any(told.is_displayed() for told in self.all(".made")))
        self.choose(next(q for q in self.questions() if q["before"] == 11)["right"])
        self.assertEqual(name(), words)

    def test_all_predicted_rightly(self):
        self.open(searched)
        self.predict()
        count = self.answer_all(lambda question: question["right"])
        self.assertEqual(count, len(self.questions()))
        self.assertGreater(count, 10)
        self.assertEqual(self.find("#points").text, f"{count} of {count} right")
        self.assertFalse(self.all("#score .no"))
        self.assertNotEqual(self.find("h1").text, "What will the search find?")  # it has been found

    def test_of_two_searches_each_is_asked_about(self):
        render(self.folder / "two", "figure-5", "--page")
        self.browser.get(f"file://{self.folder / 'two' / 'figure-5' / 'index.html'}#2")
        self.predict()
        self.press(Keys.ARROW_RIGHT)
        self.assertEqual(self.find("#question").text, "left: Was the origin crossed?")
        self.press("2")
        self.find("#onward").click()
        self.assertEqual(self.find("#question").text, "right: Was the origin crossed?")
        self.press("1")
        self.find("#onward").click()
        self.assertEqual(self.step(), 3)
        self.assertEqual(self.find("#points").text, "2 of 2 right")

    def test_all_predicted_wrongly_kept_and_forgotten(self):
        self.open(searched)
        self.predict()
        count = self.answer_all(lambda question: 1 if question["right"] == 0 else 0)
        self.assertEqual(self.find("#points").text, f"0 of {count} right")
        self.assertEqual(len(self.all("#score .no")), 4)
        seen = "const box = document.getElementById('score').getBoundingClientRect(); return box.top >= 0 && box.top < innerHeight"
        self.assertTrue(self.js(seen))
        self.assertIn("practise with regions/", self.find("#score").text)
        self.assertIn("gjkstep render regions --page makes these pages.", self.find("#score").text)
        self.browser.refresh()
        self.predict()  # all have been answered
        self.assertTrue(self.find("#forget").is_displayed())
        self.assertIn("who forgets", self.find("#live").get_attribute("textContent"))
        self.press(Keys.END)
        self.assertEqual(self.find("#points").text, f"0 of {count} right")
        self.find("#forget").click()
        self.assertEqual(self.step(), 1)
        self.assertEqual(self.js("return localStorage.length"), 0)

    def test_a_wrong_answer_gets_its_reason(self):
        self.open(searched)
        self.predict()
        question = next(q for q in self.questions() if len(q["choices"]) > 4)
        self.open(searched, f"#{question['before']}")
        self.predict()
        self.press(Keys.ARROW_RIGHT)
        wrong = 1 if question["right"] == 0 else 0
        self.choose(wrong)
        texts = self.js("return gjkstep.story.texts")
        plain = lambda place: re.sub(r"_{(.*?)}|_(.)", r"\1\2", texts[place])
        verdict = self.find("#verdict").get_attribute("textContent")
        hint = plain(question["choices"][wrong][2])
        self.assertEqual(verdict, ("Not so: " + hint if hint else "Not so") + ". Try once more.")
        focused = self.browser.switch_to.active_element
        self.assertEqual(focused, self.all("#choices button")[wrong], "Tab must go on from there")
        focused.send_keys(Keys.ENTER)  # which must not be taken for a second answer
        self.assertIn("Try once more", self.find("#verdict").text)
        self.assertFalse(self.all("#choices .right"))
        another = next(c for c in range(len(question["choices"])) if c not in (wrong, question["right"]))
        self.choose(another)
        wrong = another
        verdict = self.find("#verdict").get_attribute("textContent")
        reasons = [plain(question["choices"][choice][1]) for choice in (wrong, question["right"])]
        self.assertTrue(verdict.startswith("Not so. " if reasons[0] == reasons[1] else "Not so: " + reasons[0]), verdict)
        self.assertEqual(verdict.count(reasons[1]), 1)
        self.assertEqual(self.find("h1").text, "What will the search find?")
        self.assertIn(plain(question["choices"][question["right"]][1]), verdict)

    def test_a_second_try_may_be_right_and_the_first_answer_counts(self):
        self.open(searched)
        self.predict()
        question = next(q for q in self.questions() if len(q["choices"]) > 2)
        self.open(searched, f"#{question['before']}")
        self.predict()
        self.press(Keys.ARROW_RIGHT)
        self.choose(1 if question["right"] == 0 else 0)
        self.choose(question["right"])
        self.assertTrue(self.find("#verdict").text.startswith("Right: "))
        self.assertEqual(self.find("#onward").text, "Go on")
        self.press(Keys.END)
        self.assertTrue(self.find("#points").text.startswith("0 of "))

    def test_which_line_is_wrong(self):
        folder, mistaken = self.folder / "mistakes", "mistakes/m9-abn-inward"
        render(folder, mistaken, "--page")
        self.browser.get(f"file://{folder / mistaken / 'index.html'}")
        self.assertTrue(self.find("#summary").is_displayed())
        self.predict()
        self.assertFalse(self.find("#summary").is_displayed())  # it tells
        self.assertEqual(self.find("h1").text, "Which line is wrong?")
        [question] = self.questions()
        for _ in range(question["before"]):
            self.press(Keys.ARROW_RIGHT)
        self.assertIn("In which line of Algorithm 4 is the mistake? M9: R3:", self.find("#question").text)
        self.assertEqual(len(self.all("#choices button")), len(question["choices"]))
        self.assertEqual(self.find(".now .code h3").text, "the report: Algorithm 1")  # P has joined the simplex
        self.press(str(1 + question["right"]))
        self.assertEqual(len(self.all("#choices .right")), 1)
        self.assertIn("here: ABn ← ABCn×AB", self.find("#verdict").get_attribute("textContent"))
        self.find("#onward").click()
        self.assertEqual(self.step(), question["before"] + 1)
        self.assertIn("ABn of the triangle points inward", self.find(".now h2").text)
        self.assertEqual(self.find(".now .code h3").text, "the report: Algorithm 4")
        self.assertIn("ABn ← AB×ABCn", self.find(".now .code").text)

    def test_a_question_can_be_left_and_keys_be_switched_off(self):
        self.open(searched, "#2")
        self.predict()
        while not self.find("#quiz").is_displayed():
            self.press(Keys.ARROW_RIGHT)
        at = self.step()
        self.press(Keys.ARROW_LEFT)
        self.assertFalse(self.find("#quiz").is_displayed())
        self.assertEqual(self.step(), at)
        self.press(Keys.ARROW_RIGHT)
        self.find("#onward").click()  # Skip
        self.assertEqual(self.step(), at + 1)
        self.predict()
        self.js("document.getElementById('letters').checked = false")
        self.press("p")
        self.assertEqual(self.find("#predict").get_attribute("aria-pressed"), "false")

    def test_who_skips_a_question_gets_the_next_one_about_that_step(self):
        self.open(searched)
        self.predict()
        before = [question["before"] for question in self.questions()]
        at = next(at for at in before if before.count(at) > 1)
        self.open(searched, f"#{at}")
        self.predict()
        self.press(Keys.ARROW_RIGHT)
        for k in range(before.count(at)):
            self.assertEqual(self.step(), at)
            self.assertTrue(self.find("#quiz").is_displayed())
            self.find("#onward").click()
        self.assertEqual(self.step(), at + 1)
        self.press(Keys.ARROW_LEFT, Keys.ARROW_RIGHT)  # a skipped one is asked again
        self.assertTrue(self.find("#quiz").is_displayed())

    def test_nothing_beside_a_question_tells_its_answer(self):
        self.open(searched)
        current = lambda: self.all(".now .code [aria-current]")
        title = self.browser.title
        self.predict()
        self.assertNotIn(title.split(" ", 1)[1], self.browser.title)
        asked = self.questions()[0]["before"]
        self.open(searched, f"#{asked}")
        self.assertEqual(len(current()), 1)
        self.predict()
        self.press(Keys.ARROW_RIGHT)
        self.assertTrue(self.find("#quiz").is_displayed())
        self.assertEqual(current(), [])
        self.assertFalse([b for b in self.all(".now .code b") if b.is_displayed()])
        self.press(Keys.ARROW_LEFT)
        self.assertEqual(len(current()), 1)
        self.predict()
        self.assertIn(title.split(" ", 1)[1], self.browser.title)


if __name__ == "__main__":
    run()
