"""Ranks on hosts that are really apart: network namespaces with host names of their own, and a switch between them.

Exits with 77 and a reason where such hosts cannot be made.
"""
import ctypes
import hashlib
import os
import shutil
import stat
import subprocess
import sys
import tempfile
import time
import unittest

from server import LAUNCHING, SLOW, Server, alive, has_mpirun, within
from viewer import Viewer

CLONE_NEWNET = 0x40000000
NODES = 3  # The server's, and two with ranks.
VIEW = {"camera": {"azimuth": 40}, "width": 120, "height": 90}
SILENCE = 4


def ip(*words):
    subprocess.run(["ip", *words], check=True, capture_output=True, text=True)


class Nodes:
    """Hosts h0, h1, h2 of a network 10.213.78.0/24. Who enters is on h0 until it leaves."""

    def __init__(self):
        self.mark = f"aeolic-{os.getpid()}"
        self.names = [f"{self.mark}-h{i}" for i in range(NODES)]
        self.switch = f"{self.mark}-switch"
        self.folder = tempfile.mkdtemp(prefix="aeolic_nodes_")

    def __enter__(self):
        self.home = os.open("/proc/self/ns/net", os.O_RDONLY)
        try:
            ip("netns", "add", self.switch)
            ip("-n", self.switch, "link", "add", "bridge", "type", "bridge")
            ip("-n", self.switch, "link", "set", "bridge", "up")
            for i, name in enumerate(self.names):
                ip("netns", "add", name)
                ip("link", "add", "v0", "netns", name, "type", "veth", "peer", "name", f"p{i}", "netns", self.switch)
                ip("-n", self.switch, "link", "set", f"p{i}", "master", "bridge", "up")
                ip("-n", name, "address", "add", f"10.213.78.{i + 1}/24", "dev", "v0")
                for device in ("lo", "v0"):
                    ip("-n", name, "link", "set", device, "up")
                # `ip netns exec` lays these files over those in /etc.
                os.makedirs(f"/etc/netns/{name}")
                with open(f"/etc/netns/{name}/hosts", "w") as hosts:
                    hosts.write("127.0.0.1 localhost\n" + "".join(f"10.213.78.{k + 1} h{k}\n" for k in range(NODES)))
            self.agent = os.path.join(self.folder, "agent")
            with open(self.agent, "w") as script:  # What ssh would do: HOST COMMAND…
                script.write("#!/bin/sh\nhost=$1\nshift\n"
                             f'exec ip netns exec {self.mark}-$host unshare --uts sh -c "hostname $host; $*"\n')
            os.chmod(self.agent, os.stat(self.agent).st_mode | stat.S_IXUSR)
            subprocess.run(self.inside(1) + ["true"], check=True, capture_output=True, text=True)
            self.enter(f"/run/netns/{self.names[0]}")
        except (OSError, subprocess.CalledProcessError) as error:
            self.__exit__()
            raise unittest.SkipTest(f"no hosts that are apart: {getattr(error, 'stderr', None) or error}") from error
        return self

    @staticmethod
    def enter(path):
        with open(path) as namespace:
            if ctypes.CDLL(None, use_errno=True).setns(namespace.fileno(), CLONE_NEWNET) != 0:
                raise OSError(ctypes.get_errno(), "setns")

    def __exit__(self, *_):
        ctypes.CDLL(None).setns(self.home, CLONE_NEWNET)
        os.close(self.home)
        for name in [*self.names, self.switch]:
            if os.path.exists("/run/netns/" + name):
                subprocess.run(["ip", "netns", "delete", name], check=False)
            shutil.rmtree(f"/etc/netns/{name}", ignore_errors=True)
        shutil.rmtree(self.folder, ignore_errors=True)

    def inside(self, node):
        return ["ip", "netns", "exec", self.names[node], "unshare", "--uts", "sh", "-c", f'hostname h{node}; exec "$@"', "sh"]

    def link(self, node, state):
        ip("-n", self.switch, "link", "set", f"p{node}", state)

    def server(self, *options, ranks=2):
        where = ",".join(f"h{1 + i % (NODES - 1)}:{ranks}" for i in range(NODES - 1))
        launcher = (f"mpirun -n {{ranks}} --host {where} --map-by node --mca plm_rsh_agent {self.agent} --mca plm_rsh_no_tree_spawn 1 "
                    "--mca oob_tcp_if_include v0 --mca btl_tcp_if_include v0 --mca btl tcp,self")
        return Server("--host", "10.213.78.1", "--ranks", str(ranks), "--launcher", launcher, "--silence-limit", str(SILENCE),
                      *options, inside=self.inside(0), environment=LAUNCHING)


