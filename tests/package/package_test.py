"""What others get of gjkstep: installed into a temporary prefix, or as a part of their project.

    python3 package_test.py BUILD_FOLDER CMAKE GENERATOR COMPILER
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

here = pathlib.Path(__file__).resolve().parent
top = here.parents[1]
build_folder, cmake, generator, compiler = (pathlib.Path(sys.argv[1]), *sys.argv[2:5])
environment = {key: value for key, value in os.environ.items() if key != "GJKSTEP_ACCEPT"}


def run(*words, **more):
    """Returns: exit code, and everything said. `more` are environment variables."""
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env={**environment, **more})
    return done.returncode, done.stdout


def one_line(text):
    return " ".join(text.split())  # CMake breaks lines where it likes


class InAFolder(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="gjkstep package ")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        self.prefix = self.folder / "prefix"

    def done(self, *words, **more):
        code, said = run(*words, **more)
        self.assertEqual(code, 0, said)
        return said

    def install(self):
        self.done(cmake, "--install", build_folder, "--prefix", self.prefix)


class OnlyEigen(InAFolder):
    def configure(self, *options):
        return run(cmake, "-S", here / "only_eigen", "-B", self.folder / "build", "-G", generator,
                   f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_CXX_STANDARD=17", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                   *options)

    def check_eigen_is_asked_for(self, *options):
        code, said = self.configure("-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON", *options)
        self.assertNotEqual(code, 0)
        self.assertRegex(one_line(said), "gjkstep needs Eigen|Eigen3 .*gjkstep-config.cmake")
        its_own = self.folder / "eigen.cmake"
        its_own.write_text("add_library(Eigen3::Eigen INTERFACE IMPORTED)\n")
        code, said = self.configure(f"-DCMAKE_PROJECT_only_eigen_INCLUDE={its_own}", *options)
        self.assertEqual(code, 0, said)

    def check_build(self, *options):
        code, said = self.configure("-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=OFF", "-UCMAKE_PROJECT_only_eigen_INCLUDE",
                                    *options)
        self.assertEqual(code, 0, said)
        self.done(cmake, "--build", self.folder / "build")
        self.done(self.folder / "build/only_eigen")
        compiled = json.loads((self.folder / "build/compile_commands.json").read_text())
        self.assertEqual(len(compiled), 1)
        words = compiled[0]["command"]
        self.assertIn("-ffp-contract=off", words)
        self.assertRegex(words, r"-std=gnu\+\+(20|2a)")
        self.assertNotRegex(words, r" -W")
        self.assertNotRegex(words, rf"(-I|-isystem ){re.escape(str(top))} ")

    def test_installed(self):
        self.install()
        installed = self.prefix / "include/gjkstep"
        self.assertEqual({file.relative_to(top / "core") for file in top.glob("core/**/*.hpp")},
                         {file.relative_to(installed) for file in installed.glob("**/*.*")})
        where = f"-DCMAKE_PREFIX_PATH={self.prefix}"
        self.check_eigen_is_asked_for(where)
        self.check_build(where)

    def test_part_of_another_project(self):
        where, trace = f"-DGJKSTEP_SOURCE={top}", self.folder / "trace"
        self.check_eigen_is_asked_for(where)
        self.check_build(where, "--trace", "--trace-format=json-v1", f"--trace-redirect={trace}")
        commands = [json.loads(line) for line in trace.read_text().splitlines()[1:]]
        looked_for = [command["args"][0] for command in commands if re.match("(find|pkg)_", command["cmd"]) and
                      pathlib.Path(command["file"]).is_relative_to(top)]
        self.assertLessEqual(set(looked_for), {"Eigen3"})
        self.done(cmake, "--install", self.folder / "build", "--prefix", self.prefix)
        self.assertFalse(self.prefix.exists(), "another project installs gjkstep without having asked")


class Readme(InAFolder):
    def code(self, folder, language, blocks=1):
        found = re.findall(rf"^```{language}\n(.*?)^```$", (top / folder / "README.md").read_text(), re.MULTILINE | re.DOTALL)
        self.assertEqual(len(found), blocks)
        return "".join(found).splitlines(keepends=True)

    def test_what_it_shows_of_code_builds_and_runs(self):
        self.install()
        code = self.code("core", "cpp", blocks=5)
        includes, statements = ("".join(line for line in code if line.startswith("#include") == is_one) for is_one in (True, False))
        project = self.folder / "project"
        project.mkdir()
        ends_well = ("return !met || together || trace.events.empty() || !is_true || proven.status != gjk::Status::intersecting || "
                     "now.status != proven.status;")
        (project / "main.cpp").write_text(f"{includes}\nint main() {{ {statements} {ends_well} }}")
        (project / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(yours LANGUAGES CXX)\n"
                                                "add_executable(yours main.cpp)\n" +
                                                "".join(self.code("core", "cmake") + self.code("walkthroughs", "cmake")))
        (project / "scene.json").write_text(self.done(build_folder / "gjkstep", "scene", "--example"))
        self.done(cmake, "-S", project, "-B", self.folder / "build", "-G", generator,
                  f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        self.done(cmake, "--build", self.folder / "build")
        self.done(self.folder / "build/yours")
        ctest = pathlib.Path(cmake).with_name("ctest")
        self.done(ctest, "--test-dir", self.folder / "build", GJKSTEP_ACCEPT="1")
        self.done(ctest, "--test-dir", self.folder / "build")


class GoldenTests(InAFolder):
    def setUp(self):
        super().setUp()
        self.install()
        self.project, self.build = self.folder / "project", self.folder / "build"
        shutil.copytree(here / "pictures", self.project)
        self.expected, self.kept = self.project / "expected", self.build / "golden/box and can"
        self.first = self.expected / "box-and-can/000.png"

    def configure(self):
        return run(cmake, "-S", self.project, "-B", self.build, "-G", generator, f"-DCMAKE_PREFIX_PATH={self.prefix}")

    def ctest(self, **more):
        code, said = self.configure()
        self.assertEqual(code, 0, said)
        return run(pathlib.Path(cmake).with_name("ctest"), "--test-dir", self.build, "--verbose", **more)

    def passes(self, **more):
        code, said = self.ctest(**more)
        self.assertEqual(code, 0, said)
        self.assertFalse(self.kept.exists(), "a test that passes keeps nothing")
        return said

    def fails(self, **more):
        before = self.files()
        code, said = self.ctest(**more)
        self.assertNotEqual(code, 0, said)
        self.assertEqual(self.files(), before, "a test that fails accepts nothing")
        return said

    def files(self):
        return {file.relative_to(self.project): file.read_bytes() for file in self.project.rglob("*") if file.is_file()}

    def test_same_pictures_pass_and_stay_as_they_are(self):
        before = self.files()
        self.passes()
        self.passes(GJKSTEP_ACCEPT="1")
        self.assertEqual(self.files(), before)

    def test_a_changed_picture_fails_until_it_is_accepted(self):
        shutil.copy(self.first.with_name("001.png"), self.first)
        self.assertIn("1 of 6 pictures fails", self.fails())
        self.assertIn("000.png", (self.kept / "report/index.html").read_text())
        drawn = (self.kept / "actual/box-and-can/000.png").read_bytes()
        self.fails(GJKSTEP_ACCEPT="0")
        self.assertIn("GJKSTEP_ACCEPT is 'yes'", self.fails(GJKSTEP_ACCEPT="yes"))
        self.passes(GJKSTEP_ACCEPT="1")
        self.assertEqual(self.first.read_bytes(), drawn)
        self.passes()

    def test_pictures_of_another_version_are_told_with_both(self):
        shutil.copy(self.first.with_name("001.png"), self.first)
        notes = self.expected / "rendered-by.json"
        said = one_line(self.fails())
        drawn = json.loads((self.kept / "actual/rendered-by.json").read_text())["gjkstep"]
        self.assertNotIn("were drawn by", said)
        for text, known in (('{"gjkstep": "0.0.1"}', "0.0.1"), ("{}", "of an unknown version"), ("no JSON", "of an unknown version")):
            notes.write_text(text)
            said = one_line(self.fails())
            self.assertIn(f"drawn by gjkstep {known}, these by gjkstep {drawn}: look at the report", said)
            self.assertIn("accept: GJKSTEP_ACCEPT=1", said)

    def test_without_accepted_pictures_the_words_printed_accept(self):
        shutil.rmtree(self.expected)
        said = self.fails()
        self.assertTrue((self.kept / "actual/box-and-can/000.png").exists())
        command = re.search("accept: (.*)", said)[1]
        self.done("sh", "-c", command)
        self.assertTrue(self.first.exists())
        self.passes()

    def test_pictures_no_longer_drawn_go_and_other_files_stay(self):
        stale, note = self.expected / "box-and-can/006.png", self.expected / "notes.txt"
        shutil.copy(self.first, stale)
        note.write_text("why these")
        self.fails()
        self.passes(GJKSTEP_ACCEPT="1")
        self.assertFalse(stale.exists())
        self.assertTrue(note.exists())

    def test_pictures_that_no_test_accepted_stay(self):
        (self.expected / "rendered-by.json").unlink()
        (self.expected / "logo.png").write_bytes(b"of somebody else")
        self.assertIn("nothing is accepted: ", self.fails(GJKSTEP_ACCEPT="1"))

    def test_folders_whose_names_look_like_patterns(self):
        for name, beside in (("e[1]", "e1"), ("what?", "what1"), ("all*", "all that")):
            self.declare(f"NAME [[box and can]] SCENE box-and-can.json EXPECTED \"{name}\" OPTIONS --size 64x36")
            foreign = self.project / beside / "keep.png"
            foreign.parent.mkdir()
            foreign.write_bytes(b"of somebody else")
            self.passes(GJKSTEP_ACCEPT="1")
            shutil.copy(self.project / name / "box-and-can/000.png", self.project / name / "box-and-can/007.png")
            self.assertIn("007.png, which is no longer drawn", one_line(self.passes(GJKSTEP_ACCEPT="1")))
            self.passes()
            self.assertTrue(foreign.exists())

    def test_options_that_draw_nothing_are_told(self):
        self.declare("NAME [[box and can]] SCENE box-and-can.json EXPECTED expected OPTIONS --help")
        for asked in "01":
            self.assertIn("draws no pictures", one_line(self.fails(GJKSTEP_ACCEPT=asked)))

    def test_without_testing_enabled_it_warns(self):
        text = (self.project / "CMakeLists.txt").read_text()
        (self.project / "CMakeLists.txt").write_text(text.replace("enable_testing()\n", ""))
        self.assertIn("call enable_testing()", one_line(self.configure()[1]))
        (self.project / "CMakeLists.txt").write_text(text.replace("enable_testing()\n", "") + "enable_testing()\n")
        self.assertNotIn("enable_testing", one_line(self.configure()[1]))

    def test_damaged_pictures_are_told_and_replaced(self):
        self.first.write_bytes(b"no picture")
        self.assertIn("000.png", self.fails())
        self.passes(GJKSTEP_ACCEPT="1")

    def test_a_scene_that_cannot_be_drawn_is_told_and_never_accepted(self):
        (self.project / "box-and-can.json").write_text("{}")
        for asked in "01":
            self.assertRegex(self.fails(GJKSTEP_ACCEPT=asked), "box-and-can.json.*\n(.*\n)*.*cannot be drawn")

    def declare(self, *calls):
        text = (self.project / "CMakeLists.txt").read_text()
        text = text[:text.index("gjkstep_add_golden_test")]
        (self.project / "CMakeLists.txt").write_text(text + "\n".join(f"gjkstep_add_golden_test({c})" for c in calls))

    def test_odd_names_and_walkthroughs(self):
        (self.project / "box-and-can.json").rename(self.project / "a scene.json")
        self.declare("NAME [[it's (1+1)/2 \\ $HOME]] SCENE [[a scene.json]] figure-1 EXPECTED [[of the/odd one]] "
                     "OPTIONS --size 64x36")
        said = self.fails()
        self.done("sh", "-c", re.search("accept: (.*)", said)[1])
        self.assertTrue((self.project / "of the/odd one/a-scene/000.png").exists())
        self.assertTrue((self.project / "of the/odd one/figure-1/000.png").exists())
        self.passes()

    def test_projects_of_old_policies_get_plain_names_only(self):
        for name, accepted in (("box", True), ("[[box and can]]", False)):
            self.declare(f"NAME {name} SCENE box-and-can.json EXPECTED expected")
            text = (self.project / "CMakeLists.txt").read_text()
            (self.project / "CMakeLists.txt").write_text(text.replace("VERSION 3.25", "VERSION 3.10"))
            code, said = self.configure()
            self.assertEqual(code == 0, accepted, said)
        self.assertIn("takes cmake_minimum_required(VERSION 3.19)", one_line(said))

    def test_wrong_calls_are_refused(self):
        for calls, words in {
                ("NAME a SCENE b.json",): "EXPECTED is missing",
                ("SCENE b.json EXPECTED c",): "NAME is missing",
                ("NAME a EXPECTED c",): "SCENE is missing",
                ("more NAME a SCENE b.json EXPECTED c",): "'more' is not expected",
                ("NAME a SCENE b.json EXPECTED c", "NAME d SCENE b.json EXPECTED ./c/"): "'d' and 'a' share",
                ("NAME a SCENE b.json EXPECTED c", "NAME d SCENE b.json EXPECTED c/."): "'d' and 'a' share",
                ("NAME a SCENE b.json EXPECTED c", "NAME d SCENE b.json EXPECTED c/e"): "'d' and 'a' share",
                ("NAME a SCENE b.json EXPECTED c/e", "NAME d SCENE b.json EXPECTED c"): "'d' and 'a' share",
                ("NAME a SCENE b.json EXPECTED .",): "which holds your project",
                ("NAME a SCENE b.json EXPECTED ..",): "which holds your project",
                ("NAME a SCENE b.json EXPECTED ${CMAKE_BINARY_DIR}/golden/a/e",): "where tests draw anew",
                ("NAME a SCENE b.json EXPECTED ${CMAKE_BINARY_DIR}",): "where tests draw anew",
                ("NAME a SCENE b.json EXPECTED CMakeLists.txt",): "is a file; name a folder",
                ("NAME a SCENE b.json EXPECTED CMakeLists.txt/e",): "is a file; name a folder",
                ("NAME a/b SCENE b.json EXPECTED c", "NAME a:b SCENE b.json EXPECTED d"): "'a:b' and 'a/b' share",
        }.items():
            self.declare(*calls)
            code, said = self.configure()
            self.assertNotEqual(code, 0)
            self.assertIn(words, one_line(said))


@unittest.skipUnless(shutil.which("dpkg-shlibdeps") and shutil.which("file"), "there is no dpkg-shlibdeps or no file")
class DebianPackage(InAFolder):
    def test_it_depends_on_what_it_needs_and_knows_no_folder_of_this_machine(self):
        self.done(pathlib.Path(cmake).with_name("cpack"), "-G", "DEB", "-B", self.folder, "--config",
                  build_folder / "CPackConfig.cmake")
        package, = self.folder.glob("gjkstep_*.deb")
        depends = self.done("dpkg-deb", "--field", package, "Depends")
        for needed in ("fonts-dejavu-core", "libeigen3-dev", "libc6", "libpng16", "libfreetype6"):
            self.assertIn(needed, depends)
        self.assertRegex(depends, "libosmesa6|libegl1")
        self.done("dpkg-deb", "--extract", package, self.prefix)
        files = [file for file in self.prefix.rglob("*") if file.is_file()]
        self.assertGreater(len(files), 10)
        for file in files:
            self.assertTrue(file.is_relative_to(self.prefix / "usr"), file)
            for machine in (top, build_folder):
                self.assertNotIn(os.fsencode(machine) + b"/", file.read_bytes(), file)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
