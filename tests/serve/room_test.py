"""There is room for so many viewers, connections and unread pictures, and no more."""
import os
import signal
import socket
import unittest

import suite
from server import SLOW, Server, memory_bytes, run, within
from viewer import FRAME_END, HELLO, SHOWN, TILE, Closed, Viewer

HELLO_JSON = {"codecs": ["jpeg", "png"], "name": "hostile"}


class Direct(unittest.TestCase):
    """A viewer that a rank sends tiles to. It reads none of them, but says that it has shown each frame."""

    def test_who_reads_nothing_of_a_rank_costs_it_no_memory(self):
        with Server("--direct") as server, server.viewer(direct=True, codecs=["png"]) as viewer, server.viewer() as honest:
            viewer.until(lambda _: viewer.offer)
            place, = viewer.offer
            address = f"http://127.0.0.1:{place['port']}/?token={place['token']}"
            with Viewer(address, hello=False, path="/tiles", receive_bytes=4096):
                rank, memory, relayed = server.ranks(1)[0], [], 0
                for azimuth in range(30):
                    viewer.view(width=1200, height=1200, camera={"azimuth": azimuth})
                    ended = False
                    while not ended:
                        data = viewer.receive()
                        relayed += data[2] == TILE
                        ended = data[2] == FRAME_END
                    viewer.send(SHOWN, server.status()["frames"])
                    memory.append(memory_bytes(rank))
                    honest.see()  # A viewer that answers no pings for half a minute is taken for gone.
            self.assertGreater(relayed, 10, "it gets what it leaves by the other way, where it is counted as well")
            self.assertLess(memory[-1] - memory[4], (16 << 20) * SLOW, "two frames, not thirty")


class Memory(unittest.TestCase):
    def test_many_who_read_nothing_share_one_budget(self):
        room = 32 << 20
        with Server("--viewer-memory", str(room >> 20)) as server, server.viewer() as honest:
            before = honest.see(width=300, height=300).pixels()
            start = memory_bytes(server.pid)
            rude, most = [server.viewer(receive_bytes=4096, codecs=["png"]) for _ in range(20)], 0
            for turn in range(12):
                for viewer in rude:
                    try:
                        viewer.view(width=1400, height=1400, camera={"azimuth": turn})
                        viewer.send(SHOWN, server.status()["frames"])
                    except Closed:
                        pass  # What the test is about.
                self.assertEqual(honest.see(width=300, height=300).pixels(), before)
                most = max(most, memory_bytes(server.pid) - start)
            for viewer in rude:
                viewer.wire.close()
            self.assertEqual(server.status()["restarts"], 0)
            self.assertLess(most, 2 * room * SLOW)
            within(20, lambda: server.status()["viewers"] == 1, "their leaving")


class Full(unittest.TestCase):
    def test_one_viewer_too_many(self):
        with Server("--max-viewers", "2") as server, server.viewer() as ann, server.viewer() as bob:
            viewer = server.viewer(hello=False)
            viewer.send(HELLO, HELLO_JSON)
            self.assertEqual(viewer.closed(), 1013)
            result = run("grab", server.address, "-o", os.path.join(server.folder, "x.png"))
            self.assertEqual(result.returncode, 1)
            self.assertIn("1013", result.stderr)
            ann.see()
            bob.wire.close()
            within(10, lambda: server.status()["viewers"] == 1, "bob leaving")
            with server.viewer() as cleo:
                cleo.see()

    def test_more_connections_than_files(self):
        """A flood of connections that say nothing: viewers stay, and even the job can be started again meanwhile."""
        with Server(files=128) as server, server.viewer() as ann:
            before = ann.see().pixels()
            rank = server.ranks(1)[0]
            flood = []
            for _ in range(300):
                flood.append(socket.create_connection((server.host, server.port), 20 * SLOW))
            self.assertEqual(ann.see().pixels(), before)
            os.kill(rank, signal.SIGKILL)
            ann.wait_state("restarting", 20 * SLOW)
            ann.wait_state("ready", 60 * SLOW)
            self.assertEqual(ann.see().pixels(), before)
            for sock in flood:
                sock.close()
            within(30, lambda: answers(server), "the status being told again")


def answers(server):
    try:
        return server.status()["viewers"] == 1
    except OSError:
        return False


if __name__ == "__main__":
    suite.main()
