"""File systems of Debian's own that tests make to try things in: nothing is in them but what is asked for.

Packages come from where those of this machine come from. All of it needs root and the network.
"""
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import time

apt = pathlib.Path("/etc/apt")
releases = ["bookworm", "trixie"]  # Debian 12 and 13


def this_release():
    return platform.freedesktop_os_release()["VERSION_CODENAME"]


def other_release():
    return releases[1 - releases.index(this_release())]


def sources():
    """The files that say where the packages of this release come from, which are those of the component called main."""
    files = [apt / "sources.list", *sorted((apt / "sources.list.d").glob("*"))]
    return [file for file in files if file.suffix in (".list", ".sources") and file.is_file() and
            {this_release(), "main"} <= set(file.read_text().split())]


def why_not():
    """Why no root can be made here; empty where one can."""
    if os.geteuid() != 0:
        return "needs root, to change into another file system"
    for program in ("mmdebstrap", "unshare"):
        if not shutil.which(program):
            return f"there is no {program}"
    if subprocess.run(["unshare", "--mount", "--pid", "--fork", "true"], stderr=subprocess.DEVNULL).returncode != 0:
        return "mount and process namespaces cannot be made here"
    if this_release() not in releases:
        return f"{this_release()} is none of {' and '.join(releases)}"
    if not sources():
        return f"no file in {apt} says where the packages of {this_release()} come from"
    return ""


def skip(reason):
    print(f"skipped: {reason}", flush=True)
    sys.exit(77)


def run(*words):
    start = time.monotonic()
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout, time.monotonic() - start


def done(what, *words):
    """Ends the program where that fails."""
    code, said, seconds = run(*words)
    print(f"{what}: {seconds:.0f} s", flush=True)
    if code != 0:
        sys.exit(f"{what} ended with {code}:\n{said}")
    return said


def make(folder, release, packages=()):
    """A new root in `folder`. Where `release` is another, its packages come from the same servers. Says "skipped: " and ends the
    program with 77 where there is no network."""
    lists = folder / "sources"
    lists.mkdir(parents=True)
    for file in sources():
        (lists / file.name).write_text(file.read_text().replace(this_release(), release))
    root = folder / "root"
    include = [f"--include={','.join(packages)}"] if packages else []
    code, said, seconds = run("mmdebstrap", "--mode=root", "--variant=apt", *include, release, root, *sorted(lists.iterdir()))
    if code != 0 and re.search("Temporary failure resolving|Could not (resolve|connect)|Network is unreachable", said):
        skip("the servers of Debian's packages cannot be reached")
    print(f"made a root of {release}: {seconds:.0f} s", flush=True)
    if code != 0:
        sys.exit(f"mmdebstrap ended with {code}:\n{said}")
    return root


def shell(root, commands, folder="/", variables={}):
    """Runs commands in `folder` of that root, and stops at what fails. Returns: exit code, what was said, seconds."""
    enter = f'mount -t proc proc "$1/proc" && mount -t devpts devpts "$1/dev/pts" && exec chroot "$1" /usr/bin/env -i -C "{folder}" "${{@:2}}"'
    words = [f"{key}={value}" for key, value in
             {**variables, "PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root"}.items()]
    return run("unshare", "--mount", "--pid", "--fork", "--kill-child", "bash", "-c", enter, "bash", root, *words,
               "sh", "-e", "-c", commands)
