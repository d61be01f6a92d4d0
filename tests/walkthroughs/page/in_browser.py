"""Pages of gjkstep render --page in a real browser, used as a person would: what the tests of this folder share.

Debian's python3-selenium and chromium-driver drive Chromium; tidy reads the HTML, pdftotext (poppler-utils) what is printed. Where they
are missing it says so and exits with 77.
"""
import base64, json, os, pathlib, shutil, subprocess, sys, tempfile, unittest

try:
    from selenium import webdriver
    from selenium.common.exceptions import StaleElementReferenceException
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


def render(folder, *words):
    subprocess.run([program, "render", *words, "--out", str(folder), "--size", "640x360"], check=True, stdout=subprocess.DEVNULL)


class PageInBrowser(unittest.TestCase):
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
        # A page that was moved looks for the program where it was.
        ours = ("file://" + str(self.folder), "data:", "file://" + str(self.folder.parent / "program.js"))
        outside = [url for url in self.requests if not url.startswith(ours)]
        self.assertEqual(outside, [], "a request left the page")
        self.assertEqual([e for e in self.browser.get_log("browser") if e["level"] == "SEVERE"], [])

    # -- What a visitor does and sees

    def cdp(self, command, **parameters):
        return self.browser.execute_cdp_cmd(command, parameters)

    def look(self, width, height):
        self.cdp("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600)

    def js(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def without_programs(self):
        """The browser is one that cannot run the program: pages show recorded pictures."""
        script = self.cdp("Page.addScriptToEvaluateOnNewDocument", source="delete window.WebAssembly")["identifier"]
        self.addCleanup(self.cdp, "Page.removeScriptToEvaluateOnNewDocument", identifier=script)

    def live(self):
        """Waits until the program draws."""
        self.wait(lambda: self.js("return document.documentElement.classList.contains('live')"))

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
        # What is asked about may be drawn anew meanwhile.
        WebDriverWait(self.browser, 300, 0.05, [StaleElementReferenceException]).until(lambda _: condition())

    def assert_fits(self):
        self.assertLessEqual(self.js("return document.documentElement.scrollWidth"), self.js("return innerWidth"))

    def frames_of(self, name):
        return json.loads((self.out / name / "story.js").read_text().partition("gjkstep = ")[2].rstrip(";\n"))["story"]["frames"]

    def predict(self):
        """Presses P and waits until what it asks for has come."""
        pressed = self.find("#predict").get_attribute("aria-pressed")
        self.press("p")
        self.wait(lambda: self.find("#predict").get_attribute("aria-pressed") != pressed)

    def questions(self):
        return self.js("return gjkstep.story.questions")

    def printed(self):
        pdf = self.folder / "printed.pdf"
        pdf.write_bytes(base64.b64decode(self.cdp("Page.printToPDF", printBackground=True)["data"]))
        return subprocess.run(["pdftotext", "-layout", str(pdf), "-"], capture_output=True, text=True, check=True).stdout


def run():
    unittest.main(argv=[sys.argv[0], *(f"Page.{name}" for name in sys.argv[2:])], verbosity=1)
