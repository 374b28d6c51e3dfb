"""`aeolic render` and `aeolic serve` under a real Slurm of one node, which this test starts on loopback and ends again.

Exits with 77 and a reason where Slurm is not installed or does not start. (Debian: apt-get install slurm-wlm munge.)
"""
import getpass
import hashlib
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import unittest

from server import PROGRAM, SCENE, SLOW, Server, has_mpirun, within

VIEW = {"camera": {"azimuth": 40}, "width": 120, "height": 90}
CORES = 4  # Whatever there are: tests need more ranks than small machines have cores.
NEEDED = ["munged", "slurmctld", "slurmd", "srun", "sinfo", "squeue", "scancel"]
PATH = os.environ["PATH"] + ":/usr/sbin:/sbin"
SRUN = ["srun", "--mpi=pmix"]


def missing():
    return [name for name in NEEDED if not shutil.which(name, path=PATH)]


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


class Slurm:
    """A controller, a node and an authentication service of this user, with all their files in one folder."""

    def __init__(self):
        self.folder = tempfile.mkdtemp(prefix="aeolic_slurm_")
        self.environment = {**os.environ, "PATH": PATH, "SLURM_CONF": self.file("slurm.conf")}
        self.daemons = []

    def file(self, name):
        return os.path.join(self.folder, name)

    def __enter__(self):
        os.chmod(self.folder, 0o755)  # munged and slurmd look at their folder's mode.
        try:
            self.configure()
            self.start("munged", "--foreground", "--force", "--key-file=" + self.file("key"), "--socket=" + self.file("munge"),
                       "--pid-file=" + self.file("munged.pid"), "--log-file=" + self.file("munged.log"),
                       "--seed-file=" + self.file("seed"))
            self.until(lambda: os.path.exists(self.file("munge")))
            self.start("slurmctld", "-D", "-f", self.file("slurm.conf"))
            self.start("slurmd", "-D", "-f", self.file("slurm.conf"))
            self.until(lambda: self.run("sinfo", "-h", "-o", "%T").stdout.strip() == "idle")
            if "pmix" not in self.run("srun", "--mpi=list").stdout:
                raise OSError("it has no pmix")
        except (OSError, subprocess.TimeoutExpired) as error:
            self.__exit__()
            raise unittest.SkipTest(f"Slurm cannot be started here: {error}") from error
        return self

    def configure(self):
        user, host = getpass.getuser(), socket.gethostname().split(".")[0]
        controller, node = free_ports(2)
        for name in ("state", "spool"):
            os.mkdir(self.file(name))
        with open(self.file("key"), "wb") as key:
            os.chmod(key.fileno(), 0o600)
            key.write(os.urandom(128))
        with open(self.file("cgroup.conf"), "w") as cgroup:
            cgroup.write("IgnoreSystemd=yes\n")
        with open(self.file("slurm.conf"), "w") as conf:
            conf.write(f"""ClusterName=aeolic
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={node}
SlurmUser={user}
SlurmdUser={user}
SlurmdParameters=config_overrides
AuthInfo=socket={self.file("munge")}
StateSaveLocation={self.file("state")}
SlurmdSpoolDir={self.file("spool")}
SlurmctldPidFile={self.file("slurmctld.pid")}
SlurmdPidFile={self.file("slurmd.pid")}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
KillWait=5
NodeName={host} NodeAddr=127.0.0.1 CPUs={CORES} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=10 State=UP
""")

    def start(self, *words):
        with open(self.file(words[0] + ".out"), "wb") as out:
            self.daemons.append(subprocess.Popen(words, stdout=out, stderr=out, stdin=subprocess.DEVNULL, env=self.environment,
                                                 cwd=self.folder))

    def until(self, condition):
        def look():
            for daemon in self.daemons:
                if daemon.poll() is not None:
                    with open(self.file(daemon.args[0] + ".out"), errors="replace") as out:
                        raise OSError(f"{daemon.args[0]} ended: {(out.read().strip().splitlines() or ['without a word'])[-1]}")
            return condition()
        within(30, look, "its start")

    def run(self, *words, timeout=120):
        return subprocess.run(words, capture_output=True, text=True, errors="replace", timeout=timeout * SLOW,
                              stdin=subprocess.DEVNULL, env=self.environment, cwd=self.folder)

    def jobs(self):
        return self.run("squeue", "-h").stdout.split()

    def __exit__(self, *_):
        if len(self.daemons) == 3 and all(daemon.poll() is None for daemon in self.daemons) and self.jobs():
            self.run("scancel", "--user", getpass.getuser())
            within(20, lambda: not self.jobs(), "the end of Slurm's jobs")
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(20 * SLOW)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


