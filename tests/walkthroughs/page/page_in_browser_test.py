#!/usr/bin/python3
"""The pages of gjkstep render --page in a real browser, used as a person would: by keys, mouse, finger and address.

    /usr/bin/python3 tests/walkthroughs/page/page_in_browser_test.py build/gjkstep [NAME-OF-A-TEST...]

Debian's python3-selenium and chromium-driver drive Chromium; tidy reads the HTML, pdftotext (poppler-utils) what is printed. Where they
are missing it says so and exits with 77.
"""
import base64, json, os, pathlib, re, shutil, subprocess, sys, tempfile, unittest

try:
    from selenium import webdriver
    from selenium.webdriver import ActionChains
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    print("skipped: no selenium; install the Debian package python3-selenium")
    sys.exit(77)
for tool, package in [("chromedriver", "chromium-driver"), ("tidy", "tidy"), ("pdftotext", "poppler-utils")]:
    if not shutil.which(tool):
        print(f"skipped: no {tool}; install the Debian package {package}")
        sys.exit(77)

program = os.path.abspath(sys.argv[1])
axe = pathlib.Path(program).parent / "npm/node_modules/axe-core/axe.min.js"
searched, hit, apart = "regions/3-simplex-face-adb-edge-ad", "vehicle-and-threat/vehicle-hit", "figure-4"
hostile = "</script><img src=x onerror=\"hacked=1\"><b>&amp;"
last = 28  # step of `searched`

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


