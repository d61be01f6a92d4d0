#!/usr/bin/python3
"""A page of gjkstep render --page in Firefox: by keys, by its address, and predicted. The other browser, in which all is tried, is
that of in_browser.py.

    /usr/bin/python3 tests/walkthroughs/page/page_in_firefox_test.py build/gjkstep

Firefox is told what to do by its own protocol, Marionette, since Debian has no geckodriver. Where Firefox is missing it says so and
exits with 77.
"""
import json, os, pathlib, shutil, socket, subprocess, sys, tempfile, time, unittest

firefox = shutil.which("firefox-esr") or shutil.which("firefox")
if not firefox:
    print("skipped: no Firefox; install the Debian package firefox-esr")
    sys.exit(77)

program = os.path.abspath(sys.argv[1])
searched = "regions/2-simplex-r3"
left, right, home, end = "\ue012", "\ue014", "\ue011", "\ue010"  # keys, as WebDriver calls them


def until(found, seconds=60):
    """What is found in the end; what is waited for takes a moment."""
    for _ in range(seconds * 20):
        result = found()
        if result:
            return result
        time.sleep(0.05)
    raise AssertionError("waited in vain")


class Firefox:
    """A message is its length, a colon, and JSON: [0, number, command, parameters], answered by [1, number, error, result]."""

    def __init__(self, profile):
        (profile / "user.js").write_text('user_pref("marionette.port", 0);\n')  # any that is free
        self.process = subprocess.Popen([firefox, "--headless", "--marionette", "--no-remote", "--profile", str(profile)],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        port = profile / "MarionetteActivePort"
        until(lambda: port.exists() and port.read_text())
        self.socket = socket.create_connection(("127.0.0.1", int(port.read_text())))
        self.stream, self.count = self.socket.makefile("rb"), 0
        self.receive()  # who it is
        self.send("WebDriver:NewSession")

    def receive(self):
        length = b""
        while (digit := self.stream.read(1)) != b":":
            length += digit
        return json.loads(self.stream.read(int(length)))

    def send(self, command, **parameters):
        self.count += 1
        message = json.dumps([0, self.count, command, parameters]).encode()
        self.socket.sendall(b"%d:%s" % (len(message), message))
        _, _, error, result = self.receive()
        assert error is None, error
        return result

    def js(self, script):
        return self.send("WebDriver:ExecuteScript", script=script, args=[])["value"]

    def press(self, *keys):
        for key in keys:
            actions = [{"type": kind, "value": key} for kind in ("keyDown", "keyUp")]
            self.send("WebDriver:PerformActions", actions=[{"type": "key", "id": "keys", "actions": actions}])

    def quit(self):
        self.send("Marionette:Quit", flags=["eForceQuit"])
        self.process.wait(60)
        self.stream.close()
        self.socket.close()


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        subprocess.run([program, "render", searched, "--page", "--out", str(cls.folder), "--size", "640x360"], check=True,
                       stdout=subprocess.DEVNULL)
        (cls.folder / "profile").mkdir()
        cls.firefox = Firefox(cls.folder / "profile")

    @classmethod
    def tearDownClass(cls):
        cls.firefox.quit()
        shutil.rmtree(cls.folder)

    def open(self, address=""):
        self.firefox.send("WebDriver:Navigate", url="about:blank")
        self.firefox.send("WebDriver:Navigate", url=f"file://{self.folder / searched / 'index.html'}{address}")

    def step(self):
        shown = self.firefox.js("return [...document.querySelectorAll('.step')].filter(step => step.checkVisibility()).map(step => step.id)")
        self.assertEqual(len(shown), 1)
        return int(shown[0])

    def test_keys(self):
        self.open()
        last = self.firefox.js("return document.querySelectorAll('.step').length")
        for key, number in [(right, 2), (right, 3), (left, 2), (end, last), (home, 1)]:
            self.firefox.press(key)
            self.assertEqual(self.step(), number)
        self.assertTrue(self.firefox.js("const img = document.querySelector('.now img'); return img.complete && img.naturalWidth === 640"))

    def test_address(self):
        self.open("#5")
        self.assertEqual(self.step(), 5)
        self.firefox.press(right)
        self.assertEqual(self.firefox.js("return location.hash"), "#6")
        self.firefox.send("WebDriver:Back")
        until(lambda: self.step() == 5)

    def test_predicting(self):
        self.open()
        self.firefox.press("p")
        until(lambda: self.firefox.js("return document.getElementById('predict').getAttribute('aria-pressed') === 'true'"))
        asked = self.firefox.js("return gjkstep.story.questions[0]")
        for _ in range(asked["before"]):
            self.firefox.press(right)
        self.assertEqual(self.step(), asked["before"])
        self.firefox.press(str(2 - asked["right"]))  # the other of two
        self.assertRegex(self.firefox.js("return document.getElementById('verdict').textContent"), "^Not so.*The answer is")
        self.firefox.js("document.getElementById('onward').click()")
        self.assertEqual(self.step(), asked["before"] + 1)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]], verbosity=1)