def digest(frame):
    return hashlib.sha256(frame.pixels()).hexdigest()


class UnderSlurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.slurm = Slurm().__enter__()
        cls.addClassCleanup(cls.slurm.__exit__)

    def draw(self, name, *launcher):
        drawn = self.slurm.run(*launcher, PROGRAM, "render", *SCENE, "--size", "160x120", "-o", name + ".png", "--stats",
                               name + ".json")
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        with open(self.slurm.file(name + ".png"), "rb") as picture, open(self.slurm.file(name + ".json")) as stats:
            return picture.read(), json.load(stats)

    def test_render_gives_the_same_bytes(self):
        alone, _ = self.draw("alone")
        for ranks in (1, 3):
            picture, stats = self.draw(f"of{ranks}", *SRUN, "-n", str(ranks))
            self.assertEqual(picture, alone)
            self.assertEqual(stats["ranks"], ranks)

    def test_wrong_input_is_one_line_and_exit_code_2(self):
        ended = self.slurm.run(*SRUN, "-n", "2", PROGRAM, "render", "--surface", "none.vtp", "-o", "no.png")
        self.assertEqual(ended.returncode, 2)
        self.assertEqual(ended.stderr.count("none.vtp: no such file"), 1, ended.stderr)

    def test_ranks_that_do_not_find_each_other_draw_nothing(self):
        ended = self.slurm.run("srun", "--mpi=none", "-n", "2", PROGRAM, "render", *SCENE, "-o", "no.png")
        self.assertIn(ended.returncode, (1, 2))
        self.assertRegex(ended.stderr, "says 2 ranks, MPI says 1|launched using .srun.")  # Open MPI itself says the latter.
        self.assertFalse(os.path.exists(self.slurm.file("no.png")))

    def test_serve_draws_survives_a_rank_and_leaves_no_job(self):
        with Server() as server, server.viewer() as viewer:
            expected = digest(viewer.see(**VIEW))
        with Server("--ranks", "3", "--launcher", " ".join(SRUN) + " -n {ranks}", environment=self.slurm.environment) as server:
            with server.viewer(timeout=120 * SLOW) as viewer:
                self.assertEqual(digest(viewer.see(**VIEW)), expected)
                os.kill(server.ranks(3)[1], signal.SIGKILL)
                viewer.wait_state("restarting", 60 * SLOW)
                viewer.wait_state("ready", 60 * SLOW)
                self.assertEqual(digest(viewer.see(**VIEW)), expected)
                within(30, lambda: len(self.slurm.jobs()) > 0 and self.slurm.run("squeue", "-h", "-o", "%i").stdout.count("\n") == 1,
                       "the end of the first job")
        within(30, lambda: not self.slurm.jobs(), "the end of the server's job")


if __name__ == "__main__":
    reason = ("a build without MPI, or no mpirun" if not has_mpirun else
              f"no {', '.join(missing())} (Debian: apt-get install slurm-wlm munge)" if missing() else None)
    program = unittest.main(exit=False) if reason is None else None
    skipped = program and program.result.skipped
    if reason or (skipped and program.result.testsRun == 0):
        print(reason or skipped[0][1])
        sys.exit(77)
    sys.exit(not program.result.wasSuccessful())