def digest(frame):
    return hashlib.sha256(frame.pixels()).hexdigest()


class Apart(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.nodes = Nodes().__enter__()
        cls.addClassCleanup(cls.nodes.__exit__)
        with Server(inside=cls.nodes.inside(0)) as server, server.viewer() as viewer:
            cls.expected = digest(viewer.see(**VIEW))

    def hosts_of(self, server):
        """Where the ranks are: the host names that their processes see."""
        names = set()
        for pid in server.ranks(2):
            names.add(subprocess.run(["nsenter", "-t", str(pid), "-u", "hostname"], check=True, capture_output=True,
                                     text=True).stdout.strip())
        return names

    def test_stripes_and_bricks_relayed(self):
        for options in ((), ("--bricks", "on")):
            with self.subTest(options), self.nodes.server(*options) as server, server.viewer(timeout=120 * SLOW) as viewer:
                self.assertEqual(digest(viewer.see(**VIEW)), self.expected)
                self.assertEqual(self.hosts_of(server), {"h1", "h2"})

    def test_direct(self):
        with self.nodes.server("--direct") as server, server.viewer(timeout=120 * SLOW, direct=True) as viewer:
            viewer.until(lambda _: viewer.offer)
            self.assertEqual({one["host"] for one in viewer.offer}, {"10.213.78.2", "10.213.78.3"})
            links = [Viewer(f"http://{one['host']}:{one['port']}/?token={one['token']}", hello=False, path="/tiles")
                     for one in viewer.offer]
            viewer.view(**VIEW)
            self.assertEqual(digest(viewer.take_direct(links)), self.expected)
            for link in links:
                link.wire.close()

    def cut(self, drawing, *options):
        with self.nodes.server(*options) as server, server.viewer(timeout=240 * SLOW) as viewer:
            self.assertEqual(digest(viewer.see(**VIEW)), self.expected)
            old = server.ranks(2)
            for azimuth in range(5 if drawing else 0):
                viewer.see(moving=True, camera={"azimuth": azimuth})
            self.nodes.link(2, "down")
            try:
                began = time.monotonic()
                if drawing:
                    viewer.view(moving=True, camera={"azimuth": 7})
                viewer.wait_state("restarting", (SILENCE + 5) * SLOW)
                self.assertLess(time.monotonic() - began, (SILENCE + 5) * SLOW)
                # The rank that is cut off ends by itself. Nobody can tell it to.
                within(SILENCE + 5, lambda: not any(map(alive, old)), "the end of the ranks")
            finally:
                self.nodes.link(2, "up")
            viewer.wait_state("ready")
            self.assertEqual(digest(viewer.see(**VIEW)), self.expected)
            self.assertEqual(self.hosts_of(server), {"h1", "h2"})

    def test_a_link_is_cut_while_it_draws(self):
        self.cut(True)

    def test_a_link_is_cut_while_idle_with_bricks(self):
        self.cut(False, "--bricks", "on")


if __name__ == "__main__":
    reason = ("no mpirun, or a build without MPI" if not has_mpirun else "needs to be root" if os.geteuid() != 0 else
              "needs iproute2's ip and util-linux's unshare" if not (shutil.which("ip") and shutil.which("unshare")) else None)
    program = unittest.main(exit=False) if reason is None else None
    skipped = program and program.result.skipped
    if reason or (skipped and program.result.testsRun == 0):
        print(reason or skipped[0][1])
        sys.exit(77)
    sys.exit(not program.result.wasSuccessful())
