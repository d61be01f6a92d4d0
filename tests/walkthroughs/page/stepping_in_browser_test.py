#!/usr/bin/python3
"""Pages in a browser: stepped through by keys, mouse, finger and address; what was left behind, or is alone.

    /usr/bin/python3 tests/walkthroughs/page/stepping_in_browser_test.py build/gjkstep [NAME-OF-A-TEST...]
"""
import json, shutil, sys

sys.dont_write_bytecode = True  # nothing is written into the project
from in_browser import ActionChains, apart, By, hit, Keys, last, PageInBrowser, render, run, searched


class Page(PageInBrowser):
    def test_keys(self):
        self.open(searched)
        self.assertEqual(self.step(), 1)
        for key, number in [(Keys.ARROW_RIGHT, 2), (Keys.ARROW_RIGHT, 3), (Keys.ARROW_LEFT, 2), (Keys.END, last), (Keys.ARROW_RIGHT, last),
                            (Keys.HOME, 1), (Keys.ARROW_LEFT, 1)]:
            self.press(key)
            self.assertEqual(self.step(), number)

    def test_buttons(self):
        self.open(searched)
        for button, number in [("next", 2), ("next", 3), ("back", 2), ("last", last), ("first", 1)]:
            self.find("#" + button).click()
            self.assertEqual(self.step(), number)
        self.assertFalse(self.find("#back").is_enabled())
        self.press(Keys.END)
        self.assertFalse(self.find("#next").is_enabled())

    def test_addresses_and_the_back_button(self):
        self.open(searched, "#17")
        self.assertEqual(self.step(), 17)
        self.press(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT)
        self.assertEqual((self.step(), self.address()), (19, "#19"))
        self.browser.back()
        self.assertEqual((self.step(), self.address()), (18, "#18"))
        self.browser.back()
        self.assertEqual(self.step(), 17)
        self.browser.forward()
        self.assertEqual(self.step(), 18)
        self.js("location.hash = '#5'")
        self.wait(lambda: self.step() == 5)
        self.assertEqual(self.js("return scrollY"), 0)
        for address, number in [("#0", 1), ("#999", last), ("#nonsense", 1), ("#-3", 1)]:
            self.open(searched, address)
            self.assertEqual(self.step(), number)

    def test_slider_with_marks(self):
        self.open(searched)
        self.js("arguments[0].focus()", self.find("#slider"))
        self.press(Keys.ARROW_RIGHT)
        self.assertEqual(self.step(), 2)
        slider = self.find("#slider")
        ActionChains(self.browser).move_to_element(slider).click().perform()
        self.assertEqual((self.step(), self.address()), (self.step(), f"#{self.step()}"))
        self.assertIn(self.step(), (last // 2, last // 2 + 1))
        self.assertIn("iteration", slider.get_attribute("aria-valuetext"))
        self.assertEqual(len(self.all("#marks .iteration")), 5)
        self.assertEqual(len(self.all("#marks .end")), 1)
        self.assertGreater(len(self.all("#marks .decision")), 5)
        tops = lambda kind: self.js("""
            return [...document.querySelectorAll(arguments[0])].map(mark => {
              const text = document.createRange();
              text.selectNodeContents(mark);
              return mark.firstChild ? text.getBoundingClientRect().top : mark.getBoundingClientRect().bottom; })""", kind)
        self.assertGreater(min(tops("#marks .iteration")), max(tops("#marks .decision, #marks .end")) - 1, "a mark over a number")

    def test_playing_and_pausing(self):
        hurry = "const wait = setTimeout; setTimeout = act => { setTimeout = wait; wait(act) }"  # nobody reads the first picture
        self.open(searched)
        self.js(hurry)
        self.press(Keys.SPACE)
        self.assertEqual(self.find("#play").text, "Pause")
        self.wait(lambda: self.step() == 2)
        self.press(Keys.SPACE)
        self.assertEqual(self.find("#play").text, "Play")
        self.open(searched, f"#{last - 1}")
        self.js(hurry)
        self.find("#play").click()
        self.wait(lambda: self.step() == last)
        self.wait(lambda: self.find("#play").text == "Play")

    def test_swiping(self):
        self.without_programs()
        self.look(390, 844)
        self.open(searched, "#3")
        for way, number in [(-120, 4), (-120, 5), (120, 4), (20, 4)]:
            shot = self.find(".step.now .shot")
            ActionChains(self.browser).click_and_hold(shot).move_by_offset(way, 4).release().perform()
            self.assertEqual(self.step(), number)

    def test_pictures_nearby_are_loaded_ahead(self):
        self.open(searched)
        is_loaded = "const img = document.getElementById(arguments[0]).querySelector('img'); return img.complete && img.naturalWidth > 0"
        self.wait(lambda: self.js(is_loaded, 3))
        self.assertFalse(self.js(is_loaded, last))
        self.press(Keys.END)
        self.wait(lambda: self.js(is_loaded, last))

    def test_turning(self):
        self.without_programs()
        folder = self.folder / "turned"
        render(folder, hit, "--page", "--turn", "3")
        self.browser.get(f"file://{folder / hit / 'index.html'}#2")
        shot = self.find(".step.now .shot")
        picture = lambda: self.find(".step.now img").get_attribute("src").rsplit("/")[-1]
        quarter = shot.size["width"] // 4
        ActionChains(self.browser).click_and_hold(shot).move_by_offset(quarter, 0).release().perform()
        self.assertEqual(picture(), "001-turn-1.png")
        ActionChains(self.browser).click_and_hold(shot).move_by_offset(-2 * quarter, 0).release().perform()
        self.assertEqual(picture(), "001-turn-3.png")
        self.assertEqual(self.step(), 2)

    # -- Read

    def test_turning_by_keys_and_buttons(self):
        self.without_programs()
        out = self.folder / "turned-by-keys"
        render(out, hit, "--page", "--turn", "3")
        self.browser.get(f"file://{out / hit / 'index.html'}")
        usual = self.find(".now img").get_attribute("src")
        views = [usual]
        for _ in range(4):
            self.find("#turn-on").click()
            views.append(self.find(".now img").get_attribute("src"))
        self.assertEqual(len(set(views)), 4)
        self.assertEqual(views[4], usual)
        self.find("#turn-back").click()
        self.assertEqual(self.find(".now img").get_attribute("src"), views[3])
        self.assertEqual(self.find("#live").get_attribute("textContent"), "View 4 of 4")
        ActionChains(self.browser).key_down(Keys.SHIFT).send_keys(Keys.ARROW_RIGHT).key_up(Keys.SHIFT).perform()
        self.assertEqual(self.find(".now img").get_attribute("src"), usual)
        self.assertEqual(self.step(), 1)
        self.look(390, 844)
        rows = {button.location["y"] for button in self.all(".buttons button") if button.is_displayed()}
        self.assertEqual(len(rows), 1, "the controls wrap")
        self.look(1400, 850)
        self.open(hit)  # without further views
        self.assertFalse(self.find("#turn-on").is_displayed())
        ActionChains(self.browser).key_down(Keys.SHIFT).send_keys(Keys.ARROW_RIGHT).key_up(Keys.SHIFT).perform()
        self.assertEqual(self.step(), 2)

    def test_what_is_said_is_text(self):
        self.open(searched, "#23")
        step = self.find(".step.now")
        self.assertIn("the origin lies beyond edge AD", step.find_element(By.CSS_SELECTOR, ".told > h2").text)
        self.assertIn("ruled out when the search kept BCD", step.text)
        current = step.find_elements(By.CSS_SELECTOR, ".code [aria-current]")
        self.assertEqual(len(current), 1)
        self.assertIn("AO > 0", current[0].text)
        self.assertIn("= 40 ✓", current[0].text)
        self.press(Keys.ARROW_RIGHT)
        self.assertIn(self.find(".step.now h2").text.rstrip("."), self.find("#live").get_attribute("textContent"))

    def test_events_on_demand(self):
        self.open(apart, "#2")
        details = self.find(".step.now .events")
        self.assertFalse(details.find_elements(By.TAG_NAME, "pre"))
        details.find_element(By.TAG_NAME, "summary").click()
        self.wait(lambda: details.find_elements(By.TAG_NAME, "pre"))
        events = [json.loads(line) for line in details.find_element(By.TAG_NAME, "pre").text.splitlines()]
        self.assertEqual({event["scene"] for event in events}, {"left", "right"})
        traced = [json.loads(line) for line in (self.out / apart / "trace.jsonl").read_text().splitlines()]
        for event in events:
            self.assertIn(event, traced)

    def test_events_that_were_left_behind_are_missed_in_words(self):
        alone = self.folder / "without-events"
        shutil.copytree(self.out / apart, alone)
        (alone / "events.js").unlink()
        self.browser.get(f"file://{alone / 'index.html'}")
        self.find(".step.now .events summary").click()
        self.wait(lambda: "events.js" in self.find(".step.now .events pre").text)
        self.browser.get_log("browser")  # which has the missing file

    def test_who_asks_and_was_left_behind_is_missed_in_words(self):
        alone = self.folder / "without-quiz"
        shutil.copytree(self.out / searched, alone)
        (alone / "quiz.js").unlink()
        self.browser.get(f"file://{alone / 'index.html'}")
        self.press("p")
        self.wait(lambda: "quiz.js" in self.find("#live").get_attribute("textContent"))
        self.assertEqual(self.find("#predict").get_attribute("aria-pressed"), "false")
        self.press(Keys.ARROW_RIGHT)
        self.assertEqual(self.step(), 2)
        self.browser.get_log("browser")  # which has the missing file

    def test_where_steps_are_left_out_the_page_says_that_there_is_nothing_to_predict(self):
        out = self.folder / "chosen"
        render(out, "regions/2-simplex-r3", "--page", "--frames", "regions,end")
        self.browser.get(f"file://{out / 'regions/2-simplex-r3' / 'index.html'}")
        self.assertFalse(self.find("#predict").is_displayed())
        self.assertIn("Nothing can be predicted here", self.find("#unasked").text)
        self.open(searched)
        self.assertFalse(self.find("#unasked").is_displayed())

    def test_without_the_story_all_steps_stand_below_each_other(self):
        alone = self.folder / "without-story"
        shutil.copytree(self.out / searched, alone)
        (alone / "story.js").unlink()
        self.browser.get(f"file://{alone / 'index.html'}")
        self.assertTrue(all(step.is_displayed() for step in self.all(".step")))
        self.assertFalse(self.find(".controls").is_displayed())
        self.browser.get_log("browser")  # which has the missing file

    def test_every_picture_has_words_and_every_control_a_name(self):
        self.open(searched)
        self.live()
        for number in range(1, last + 1):
            self.assertIn("d is (", self.find("#picture .drawn").accessible_name)
            self.press(Keys.ARROW_RIGHT)
        self.js("document.querySelector('.help').open = true")
        for control in self.all("button, input, summary, select"):
            name = control.accessible_name if control.is_displayed() else "hidden"
            self.assertTrue(name, control.get_attribute("outerHTML"))

    def test_on_a_low_screen_the_line_that_runs_stays_in_sight_with_the_picture(self):
        def assert_in_sight(number):
            line, bar, picture = self.js("""
                const box = selector => document.querySelector(selector)?.getBoundingClientRect();
                return [box('.now .code [aria-current]')?.bottom ?? 0, box('.controls').top, box('.now .shot').top]""")
            self.assertLessEqual(line, bar, number)
            self.assertGreaterEqual(picture, 0, number)
        self.look(1366, 768)
        self.open(searched)
        for number in range(1, last + 1):
            assert_in_sight(number)
            self.press(Keys.ARROW_RIGHT)
        self.open(searched, "#23")
        assert_in_sight("opened at step 23")

    def test_the_graph_of_progress_keeps_its_place_in_sight_from_step_to_step(self):
        def assert_graphs_stay(size):
            places, told = set(), []
            for number in range(1, last + 1):
                x, y, width, height, bottom, words = self.js("""
                    const graph = document.querySelector('.progress'), {x, y, width, height} = graph.firstChild.getBoundingClientRect();
                    const picture = document.querySelector('.live #stage, .now .seen').getBoundingClientRect();
                    return [x, y - picture.y, width, height, y + height, graph.textContent]""")
                places.add((x, y, width, height))
                told.append(words)
                if size[0] > 900:
                    self.assertLessEqual(bottom, self.js("return document.querySelector('.controls').getBoundingClientRect().top"))
                self.press(Keys.ARROW_RIGHT)
            self.assert_fits()
            self.assertEqual(len(self.all(".progress")), 1)
            self.assertIn("There is no simplex so far.", told[0])
            self.assertIn("After iteration 5 the kept simplex is 0.917663 from the origin.", told[-1])
            if size[0] > 900:
                self.assertEqual(len(places), 1, places)

        for size in [(1366, 768), (390, 844)]:
            self.look(*size)
            self.open(searched)
            self.live()
            assert_graphs_stay(size)
        self.without_programs()
        self.look(1366, 768)
        self.open(searched)
        assert_graphs_stay((1366, 768))
        self.open("figure-1")
        self.assertFalse(self.find(".progress").is_displayed())
        self.open(apart)
        self.assertIn("Left: ", self.find(".progress").text)

    def test_while_a_question_is_asked_no_graph_answers_it(self):
        self.open(searched)
        self.live()
        self.predict()
        self.wait(lambda: self.press(Keys.ARROW_RIGHT) or self.all(".asking"))
        self.assertEqual(self.js("return getComputedStyle(document.querySelector('.progress')).visibility"), "hidden")
        self.predict()
        self.assertEqual(self.js("return getComputedStyle(document.querySelector('.progress')).visibility"), "visible")

    def test_a_single_file_stands_alone(self):
        folder = self.folder / "single"
        render(folder, "figure-4-left", "--page=single")
        alone = self.folder / "alone.html"
        shutil.copy(folder / "figure-4-left" / "index.html", alone)
        shutil.rmtree(folder)
        self.browser.get(f"file://{alone}")
        self.wait(lambda: self.js("const img = document.querySelector('.now img'); return img.complete && img.naturalWidth === 640"))
        self.press(Keys.END)
        self.assertEqual(self.step(), len(self.all(".step")))
        self.find(".step.now .events summary").click()
        self.wait(lambda: self.all(".step.now .events pre"))
        self.assertEqual(json.loads(self.find(".step.now .events pre").text.splitlines()[-1])["event"], "finished")
        self.press(Keys.HOME)
        self.predict()
        while not self.find("#quiz").is_displayed():
            self.press(Keys.ARROW_RIGHT)
        self.press("1")
        self.assertTrue(self.find("#verdict").text)

    def test_ten_thousand_steps(self):
        self.without_programs()
        many = self.folder / "many"
        shutil.copytree(self.out / searched, many)
        with (many / "story.js").open("a") as script:
            script.write("gjkstep.story.frames = Array(10000).fill(gjkstep.story.frames[1]); gjkstep.story.questions = [];\n")
        self.browser.get(f"file://{many / 'index.html'}#5000")
        self.press(Keys.ARROW_RIGHT)
        self.assertTrue(self.find("#place").text.startswith("5001"))
        self.press(Keys.END)
        self.assertTrue(self.find("#place").text.startswith("10000"))


if __name__ == "__main__":
    run()
