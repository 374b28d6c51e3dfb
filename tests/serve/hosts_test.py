"""A server on one host and a viewer on another: two network namespaces with a cable between them."""
import hashlib
import os
import shutil
import subprocess
import sys
import unittest

import suite
from server import Server, has_mpirun
from viewer import Viewer, split

SERVER_ADDRESS, VIEWER_ADDRESS = "10.213.77.1", "10.213.77.2"
VIEW = {"camera": {"azimuth": 40}, "width": 90, "height": 60}


def look(address, way):
    """On the viewer's host: prints the picture's digest and how it came."""
    host, _, _ = split(address)
    with Viewer(address, direct=way == "direct") as viewer:
        viewer.loaded()
        if way == "relay":
            frame = viewer.see(**VIEW)
        else:
            if viewer.offer is None:
                viewer.until(lambda _: viewer.offer)
            links = [Viewer(f"http://{one['host'] or host}:{one['port']}/?token={one['token']}", hello=False, path="/tiles")
                     for one in viewer.offer]
            viewer.view(**VIEW)
            frame = viewer.take_direct(links)
        print(hashlib.sha256(frame.pixels()).hexdigest(), len(viewer.offer or []))


class TwoHosts:
    """Made when entered; gone afterwards."""

    def __init__(self):
        self.names = [f"aeolic-{os.getpid()}-{end}" for end in ("server", "viewer")]

    def __enter__(self):
        try:
            for name in self.names:
                self.ip("netns", "add", name)
            self.ip("link", "add", "v0", "netns", self.names[0], "type", "veth", "peer", "name", "v0", "netns", self.names[1])
            for name, address in zip(self.names, (SERVER_ADDRESS, VIEWER_ADDRESS)):
                self.ip("-n", name, "address", "add", address + "/24", "dev", "v0")
                for device in ("lo", "v0"):
                    self.ip("-n", name, "link", "set", device, "up")
        except (OSError, subprocess.CalledProcessError) as error:
            self.__exit__()
            raise unittest.SkipTest(f"no network namespaces here: {getattr(error, 'stderr', None) or error}") from error
        return self

    def __exit__(self, *_):
        for name in self.names:
            if os.path.exists("/run/netns/" + name):
                subprocess.run(["ip", "netns", "delete", name], check=False)

    @staticmethod
    def ip(*words):
        subprocess.run(["ip", *words], check=True, capture_output=True, text=True)

    def inside(self, end):
        return ["ip", "netns", "exec", self.names[end]]


@unittest.skipUnless(shutil.which("ip") and os.geteuid() == 0, "needs the right to make network namespaces, and iproute2's ip")
class OtherHost(unittest.TestCase):
    def seen(self, hosts, server, way):
        _, port, token = split(server.address)
        address = f"http://{SERVER_ADDRESS}:{port}/?token={token}"
        done = subprocess.run([*hosts.inside(1), sys.executable, __file__, "--look", address, way], capture_output=True, text=True,
                              timeout=60, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        digest, offers = done.stdout.split()
        return digest, int(offers)

    def same_picture_both_ways(self, ranks):
        with TwoHosts() as hosts, Server("--host", "0.0.0.0", "--direct", "--ranks", str(ranks), inside=hosts.inside(0)) as server:
            relayed, none = self.seen(hosts, server, "relay")
            direct, offers = self.seen(hosts, server, "direct")
            self.assertEqual((none, offers), (0, ranks))
            self.assertEqual(relayed, direct)

    def test_one_rank(self):
        self.same_picture_both_ways(1)

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    def test_three_ranks(self):
        self.same_picture_both_ways(3)

    def test_loopback_is_not_for_others(self):
        with TwoHosts() as hosts, Server(inside=hosts.inside(0)) as server:
            _, port, token = split(server.address)
            done = subprocess.run([*hosts.inside(1), sys.executable, __file__, "--look",
                                   f"http://{SERVER_ADDRESS}:{port}/?token={token}", "relay"], capture_output=True, text=True,
                                  timeout=60, check=False)
            self.assertIn("ConnectionRefusedError", done.stderr)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--look"]:
        look(*sys.argv[2:])
    else:
        suite.main()
