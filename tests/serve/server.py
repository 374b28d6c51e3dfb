"""`aeolic serve` in a process of its own, for tests and the soak."""
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import time
import urllib.request

from viewer import Viewer, Wire, split

PROGRAM = os.environ["AEOLIC_PROGRAM"]
SLOW = float(os.environ.get("AEOLIC_SLOW", "1"))  # Everything may take that many times longer, with sanitizers or under load.
SCENE = ["--surface", "teapot:2000", "--field", "rotation:16,16,16", "--steps", "8"]

# OpenMPI 4 and 5 are allowed more ranks than cores, and to run as root in a container.
LAUNCHING = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
             "OMPI_MCA_rmaps_base_oversubscribe": "1", "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe"}

has_mpirun = shutil.which("mpirun") is not None and os.environ.get("AEOLIC_MPI", "ON") == "ON"
gl_faults = os.environ.get("AEOLIC_GL_FAULTS", "")  # The library that makes a device fail (tests/gl_faults_preload.cpp).
has_openssl = shutil.which("openssl") is not None


def run(*words, timeout=60):
    """The program with these words, to its end."""
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True, errors="replace", timeout=timeout * SLOW,
                          env={**os.environ, **LAUNCHING}, stdin=subprocess.DEVNULL)


def has_gl():
    """Whether --backend gl can be had and be made to fail. With AEOLIC_REQUIRE_GL it is to be had."""
    if not gl_faults or "AEOLIC_REQUIRE_GL" in os.environ:
        return bool(gl_faults)
    with tempfile.TemporaryDirectory() as folder:
        return run("render", *SCENE, "--backend", "gl", "--size", "8x8", "-o", os.path.join(folder, "a.png")).returncode == 0


def alive(pid):
    try:
        with open(f"/proc/{pid}/stat") as stat:
            return stat.read().rpartition(")")[2].split()[0] not in "ZX"
    except FileNotFoundError:
        return False


def parent_of(pid):
    with open(f"/proc/{pid}/stat") as stat:
        return int(stat.read().rpartition(")")[2].split()[1])


def within(seconds, condition, what="it"):
    """Waits until condition() is true."""
    end = time.monotonic() + seconds * SLOW
    while True:
        result = condition()
        if result:
            return result
        if time.monotonic() > end:
            raise TimeoutError(f"{what} did not happen within {seconds} s")
        time.sleep(0.02)


class Server:
    """Started when made. Its standard error is kept in `log`."""

    def __init__(self, *options, scene=SCENE, files=None, inside=(), environment=None):
        self.folder = tempfile.mkdtemp(prefix="aeolic_serve_")
        self.log_path = os.path.join(self.folder, "log")
        with open(self.log_path, "wb") as log:
            # The folder's name is on the command line of every process it starts. That is how strays are found.
            self.process = subprocess.Popen([*inside, PROGRAM, "serve", *scene, "--port", "0", *options], stdout=subprocess.PIPE,
                                            stderr=log, stdin=subprocess.DEVNULL, text=True, cwd=self.folder,
                                            env={**os.environ, **LAUNCHING, **(environment or {}), "AEOLIC_TEST_FOLDER": self.folder},
                                            preexec_fn=files and (lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (files, files))))
        self.address = self.process.stdout.readline().strip()
        if not self.address:
            self.__exit__()
            raise RuntimeError("the server did not start")
        self.host, self.port, self.token = split(self.address)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.terminate()
            try:
                self.process.wait(15 * SLOW)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        self.process.stdout.close()
        for pid in self.strays():
            os.kill(pid, signal.SIGKILL)
        log = self.log()
        shutil.rmtree(self.folder, ignore_errors=True)
        if "Sanitizer" in log or "runtime error:" in log:  # A finding in the gateway or a rank fails the test, whatever viewers saw.
            raise AssertionError(log)

    @property
    def pid(self):
        return self.process.pid

    def log(self):
        with open(self.log_path, errors="replace") as log:
            return log.read()

    def viewer(self, **options):
        return Viewer(self.address, **{"timeout": 60 * SLOW, **options})

    def wire(self, timeout=20):
        return Wire(self.host, self.port, timeout * SLOW)

    def get(self, path="/", token=None, timeout=20):
        """Body of a GET with the token."""
        request = urllib.request.Request(f"http://{self.host}:{self.port}{path}",
                                         headers={"Authorization": "Bearer " + (self.token if token is None else token)})
        with urllib.request.urlopen(request, timeout=timeout * SLOW) as response:
            return response.read()

    def status(self):
        return json.loads(self.get("/status"))

    def ranks(self, count=None):
        """Process numbers of the ranks, once there are so many."""
        def joined():
            status = self.status()
            assert status["state"] != "failed", "the job was given up: " + self.log()
            pids = status["pids"]
            return pids if pids and (count is None or len(pids) == count) else None
        return within(60, joined, "ranks joining")

    def strays(self):
        """Processes that this server started, wherever they are now, without itself."""
        found = []
        for pid in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open(f"/proc/{pid}/environ", "rb") as environ:
                    if self.folder.encode() in environ.read() and int(pid) != self.process.pid and alive(pid):
                        found.append(int(pid))
            except (FileNotFoundError, PermissionError, ProcessLookupError):
                pass
        return found


def memory_bytes(pid):
    """Resident memory of a process."""
    with open(f"/proc/{pid}/status") as status:
        return 1024 * int(re.search(r"VmRSS:\s+(\d+)", status.read())[1])


def open_files(pid):
    return len(os.listdir(f"/proc/{pid}/fd"))
