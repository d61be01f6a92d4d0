#!/usr/bin/python3
"""The report of gjkstep compare in a browser.

    /usr/bin/python3 tests/walkthroughs/program/report_in_browser_test.py build/gjkstep
"""
import pathlib, subprocess, sys

sys.dont_write_bytecode = True  # nothing is written into the project
here = pathlib.Path(__file__).resolve().parent
sys.path.append(str(here.parent / "page"))
from in_browser import By, Keys, PageInBrowser, program, run

magenta, slightly_other, green = "200,0,200", "200,0,201", "0,160,0"
pictures = {"1-within.png": (magenta, slightly_other), "2-same.png": (magenta, magenta), "3-different.png": (magenta, green)}


class Page(PageInBrowser):
    def write_report(self):
        """Of three pairs, the one that fails last by name."""
        sides = self.folder / "expected", self.folder / "actual"
        for side in sides:
            side.mkdir()
        for name, colors in pictures.items():
            for side, color in zip(sides, colors):
                with open(side / name, "wb") as file:
                    subprocess.run([here.parents[1] / "console/bin/picture", "300x200", color], stdout=file, check=True)
        said = subprocess.run([program, "compare", *sides, "--report", self.out / "report"], stdout=subprocess.DEVNULL)
        self.assertEqual(said.returncode, 1)

    def test_the_report(self):
        self.write_report()
        self.open("report")
        self.assertEqual([title.text for title in self.all("h3")], ["3-different.png", "1-within.png"])
        pixels = self.js("""return [...document.images].map(image => {
                                const canvas = document.createElement('canvas').getContext('2d');
                                canvas.drawImage(image, 0, 0);
                                return image.naturalWidth + ' ' + canvas.getImageData(5, 5, 1, 1).data.slice(0, 3).join(); });""")
        self.assertEqual(pixels, [f"300 {color}" for color in (magenta, green, "255,255,255", magenta, slightly_other, "0,0,16")])

        places = lambda: [self.find(f".fails .{side} img").rect["x"] for side in ("expected", "actual")]
        pressed = lambda: self.find("[data-key=s]").get_attribute("aria-pressed") == "true"
        expected, actual = places()
        self.assertLess(expected, actual)
        self.press("s")
        self.assertEqual((places(), pressed()), ([actual, expected], True))
        self.press("S")
        self.assertEqual((places(), pressed()), ([expected, actual], False))
        self.press('"', Keys.ESCAPE)
        self.js("document.dispatchEvent(new KeyboardEvent('keydown', {key: 's', ctrlKey: true}))")
        self.assertEqual(places(), [expected, actual])
        self.find("[data-key=s]").click()
        self.assertEqual((places(), pressed()), ([actual, expected], True))
        self.press("f")
        self.assertEqual(self.find(".fails .expected img").rect["width"], 300)  # one to one

        blocked = self.browser.execute_async_script("""
            const blocked = [], done = arguments[0];
            document.addEventListener('securitypolicyviolation', event => {
                if (blocked.push(event.effectiveDirective) == 2) done(blocked.sort()); });
            new Image().src = 'http://127.0.0.1:9/picture.png';
            fetch('http://127.0.0.1:9/data').catch(() => {});""")
        self.assertEqual(blocked, ["connect-src", "img-src"])
        for log in ("browser", "performance"):  # which tell of both attempts
            self.browser.get_log(log)


run()
