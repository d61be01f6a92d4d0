#!/usr/bin/env python3
"""A study as a job array of a real Slurm, which is started here with one node: 64 shards, one of them killed and run again, merged,
give the files of one run byte for byte.

    python3 tests/study/slurm/slurm_test.py build/gjkstep-study      # 77: skipped, and why; needs root, slurm-wlm and munge
"""
import contextlib, os, pathlib, shutil, socket, subprocess, sys, tempfile, time

here = pathlib.Path(__file__).resolve().parent
shards = 64
killed = 7
study = ["--pairs", "40", "--families", "triangles,cycles,touching-face-askew", "--scalar", "float,double", "--seed", "5"]


def skip(why):
    print("skipped: " + why)
    sys.exit(77)


def free_port():
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        return found.getsockname()[1]


def configuration(folder):
    host = socket.gethostname().split(".")[0]
    return f"""ClusterName=gjkstep
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
AuthInfo=socket={folder}/munge.socket
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
ProctrackType=proctrack/linuxproc
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
NodeName={host} NodeAddr=127.0.0.1 CPUs=8 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def wait_for(what, holds, seconds=60):
    late = time.monotonic() + seconds
    while not holds():
        if time.monotonic() > late:
            raise TimeoutError("waited in vain for " + what)
        time.sleep(0.05)


class Slurm:
    """munged, slurmctld and slurmd, with all that they write in one folder."""

    def __init__(self, folder):
        self.folder, self.daemons = folder, []
        for name in ("state", "spool"):
            (folder / name).mkdir()
        (folder / "slurm.conf").write_text(configuration(folder))
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}
        key = folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o600)
        self.start("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={folder}/munge.socket",
                   f"--pid-file={folder}/munged.pid", f"--seed-file={folder}/munged.seed", f"--log-file={folder}/munged.log")
        wait_for("munged", (folder / "munge.socket").exists)
        self.start("slurmctld", "-D")
        self.start("slurmd", "-D", "-N", socket.gethostname().split(".")[0])
        wait_for("the node", lambda: "idle" in self.run("sinfo", "-h", "-o", "%T", check=False).stdout)

    def start(self, *command):
        log = open(self.folder / (command[0] + ".out"), "w")
        self.daemons.append(subprocess.Popen(command, env=self.environment, stdout=log, stderr=log))

    def run(self, *command, check=True):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=check)

    def submit(self, array, *arguments):
        """Returns the number of the job."""
        return self.run("sbatch", "--parsable", f"--array={array}", f"--output={self.folder}/job-%a.out",
                        str(here / "study.sbatch"), *arguments).stdout.strip()

    def states(self, job):
        """The states of its tasks that are not done."""
        told = self.run("squeue", "-h", "-r", "-j", job, "-o", "%K %T", check=False).stdout
        return dict(line.split() for line in told.splitlines())

    def end(self):
        """Nothing that a job has started may outlive its daemon."""
        self.run("scancel", "--signal=KILL", "--full", "--user=root", check=False)
        with contextlib.suppress(TimeoutError):
            wait_for("the end of all jobs", lambda: not self.run("squeue", "-h", check=False).stdout, 10)
        for daemon in reversed(self.daemons):
            daemon.terminate()
            with contextlib.suppress(subprocess.TimeoutExpired):
                daemon.wait(10)
            daemon.kill()


def program_that_hangs(folder, program):
    """The study, but one shard of it never ends by itself."""
    script = folder / "hangs"
    script.write_text(f"""#!/bin/sh
[ "$SLURM_ARRAY_TASK_ID" = {killed} ] && exec sleep 2000
exec '{program}' "$@"
""")
    script.chmod(0o755)
    return script


def check(program, folder):
    slurm = Slurm(folder)
    try:
        out = folder / "shards"
        job = slurm.submit(f"0-{shards - 1}", str(program_that_hangs(folder, program)), str(out), str(shards), *study)
        wait_for("all shards but one", lambda: slurm.states(job) == {str(killed): "RUNNING"}, 300)
        slurm.run("scancel", "--signal=KILL", "--full", f"{job}_{killed}")
        wait_for("the end of the one that was killed", lambda: not slurm.states(job))
        missing = [i for i in range(shards) if not (out / f"shard-{i}-of-{shards}/counts.csv").exists()]
        assert missing == [killed], missing
        again = slurm.submit(str(killed), str(program), str(out), str(shards), *study)
        wait_for("the shard that is run again", lambda: not slurm.states(again))
    finally:
        slurm.end()
    report = here.parent / "report/report.py"
    subprocess.run([program, "run", *study, "--out", folder / "one"], check=True, capture_output=True)
    subprocess.run([report, folder / "one"], check=True, capture_output=True)
    subprocess.run([report, *out.glob("shard-*"), "--out", folder / "merged"], check=True, capture_output=True)
    for name in ("tables.md", "errors.md", "settings.md"):
        assert (folder / "merged" / name).read_bytes() == (folder / "one" / name).read_bytes(), name
    print(f"{shards} shards, number {killed} killed and run again: merged as one run, byte for byte")


if __name__ == "__main__":
    if os.geteuid() != 0:
        skip("starting Slurm takes root")
    for name in ("munged", "slurmctld", "slurmd", "sbatch"):
        if not shutil.which(name):
            skip(f"{name} is not there; apt-get install slurm-wlm munge")
    folder = pathlib.Path(tempfile.mkdtemp(prefix="gjkstep-slurm-"))
    try:
        check(str(pathlib.Path(sys.argv[1]).resolve()), folder)
    except (AssertionError, TimeoutError, subprocess.CalledProcessError):
        for log in sorted(folder.glob("*.out")):
            print(f"--- {log.name}\n" + "\n".join(log.read_text().splitlines()[-15:]), file=sys.stderr)
        raise
    finally:
        shutil.rmtree(folder, ignore_errors=True)
