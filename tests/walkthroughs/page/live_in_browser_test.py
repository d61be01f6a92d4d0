#!/usr/bin/python3
"""Pages in a browser: the program that runs in them, taken hold of as a person would.

    /usr/bin/python3 tests/walkthroughs/page/live_in_browser_test.py build/gjkstep [NAME-OF-A-TEST...]
"""
import base64, json, math, pathlib, shutil, subprocess

from in_browser import *

mistake = "mistakes/m14-order-below-triangle"


class Page(PageInBrowser):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        render(cls.out, "live", mistake, "--page")

    def take(self, name="live", address=""):
        self.open(name, address)
        self.live()

    def grip(self, name):
        return self.find(f'.grip[data-name="{name}"]')

    def drag(self, name, right, down, steps=8, alt=False):
        actions = ActionChains(self.browser, duration=5)
        if alt:
            actions.key_down(Keys.ALT)
        actions.move_to_element(self.grip(name)).click_and_hold()
        for _ in range(steps):
            actions.move_by_offset(right / steps, down / steps)
        actions.perform()
        self.frame_drawn()

    def let_go(self):
        ActionChains(self.browser, duration=5).release().key_up(Keys.ALT).perform()
        self.frame_drawn()

    def frame_drawn(self):
        self.browser.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")

    def answers(self):
        return self.find("#answers").text

    def says(self, name):
        return self.grip(name).get_attribute("aria-label")

    def choose(self, key, text):
        self.js("document.getElementById('switches-box').open = true")
        option = f"#switches [data-key='{key}'] option"
        next(each for each in self.all(option) if each.text.startswith(text)).click()
        self.js("document.getElementById('switches-box').open = false")
        self.frame_drawn()

    # -- Dragging

    def test_a_corner_is_dragged_until_the_answer_turns_and_back(self):
        self.take()
        before = self.says("b.points[0]")
        self.assertEqual(self.answers(), "The search: together · Proven: together")
        self.drag("b.points[0]", 90, 0)
        self.assertEqual(self.answers(), "The search: apart · Proven: apart")  # while it is held
        self.assertTrue(self.js("return document.getElementById('answers').classList.contains('turned')"))
        self.let_go()
        self.assertNotEqual(self.says("b.points[0]"), before)
        self.find("#undo").click()
        self.assertEqual(self.answers(), "The search: together · Proven: together")
        self.assertEqual(self.says("b.points[0]"), before)
        ActionChains(self.browser).key_down(Keys.CONTROL).key_down(Keys.SHIFT).send_keys("z").key_up(Keys.SHIFT).key_up(Keys.CONTROL).perform()
        self.assertEqual(self.answers(), "The search: apart · Proven: apart")
        self.find("#reset").click()
        self.assertEqual(self.says("b.points[0]"), before)

    def test_corners_snap_to_a_grid_unless_one_wants_otherwise(self):
        numbers = lambda: json.loads("[" + self.says("a.points[1]").split("(")[1].rstrip(")") + "]")
        self.take()
        self.drag("a.points[1]", 33, 7)
        self.let_go()
        self.assertTrue(all(abs(5 * x - round(5 * x)) < 1e-9 for x in numbers()), numbers())
        self.drag("a.points[1]", 13, 7, alt=True)
        self.let_go()
        self.assertFalse(all(abs(5 * x - round(5 * x)) < 1e-9 for x in numbers()), numbers())

    def test_while_one_drags_the_same_step_is_shown_and_the_picture_keeps_its_size(self):
        self.take("live", "#8")
        where, place = self.find(".now .where").text, self.grip("a.points[0]").location
        self.assertIn("iteration 2", where)
        self.drag("b", -40, 10)
        self.assertIn("iteration 2", self.find(".now .where").text)
        self.assertEqual(self.grip("a.points[0]").location, place)
        self.let_go()

    def test_an_object_is_moved_as_a_whole(self):
        self.take()
        self.drag("a", -40, 20)
        self.let_go()
        shape = self.js("return [...document.querySelectorAll('.grip')].filter(g => g.dataset.name.startsWith('a.')).map(g => g.grip.at)")
        self.assertEqual(len(shape), 3)
        self.find("#undo").click()
        self.assertEqual(self.says("a.points[0]"), "corner 1 of triangle a: (-3, -1)")

    def test_the_first_direction_is_taken_hold_of(self):
        self.take()
        self.drag("first_direction", -70, -60)
        self.let_go()
        self.assertIn("d = (", self.find(".now .told").text)
        self.assertNotIn("along +x", self.find(".now h2").text)

    # -- Keys

    def test_corners_by_keys_alone(self):
        self.take()
        self.js("document.querySelector('#picture .grip').focus()")
        for _ in range(20):
            if self.js("return document.activeElement.dataset.name") == "a.points[1]":
                break
            self.press(Keys.TAB)
        self.press(Keys.ARROW_RIGHT)
        self.assertEqual(self.js("return document.activeElement.dataset.name"), "a.points[1]")
        self.assertNotEqual(self.says("a.points[1]"), "corner 2 of triangle a: (1, -2)")
        self.assertTrue(self.find("#live").get_attribute("textContent").startswith("corner 2 of triangle a: ("))
        focus = lambda: self.js("return document.activeElement.dataset.name")
        said = lambda: self.find("#live").get_attribute("textContent")
        self.press(Keys.INSERT)
        self.wait(lambda: len(self.all(".grip[data-name^='a.points']")) == 4)
        self.wait(lambda: focus() == "a.points[2]")
        self.assertIn("corner added, now at corner 3 of triangle a: (", said())
        self.press(Keys.DELETE)
        self.wait(lambda: len(self.all(".grip[data-name^='a.points']")) == 3)
        self.assertEqual(focus(), "a.points[2]")
        self.assertEqual(self.step(), 1)  # arrows moved the corner, not the page
        self.find("#undo").click()
        self.wait(lambda: said() == "undone. The search: together · Proven: together")

    def test_the_first_direction_turns_by_keys(self):
        direction = lambda: json.loads("[" + self.says("first_direction").split("(")[1].rstrip(")") + "]")
        self.take()
        self.js("document.querySelector('.grip[data-name=first_direction]').focus()")
        before = direction()
        self.press(Keys.ARROW_UP)
        x, y = direction()
        self.assertAlmostEqual(math.degrees(math.atan2(y, x) - math.atan2(before[1], before[0])), 5, delta=0.1)

    def test_escape_ends_a_drag_as_if_it_had_not_been(self):
        self.take()
        before = self.says("b.points[0]")
        self.drag("b.points[0]", 90, 0)
        self.assertNotEqual(self.says("b.points[0]"), before)
        self.press(Keys.ESCAPE)
        self.let_go()
        self.assertEqual(self.says("b.points[0]"), before)
        self.assertFalse(self.find("#undo").is_enabled())

    # -- Space

    def test_space_is_turned_and_made_larger(self):
        self.take(hit)
        picture = lambda: self.js("return document.querySelector('#picture .drawn').innerHTML")
        before = picture()
        ActionChains(self.browser).move_to_element_with_offset(self.find("#picture"), 150, 120).click_and_hold().move_by_offset(60, 20).release().perform()
        self.frame_drawn()
        turned = picture()
        self.assertNotEqual(turned, before)
        self.js("document.getElementById('picture').dispatchEvent(new WheelEvent('wheel', {deltaY: -200, bubbles: true, cancelable: true}))")
        self.assertNotEqual(picture(), turned)
        self.find("#turn-on").click()
        self.assertEqual(self.step(), 1)
        self.find("#reset").click()
        self.wait(lambda: picture() == before)

    # -- Switches

    def test_other_rules_numbers_and_mistakes(self):
        self.take()
        self.choose("rules", "complete")
        self.assertIn("together", self.answers())
        self.choose("rules", "as-intended")
        self.choose("scalar", "float")
        self.wait(lambda: "in float" in self.find(".now .where").text)
        self.choose("scalar", "double")
        self.choose("mistake", "M9")
        self.wait(lambda: self.find("#picture .drawn").text.startswith("M9"))
        self.assertTrue(self.find("#objects").is_displayed())
        self.assertIn("The mistake: AB", self.answers())
        self.assertRegex(self.answers(), "they part at step [0-9]+|the searches do not part")
        self.choose("rules", "complete")
        self.wait(lambda: "mistake: is made in the report's rules" in self.find("#complaint").text)
        self.drag("a.points[0]", -10, 0)
        self.let_go()
        self.assertIn("M9", self.find("#picture .drawn").text)

    def test_a_mistake_and_where_it_parts(self):
        self.take(mistake)
        self.assertTrue(self.all("#marks .parting"))
        self.assertIn("Proven: ", self.answers())

    # -- Taking along

    def test_a_link_holds_the_scene(self):
        self.take("live", "#4")
        self.drag("b", 120, 0)
        self.let_go()
        self.wait(lambda: self.address().startswith("#scene="))
        said, address, caption = self.says("b.points[0]"), self.js("return location.href"), self.find(".now h2").text
        self.browser.get("about:blank")
        self.browser.get(address)
        self.live()
        self.wait(lambda: self.says("b.points[0]") == said)
        self.assertEqual(self.find(".now h2").text, caption)
        self.assertTrue(self.find("h1").text.startswith("Changed: "))
        self.assertFalse(self.find("#summary").is_displayed())  # which is about what was there

    def drop(self, name, text):
        self.js("""
            const data = new DataTransfer();
            data.items.add(new File([arguments[1]], arguments[0]));
            dispatchEvent(new DragEvent('drop', {dataTransfer: data, bubbles: true, cancelable: true}))""", name, text)

    def test_scenes_and_traces_are_dropped(self):
        self.take()
        self.drop("mine.json", '{"dimension": 2, "a": {"name": "<i>", "points": [[0, 0], [1, 0]]}, "b": {"sphere": {"center": [5, 0], "radius": 1}}}')
        self.wait(lambda: "apart" in self.answers())
        self.assertEqual(len(self.all(".grip[data-name^='a.points']")), 2)
        self.drop("bad.json", '{"dimension": 2,\n"a": {"points": [[0, 0], [1, "x"]]}}')
        self.wait(lambda: self.find("#complaint").is_displayed())
        self.assertEqual(self.find("#complaint").text, "bad.json:2: a.points[1][1]: expected a number, found a string")
        self.assertIn("apart", self.answers())  # what was there stays
        self.drop("much.json", " " * 5000000)
        self.wait(lambda: "5000000" in self.find("#complaint").text)
        self.drop("trace.jsonl", subprocess.run([program, "trace", "figure-4-right"], capture_output=True, text=True, check=True).stdout)
        self.wait(lambda: not self.find("#complaint").is_displayed())

    def test_a_trace_of_two_searches_is_shown_and_left_again(self):
        self.take()
        self.drop("trace.jsonl", subprocess.run([program, "trace", "figure-5"], capture_output=True, text=True, check=True).stdout)
        heading = lambda: self.find("h1").text
        self.wait(lambda: heading().startswith("Figure 5"))
        self.assertNotIn("together", self.find("#live").get_attribute("textContent"))
        self.assertFalse(self.find("#save-scene").is_enabled())
        self.find("#undo").click()
        self.wait(lambda: heading() == "Two triangles to take hold of")
        self.find("#redo").click()
        self.wait(lambda: heading().startswith("Figure 5"))

    def test_a_scene_dropped_onto_a_diagram_can_be_left_again(self):
        self.take("figure-1")
        before = self.find("h1").text
        self.assertFalse(self.find("#taking").is_displayed())
        self.drop("mine.json", '{"dimension": 2, "a": {"points": [[0, 0], [1, 0]]}, "b": {"points": [[5, 0]]}}')
        self.wait(lambda: "apart" in self.answers())
        self.find("#reset").click()
        self.wait(lambda: self.find("h1").text == before)
        self.find("#undo").click()
        self.wait(lambda: "apart" in self.answers())

    def test_questions_go_on_after_a_change(self):
        self.take()
        self.predict()
        self.drag("b", 30, 0)
        self.let_go()
        self.assertEqual(self.find("#predict").get_attribute("aria-pressed"), "true")
        self.press(Keys.HOME)
        self.press(Keys.ARROW_RIGHT)
        self.find("#choices button").click()
        while self.find("#onward").text != "Go on":
            self.find("#onward").click()
        before = self.step()
        self.find("#onward").click()
        self.assertLessEqual(self.step(), before + 1)  # one quiz steps, not one for each story there has been

    def test_a_change_at_the_parting_stays_there(self):
        self.take(mistake, "#15")
        self.drag("b.points[2]", 10, 0)
        self.let_go()
        self.assertIn("two runs part", self.find(".now h2").text)

    def test_on_a_phone_panels_stand_below_each_other(self):
        self.cdp("Emulation.setDeviceMetricsOverride", width=390, height=844, deviceScaleFactor=1, mobile=True)
        self.take("live", "#5")
        box = self.find("#picture").rect
        self.assertGreater(box["height"], 1.2 * box["width"])
        self.assertGreater(self.js("return Math.min(...[...document.querySelectorAll('#picture text')].map(t => t.getBoundingClientRect().height))"), 9)

    def test_while_a_question_stands_one_may_drag(self):
        self.take()
        self.predict()
        for _ in range(8):
            self.press(Keys.ARROW_RIGHT)
        self.assertTrue(self.find("#quiz").is_displayed())
        self.assertFalse(self.find("#answers").is_displayed())
        self.drag("b", 30, 0)
        self.let_go()
        self.assertTrue(self.find(".now h2").text)
        self.press(Keys.HOME)
        self.assertEqual(self.step(), 1)

    def test_a_change_that_changes_nothing_is_none(self):
        self.take()
        self.choose("zero_test", "relative")
        self.wait(lambda: self.find("#undo").is_enabled())
        self.choose("zero_test", "exact")
        self.wait(lambda: not self.find("#reset").is_enabled())

    def test_after_a_change_all_steps_are_printed(self):
        self.take()
        self.drag("b", 120, 0)
        self.let_go()
        text = self.printed()
        self.assertIn("out of reach", text)
        self.press(Keys.ARROW_RIGHT)
        self.assertEqual(self.step(), 2)

    def test_an_address_that_is_pasted_is_read(self):
        self.take()
        self.drag("b", 120, 0)
        self.let_go()
        self.wait(lambda: self.address().startswith("#scene="))
        address = self.address()
        self.take()
        self.js("location.hash = arguments[0]", address)
        self.wait(lambda: "apart" in self.answers())
        self.js("location.hash = '#scene=AAAA&step=1'")
        self.wait(lambda: self.find("#complaint").is_displayed())

    # -- The picture

    def test_what_the_page_draws_is_what_the_program_draws(self):
        """The same marks in the same places: the means of small squares, in which edges and letters count for little."""
        for name, frame in [("live", 8), (hit, 11), (mistake, 12), ("figure-1", 0)]:
            folder = self.folder / "plain"
            subprocess.run([program, "render", name, "--frames", str(frame + 1), "--no-captions", "--out", folder], check=True, stdout=subprocess.DEVNULL)
            png = base64.b64encode((folder / name / "000.png").read_bytes()).decode()
            self.take(name, f"#{frame + 1}")
            worst, mean = self.browser.execute_async_script("""
                const [png, done] = arguments, block = 10;
                const means = async (source, [left, top, width, height]) => {
                    const image = new Image(), canvas = document.createElement('canvas');
                    image.src = source;
                    await image.decode();
                    [canvas.width, canvas.height] = [width, height];
                    const context = canvas.getContext('2d');
                    context.fillStyle = '#fff';
                    context.fillRect(0, 0, width, height);
                    context.drawImage(image, -left, -top);
                    const {data} = context.getImageData(0, 0, width, height), sums = [];
                    for (let y = 0; y < height - height % block; ++y)
                        for (let x = 0; x < width - width % block; ++x)
                            for (let c = 0; c < 3; ++c) {
                                const at = 3 * (Math.floor(y / block) * Math.floor(width / block) + Math.floor(x / block)) + c;
                                sums[at] = (sums[at] ?? 0) + data[4 * (y * width + x) + c] / block ** 2;
                            }
                    return sums;
                };
                (async () => {
                    const {picture, width, height} = gjkstep.drawn(parseInt(location.hash.slice(1)) - 1);
                    const [left, top] = picture.match(/viewBox='(\\S+) (\\S+)/).slice(1).map(Number);
                    const svg = picture.replace('<svg ', `<svg width='${width}' height='${height}' `);
                    const ours = await means('data:image/svg+xml;charset=utf-8,' + encodeURIComponent(svg), [0, 0, width, height]);
                    const theirs = await means('data:image/png;base64,' + png, [left, top, width, height]);
                    const off = [...ours].map((x, i) => Math.abs(x - theirs[i]));
                    done([Math.max(...off), off.reduce((sum, x) => sum + x) / off.length]);
                })()""", png)
            self.assertLess(worst, 45, name)
            self.assertLess(mean, 1.5, name)

    # -- The report of gjkstep judge

    def test_the_report_about_a_program_fits_and_leads_to_pages_that_answer(self):
        said = subprocess.run([program, "judge", "--families", "grid-triangles,touching-face", "--count", "9", "--report", self.out / "judged",
                               "--", "sed", "s/.*/yes/"], stdout=subprocess.DEVNULL)
        self.assertEqual(said.returncode, 1)
        page = self.out / "judged/report.html"
        for width, height in [(1366, 768), (390, 844)]:
            self.look(width, height)
            self.browser.get(f"file://{page}")
            self.assert_fits()
            self.assertTrue(self.all(".shot img"))
            self.find("summary").click()
            self.assert_fits()
            picture = self.find(".shot img")
            self.js("arguments[0].scrollIntoView()", picture)
            self.wait(lambda: self.js("return arguments[0].naturalWidth", picture) == 1280)
        tidy = subprocess.run(["tidy", "-q", "-e", "-utf8", page], capture_output=True, text=True).stderr
        self.assertEqual([line for line in tidy.splitlines() if '"loading"' not in line and '"nonce"' not in line], [])
        self.look(1366, 768)
        self.browser.get(f"file://{page}")
        self.find(".card .shot").click()
        self.live()
        self.assertEqual(self.step(), len(self.all(".step")))
        self.assertEqual(self.answers(), "The search: apart · Proven: apart")
        self.find("nav a").click()
        self.wait(lambda: "not right on" in self.browser.title)

    def test_without_webassembly_the_recorded_pictures_are_there(self):
        self.without_programs()
        self.open("live")
        self.assertTrue(self.find(".now img").is_displayed())
        self.assertFalse(self.find("#stage").is_displayed())

    def test_a_page_that_was_copied_alone_says_what_is_missing(self):
        shutil.copytree(self.out / "live", self.out / "alone/live")
        self.open("alone/live")
        self.wait(lambda: "program.js, which belongs beside this page, is not there" in self.find("#lesson").text)
        self.assertTrue(self.find(".now img").is_displayed())
        [missed] = self.browser.get_log("browser")
        self.assertIn("alone/program.js", missed["message"])


if __name__ == "__main__":
    run()
