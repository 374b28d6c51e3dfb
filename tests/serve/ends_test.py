"""The server ends, however it is asked to, and nothing it started stays."""
import os
import random
import signal
import time
import unittest

import suite
from server import SLOW, Server, alive, has_mpirun, within
from suite import waits

VIEW = {"camera": {"azimuth": 33, "elevation": 12}, "width": 90, "height": 70}


class Ends(unittest.TestCase):
    def end(self, number, *options):
        with Server(*options) as server, server.viewer() as viewer:
            viewer.see(**VIEW)
            pids = server.ranks()
            start = time.monotonic()
            server.process.send_signal(number)
            code = viewer.closed(10 * SLOW)
            server.process.wait(10 * SLOW)
            took = time.monotonic() - start
            # A rank that is dying has no environment left to recognise it by, but it still exists.
            within(5, lambda: not server.strays() and not any(map(alive, pids)), "the end of all it started")
            return code, server.process.returncode, took

    def test_asked_to(self):
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
            code, status, took = self.end(number)
            self.assertEqual((code, status), (1001, 0))
            self.assertLess(took, 5 * SLOW)

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    def test_asked_to_with_three_ranks(self):
        code, status, took = self.end(signal.SIGTERM, "--ranks", "3")
        self.assertEqual((code, status), (1001, 0))
        self.assertLess(took, 8 * SLOW)

    def test_killed(self):
        code, status, _ = self.end(signal.SIGKILL)
        self.assertEqual((code, status), (None, -signal.SIGKILL))

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    def test_killed_with_three_ranks(self):
        code, status, _ = self.end(signal.SIGKILL, "--ranks", "3")
        self.assertEqual((code, status), (None, -signal.SIGKILL))

    @waits(4)
    def test_asked_to_while_it_loads_or_waits(self):
        for options in ([], ["--launcher", "sh -c 'sleep 60'"], ["--launcher", "false"]):
            with Server(*options) as server:
                time.sleep(random.Random(len(options)).random() / 2)
                server.process.terminate()
                server.process.wait(10 * SLOW)
                self.assertEqual(server.process.returncode, 0, options)
                within(5, lambda: not server.strays(), "the end of all it started")

    def test_asked_to_before_the_rank_has_joined(self):
        """It is asked to leave as soon as it is there, instead of being waited for in vain."""
        took = []
        for _ in range(3):  # One of them is undisturbed.
            with Server() as server:
                start = time.monotonic()
                server.process.terminate()
                server.process.wait(10 * SLOW)
                took.append(time.monotonic() - start)
                self.assertEqual((server.process.returncode, server.log()), (0, ""))
                within(5, lambda: not server.strays(), "the end of all it started")
        self.assertLess(min(took), 1 * SLOW)

    def test_asked_twice(self):
        """The second signal ends it at once, whatever the first waits for: a job that ignores SIGTERM."""
        for number in (signal.SIGINT, signal.SIGTERM):
            with Server("--launcher", "sh -c 'trap \"\" TERM; while :; do sleep 1; done'") as server:
                time.sleep(0.3)
                server.process.send_signal(number)
                time.sleep(0.3)
                self.assertIsNone(server.process.poll(), "it asks the job first")
                second = time.monotonic()
                server.process.send_signal(number)
                server.process.wait(10 * SLOW)
                self.assertLess(time.monotonic() - second, 0.5 * SLOW)
                self.assertEqual(server.process.returncode, -number)

    def test_asked_to_while_viewers_do_not_listen(self):
        with Server() as server:
            viewers = [server.viewer(receive_bytes=4096) for _ in range(3)]
            for viewer in viewers:
                for _ in range(3):
                    viewer.view(width=900, height=900)
            time.sleep(1)
            server.process.terminate()
            server.process.wait(10 * SLOW)
            self.assertEqual(server.process.returncode, 0)
            for viewer in viewers:
                viewer.wire.close()

    @waits(4)
    def test_asked_to_while_the_job_does_not_listen(self):
        with Server() as server:
            os.kill(server.ranks(1)[0], signal.SIGSTOP)
            server.process.terminate()
            server.process.wait(10 * SLOW)
            self.assertEqual(server.process.returncode, 0)
            within(5, lambda: not server.strays(), "the end of all it started")


if __name__ == "__main__":
    suite.main()
