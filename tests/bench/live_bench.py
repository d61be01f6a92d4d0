#!/usr/bin/python3
"""How long a page takes in headless Chromium from the move of a corner to the painted picture, and to its first one; and how large the
programs are that it asks. Prints a table.

    /usr/bin/python3 tests/bench/live_bench.py build/gjkstep >tests/bench/live.md
"""
import json, pathlib, random, re, shutil, statistics, subprocess, sys, tempfile, time, zlib, base64

from selenium import webdriver
from selenium.webdriver.chrome.service import Service

moves, scenes, opened = 120, 6, 9
dice = random.Random(39)


def points(dimension, to_the_right):
    return [[round(dice.uniform(-1.5, 1.5) + (to_the_right if k == 0 else 0), 3) for k in range(dimension)] for _ in range(8)]


def scene(dimension):
    return {"dimension": dimension, "a": {"points": points(dimension, 0)}, "b": {"points": points(dimension, 0.8)}}


drag = """
const [name, moves, done] = arguments, stage = document.getElementById('stage');
const grip = document.querySelector(`.grip[data-name="${name}"]`), {x, y} = grip.getBoundingClientRect(), times = [];
const event = (type, i) => new PointerEvent(type, {bubbles: true, pointerId: 1, button: 0, clientX: x + 13 + 40 * Math.sin(i / 7), clientY: y + 13 + 25 * Math.cos(i / 5), altKey: true});
stage.setPointerCapture = () => {};
grip.dispatchEvent(event('pointerdown', 0));
(async () => {
    for (let i = 1; i <= moves; ++i)
        times.push(await new Promise(use => {
            requestAnimationFrame(() => {  // before the page's own in this frame
                const begin = performance.now();
                setTimeout(() => use(performance.now() - begin));  // after it is painted
            });
            stage.dispatchEvent(event('pointermove', i));
        }));
    stage.dispatchEvent(event('pointerup', moves));
    done(times.slice(20));
})()"""


def main(program):
    folder = pathlib.Path(tempfile.mkdtemp())
    options = webdriver.ChromeOptions()
    for option in ["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=1366,768"]:
        options.add_argument(option)
    browser = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    browser.set_script_timeout(120)

    def open_page(name):
        browser.get("about:blank")
        browser.get(f"file://{folder / name / 'index.html'}")
        while not browser.execute_script("return document.documentElement.classList.contains('live')"):
            time.sleep(0.05)

    print("# What a page takes that draws by itself\n\nMade again by `/usr/bin/python3 tests/bench/live_bench.py build/gjkstep`, in headless Chromium on two")
    print("cores. 8 + 8 points; milliseconds from the move of a corner to the painted picture, and from opening a page to its first.\n")
    print("| | median | 95 of 100 are below |\n|---|---|---|")
    for dimension, where in [(2, "in the plane"), (3, "in space")]:
        times = []
        for i in range(scenes):
            file = folder / f"scene-{dimension}-{i}.json"
            file.write_text(json.dumps(scene(dimension)))
            subprocess.run([program, "render", file, "--page", "--size", "64x36", "--out", folder], check=True, stdout=subprocess.DEVNULL)
            open_page(file.stem)
            times += browser.execute_async_script(drag, "a.points[0]", moves)
        times.sort()
        print(f"| a move {where} | {statistics.median(times):.1f} | {times[int(0.95 * len(times))]:.1f} |")
    firsts = []
    for _ in range(opened):
        open_page("scene-3-0")
        firsts.append(browser.execute_script("return performance.getEntriesByName('first picture')[0].startTime"))
    print(f"| the first picture | {statistics.median(firsts):.0f} | {sorted(firsts)[-1]:.0f} |")
    browser.quit()
    print("\n| program | KB | deflated, KB |\n|---|---|---|")
    for file, what in [("program.js", "loaded first"), ("all-searches.js", "loaded when asked for")]:
        packed = base64.b64decode(re.search("'([^']{1000,})'", (folder / file).read_text())[1])
        print(f"| {what} | {len(zlib.decompress(packed)) / 1000:.0f} | {len(packed) / 1000:.0f} |")
    shutil.rmtree(folder)


main(sys.argv[1])
