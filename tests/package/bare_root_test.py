"""The Debian package installs on a bare system and draws there: the steps of pictures/github-actions.yml, in a file
system that holds nothing but Debian's essential packages and apt.

    python3 bare_root_test.py BUILD_FOLDER CMAKE            # takes a minute or two and the network
    python3 bare_root_test.py BUILD_FOLDER CMAKE --build    # builds the package there as well

Says "skipped: " and why where that cannot be, and ends with 77. Packages come from where those of this machine come from.
"""
import importlib.util
import pathlib
import shutil
import sys
import tempfile

import root as roots

here = pathlib.Path(__file__).resolve().parent
top = here.parents[1]
build_folder, cmake = map(pathlib.Path, sys.argv[1:3])
is_built_there = sys.argv[3:] == ["--build"]


def why_not():
    for program in ("dpkg-shlibdeps", "file"):
        if not shutil.which(program):
            return f"there is no {program}"
    if not importlib.util.find_spec("yaml"):
        return "there is no python3-yaml, to read the recipe"
    return roots.why_not()


class Job:
    """A run of the recipe, in `root`, whose folder /project is the checkout."""

    def __init__(self, root):
        import yaml

        self.root, self.project = root, root / "project"
        self.recipe = yaml.safe_load((here / "pictures/github-actions.yml").read_text())
        self.job = self.recipe["jobs"]["pictures"]
        self.variables = {**self.recipe["env"], **self.job["env"], "GJKSTEP_REPOSITORY": "/gjkstep.git",
                          "GJKSTEP_REVISION": "HEAD"}

    def shell(self, commands):
        """Runs as the service does: one shell a step, in the checkout, which stops at what fails."""
        return roots.shell(self.root, commands, "/project", self.variables)

    def steps(self):
        """Name and commands of the steps that the service would run, the package being there or not."""
        for step in self.job["steps"]:
            missed = step.get("if") == "steps.kept.outputs.cache-hit != 'true'"
            if "run" in step and (not missed or is_built_there):
                yield step["name"], step["run"]

    def succeeds(self):
        for name, commands in self.steps():
            code, said, seconds = self.shell(commands)
            print(f"{name}: {seconds:.0f} s", flush=True)
            if code != 0:
                sys.exit(f"'{name}' ended with {code}:\n{said}")

    def notices_a_changed_picture(self):
        picture = self.project / "expected/box-and-can/000.png"
        shutil.copy(picture.with_name("001.png"), picture)
        name, commands = list(self.steps())[-1]
        code, said, _ = self.shell(commands)
        if code == 0:
            sys.exit(f"'{name}' passes with a changed picture:\n{said}")
        keep = self.job["steps"][-1]
        page = self.project / keep["with"]["path"] / "box and can/report/index.html"
        if keep["if"] != "failure()" or not page.exists():
            sys.exit(f"the recipe keeps {keep['with']['path']}, and {page} is not there")


def provide_gjkstep(root):
    """To clone and build from, or as the package that the cache would hold."""
    if is_built_there:
        return roots.done("cloned", "git", "clone", "-q", "--bare", top, root / "gjkstep.git")
    roots.done("packed", cmake.with_name("cpack"), "-G", "DEB", "-B", root / "packed", "--config",
         build_folder / "CPackConfig.cmake")
    kept = root / "project/gjkstep-package"
    kept.mkdir()
    for package in (root / "packed").glob("gjkstep_*.deb"):
        shutil.move(package, kept)


def main():
    if reason := why_not():
        roots.skip(reason)
    with tempfile.TemporaryDirectory(prefix="gjkstep-bare-") as folder:
        root = roots.make(pathlib.Path(folder), roots.this_release())
        shutil.copytree(here / "pictures", root / "project")
        provide_gjkstep(root)
        job = Job(root)
        job.succeeds()
        job.notices_a_changed_picture()
    print("the package installs on a bare system, draws the same pictures there, and notices a changed one")


main()
