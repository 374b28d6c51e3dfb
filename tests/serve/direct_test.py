"""Tiles that go from the ranks to viewers themselves."""
import os
import signal
import time
import unittest

import suite
from server import Server, has_mpirun
from suite import waits
from viewer import SHOWN, Refused, Viewer


class Direct(unittest.TestCase):
    """Tiles from the ranks themselves, past the gateway."""
    VIEW = {"camera": {"azimuth": 40}, "width": 90, "height": 60}

    def links(self, viewer):
        if viewer.offer is None:
            viewer.until(lambda _: viewer.offer)
        return [Viewer(f"http://{one['host'] or '127.0.0.1'}:{one['port']}/?token={one['token']}", hello=False, path="/tiles",
                       timeout=viewer.timeout) for one in viewer.offer]

    def same_bytes(self, ranks):
        with Server("--direct", "--ranks", str(ranks)) as server, server.viewer() as relayed, \
                server.viewer(direct=True) as direct:
            expected = relayed.see(**self.VIEW)
            links = self.links(direct.loaded())
            self.assertEqual(len(links), ranks)
            direct.view(**self.VIEW)
            frame = direct.take_direct(links)
            self.assertEqual(frame.pixels(), expected.pixels())
            # A viewer that hangs up there gets its tiles through the server.
            for link in links:
                link.wire.close()
            time.sleep(0.5)  # A tile that is on the way there is lost, and with it its frame.
            self.assertEqual(direct.see(**self.VIEW).pixels(), expected.pixels())

    def test_one_rank(self):
        self.same_bytes(1)

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    def test_three_ranks(self):
        self.same_bytes(3)

    def test_who_is_offered_but_never_connects_is_relayed_to(self):
        with Server("--direct") as server, server.viewer(direct=True) as viewer:
            viewer.see(**self.VIEW)
            self.assertTrue(viewer.offer)

    def test_who_does_not_ask_is_not_offered(self):
        with Server("--direct") as server, server.viewer() as viewer:
            viewer.see(**self.VIEW)
            self.assertIsNone(viewer.offer)
        with Server() as server, server.viewer(direct=True) as viewer:
            viewer.see(**self.VIEW)
            self.assertIsNone(viewer.offer)

    @waits(20)
    def test_a_token_opens_once_and_nothing_else(self):
        with Server("--direct") as server, server.viewer(direct=True) as viewer:
            viewer.loaded()
            link, = self.links(viewer)
            with self.assertRaises(Refused) as replayed:
                self.links(viewer)
            self.assertEqual(replayed.exception.status, 401)
            host, port, token = "127.0.0.1", viewer.offer[0]["port"], viewer.offer[0]["token"]
            for path, given in (("/tiles", ""), ("/tiles", "x"), ("/tiles", server.token), ("/stream", token), ("/", token)):
                with self.assertRaises(Refused) as refused:
                    Viewer(f"http://{host}:{port}/?token={given}", hello=False, path=path)
                self.assertEqual(refused.exception.status, 401)
            link.send(SHOWN, 1)  # Any message to a rank ends the connection.
            self.assertNotEqual(link.closed(), "still open")
            viewer.see(**self.VIEW)

    def test_a_killed_rank_is_offered_anew(self):
        with Server("--direct") as server, server.viewer(direct=True) as viewer:
            before = viewer.see(**self.VIEW).pixels()
            viewer.offer = None
            os.kill(server.ranks(1)[0], signal.SIGKILL)
            frame = viewer.take_direct(self.links(viewer))  # The view comes back by itself, whichever way.
            self.assertTrue(frame.lossless)
            self.assertEqual(frame.pixels(), before)


if __name__ == "__main__":
    suite.main()