def render(folder, *words):
    subprocess.run([program, "render", *words, "--out", str(folder), "--size", "640x360"], check=True, stdout=subprocess.DEVNULL)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.out = cls.folder / "out"
        scene = cls.folder / "mine.json"
        scene.write_text(json.dumps({"dimension": 2, "title": hostile, "a": {"name": hostile[:40], "points": [[0, 0], [2, 0], [2, 2]]},
                                     "b": {"name": "<i>", "points": [[1, 1], [3, 1], [3, 3]]}}))
        render(cls.out, searched, hit, apart, "figure-1", str(scene), "--page")
        options = webdriver.ChromeOptions()
        for option in ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", f"--user-data-dir={cls.folder / 'profile'}"]:
            options.add_argument(option)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        cls.browser = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        cls.requests = set()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        shutil.rmtree(cls.folder)

    def setUp(self):
        self.look(1400, 850)
        self.cdp("Emulation.setScriptExecutionDisabled", value=False)
        self.cdp("Emulation.setEmulatedMedia", media="", features=[])
        self.open("figure-1")
        self.js("localStorage.clear()")

    def tearDown(self):
        for entry in self.browser.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent" and message["params"]["documentURL"].startswith("file:"):
                self.requests.add(message["params"]["request"]["url"])
        outside = [url for url in self.requests if not url.startswith(("file://" + str(self.folder), "data:"))]
        self.assertEqual(outside, [], "a request left the page")
        self.assertEqual([e for e in self.browser.get_log("browser") if e["level"] == "SEVERE"], [])

    # -- What a visitor does and sees

    def cdp(self, command, **parameters):
        return self.browser.execute_cdp_cmd(command, parameters)

    def look(self, width, height):
        self.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600)

    def js(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def open(self, name, address=""):
        self.browser.get("about:blank")
        self.browser.get(f"file://{self.out / name / 'index.html'}{address}")

    def press(self, *keys):
        for key in keys:
            ActionChains(self.browser).send_keys(key).perform()

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def step(self):
        """The number of the step that is shown; nothing else may be."""
        shown, place, slider = self.js("""
            return [[...document.querySelectorAll('.step')].filter(step => step.checkVisibility()).map(step => step.id),
                    document.getElementById('place').textContent, document.getElementById('slider').value]""")
        self.assertEqual(shown, [slider])
        self.assertEqual(place.split(" / ")[0], slider)
        return int(slider)

    def address(self):
        return self.js("return location.hash")

    def wait(self, condition):
        WebDriverWait(self.browser, 30, poll_frequency=0.05).until(lambda _: condition())

    def assert_fits(self):
        self.assertLessEqual(self.js("return document.documentElement.scrollWidth"), self.js("return innerWidth"))

    # -- Step

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
        self.open(searched)
        self.press(Keys.SPACE)
        self.assertEqual(self.find("#play").text, "Pause")
        self.wait(lambda: self.step() == 2)
        self.press(Keys.SPACE)
        self.assertEqual(self.find("#play").text, "Play")
        self.open(searched, f"#{last - 1}")
        self.find("#play").click()
        self.wait(lambda: self.step() == last)
        self.wait(lambda: self.find("#play").text == "Play")

    def test_swiping(self):
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
        self.assertIn("beyond edge AD of face ADB", step.find_element(By.CSS_SELECTOR, ".text > h2").text)
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

    def test_questions_that_were_left_behind_are_missed_in_words(self):
        alone = self.folder / "without-questions"
        shutil.copytree(self.out / searched, alone)
        (alone / "questions.js").unlink()
        self.browser.get(f"file://{alone / 'index.html'}")
        self.press("p")
        self.wait(lambda: "questions.js" in self.find("#live").get_attribute("textContent"))
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

    def test_without_what_scripts_know_of_the_steps_all_stand_below_each_other(self):
        alone = self.folder / "without-steps"
        shutil.copytree(self.out / searched, alone)
        (alone / "steps.js").unlink()
        self.browser.get(f"file://{alone / 'index.html'}")
        self.assertTrue(all(step.is_displayed() for step in self.all(".step")))
        self.assertFalse(self.find(".controls").is_displayed())
        self.browser.get_log("browser")  # which has the missing file

    def test_every_picture_has_words_and_every_control_a_name(self):
        self.open(searched)
        for number in range(1, last + 1):
            self.assertIn("d is (", self.find(".now img").accessible_name)
            self.press(Keys.ARROW_RIGHT)
        self.js("document.querySelector('.help').open = true")
        for control in self.all("button, input, summary, select"):
            name = control.accessible_name if control.is_displayed() else "hidden"
            self.assertTrue(name, control.get_attribute("outerHTML"))

    # -- Predict

    def steps_of(self, name):
        return json.loads((self.out / name / "steps.js").read_text().partition("gjkstepSteps = ")[2].rstrip(";\n"))

    def predict(self):
        """Presses P and waits until what it asks for has come."""
        pressed = self.find("#predict").get_attribute("aria-pressed")
        self.press("p")
        self.wait(lambda: self.find("#predict").get_attribute("aria-pressed") != pressed)

    def questions(self):
        return self.js("return gjkstepQuestions.questions")

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

    def test_while_a_question_stands_nothing_read_aloud_tells_the_answer(self):
        self.open(searched, "#11")
        name = lambda: self.find(".now img").accessible_name
        words = name()
        self.predict()
        self.press(Keys.ARROW_RIGHT)
        self.assertTrue(self.find("#quiz").is_displayed())
        self.assertEqual(name(), "The picture; it is told in words once the question is answered.")
        self.assertFalse(any(told.is_displayed() for told in self.all(".made, #summary")))
        self.all("#choices button")[next(q for q in self.questions() if q["before"] == 11)["right"]].click()
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
        self.all("#choices button")[wrong].click()
        texts = self.js("return gjkstepQuestions.texts")
        plain = lambda place: re.sub("<[^>]*>", "", texts[place]).replace("&gt;", ">")
        verdict = self.find("#verdict").get_attribute("textContent")
        hint = plain(question["choices"][wrong][2])
        self.assertEqual(verdict, ("Not so: " + hint if hint else "Not so") + ". Try once more.")
        focused = self.browser.switch_to.active_element
        self.assertEqual(focused, self.all("#choices button")[wrong], "Tab must go on from there")
        focused.send_keys(Keys.ENTER)  # which must not be taken for a second answer
        self.assertIn("Try once more", self.find("#verdict").text)
        self.assertFalse(self.all("#choices .right"))
        another = next(c for c in range(len(question["choices"])) if c not in (wrong, question["right"]))
        self.all("#choices button")[another].click()
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
        self.all("#choices button")[1 if question["right"] == 0 else 0].click()
        self.all("#choices button")[question["right"]].click()
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

    # -- Everywhere

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
        self.assertEqual(len([card for card in self.all(".card") if card.is_displayed()]), 5)
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

    def printed(self):
        pdf = self.folder / "printed.pdf"
        pdf.write_bytes(base64.b64decode(self.cdp("Page.printToPDF", printBackground=True)["data"]))
        return subprocess.run(["pdftotext", "-layout", str(pdf), "-"], capture_output=True, text=True, check=True).stdout

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

    def test_the_index(self):
        self.open(".")
        cards = lambda: [card.find_element(By.TAG_NAME, "strong").text for card in self.all(".card") if card.is_displayed()]
        self.assertEqual(len(cards()), 5)
        self.press(Keys.TAB, Keys.TAB)  # past the page that compares two, into the search field
        self.press(*"adb ad")
        self.assertEqual(len(cards()), 1)
        self.assertEqual(self.find("#found").text, "1 shown")
        self.press(*[Keys.BACKSPACE] * 6)
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
            numbers = [i + 1 for i, step in enumerate(self.steps_of(name)["steps"]) if step["iteration"] <= iteration]
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
        page = (self.out / searched / "index.html").read_text()
        section = re.search(r'<section class="step" id="2">.*?</section>\n', page, re.DOTALL).group(0)
        data = self.steps_of(searched)
        data["steps"] = [data["steps"][1]] * 10000
        data["questions"] = 0
        many = "".join(section.replace('id="2"', f'id="{i + 1}"') for i in range(10000))
        page = re.sub(r'<div id="steps">.*</div>\n<div class="controls"', lambda _: f'<div id="steps">{many}</div>\n<div class="controls"', page, flags=re.DOTALL)
        page = page.replace('<script src="steps.js">', f'<script type="application/json" id="data">{json.dumps(data)}')
        (self.out / searched / "many.html").write_text(page.replace(f'max="{last}"', 'max="10000"'))
        self.browser.get(f"file://{self.out / searched / 'many.html'}#5000")
        self.press(Keys.ARROW_RIGHT)
        self.assertTrue(self.find("#place").text.startswith("5001"))
        self.press(Keys.END)
        self.assertTrue(self.find("#place").text.startswith("10000"))

    def test_tidy_has_no_complaint(self):
        for name in (f"{searched}/index.html", f"{apart}/index.html", "mine/index.html", "figure-1/index.html", "index.html", "compare.html"):
            said = subprocess.run(["tidy", "-q", "-e", "-utf8", str(self.out / name)], capture_output=True, text=True).stderr
            complaints = [line for line in said.splitlines() if 'proprietary attribute "loading"' not in line]  # which is newer than tidy
            self.assertEqual(complaints, [], name)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *(f"Page.{name}" for name in sys.argv[2:])], verbosity=1)
