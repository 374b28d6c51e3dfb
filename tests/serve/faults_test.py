"""The render job dies, in every way it can: viewers stay connected, and their views come back."""
import json
import os
import random
import signal
import stat
import tempfile
import time
import unittest

from server import SLOW, Server, alive, gl_faults, has_gl, has_mpirun, memory_bytes, open_files, parent_of, within
from viewer import CHANGE

VIEW = {"camera": {"azimuthDeg": 33, "elevationDeg": 12}, "width": 90, "height": 70}


class Killed(unittest.TestCase):
    def kill_while_moving(self, server, victim, ranks):
        """Ends a process of the job while a viewer moves; the same view must come back on the same connection."""
        with server.viewer(timeout=120 * SLOW) as viewer, server.viewer() as resting:
            before = viewer.see(**VIEW).pixels()
            self.assertEqual(resting.see(**VIEW).pixels(), before)
            restarts = server.status()["restarts"]
            for azimuth in range(5):
                viewer.see(moving=True, camera={"azimuthDeg": azimuth})
            viewer.states.clear()
            for azimuth in range(5):
                viewer.view(moving=True, camera={"azimuthDeg": azimuth})
            os.kill(victim, signal.SIGKILL)
            viewer.wait_state("restarting", 30 * SLOW)
            last = viewer.view(**VIEW)
            after = viewer.picture(last)
            self.assertTrue(after.lossless)
            self.assertEqual(after.pixels(), before)
            self.assertIn("restarting", viewer.states)
            # A viewer that did nothing gets its view again without asking.
            self.assertEqual(resting.picture().pixels(), before)
            self.assertGreater(server.status()["restarts"], restarts)
            self.assertEqual(len(server.ranks(ranks)), ranks)

    def test_the_only_rank(self):
        with Server() as server:
            for _ in range(3):
                self.kill_while_moving(server, server.ranks(1)[0], 1)

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    def test_each_of_three_ranks(self):
        with Server("--ranks", "3") as server:
            for rank in range(3):
                old = server.ranks(3)
                self.kill_while_moving(server, old[rank], 3)
                within(10, lambda: not any(map(alive, old)), "the end of the other ranks")

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    def test_the_launcher(self):
        with Server("--ranks", "2") as server:
            old = server.ranks(2)
            launcher = parent_of(old[0])
            self.assertNotEqual(launcher, server.pid)
            self.kill_while_moving(server, launcher, 2)
            within(10, lambda: not any(map(alive, old)), "the end of its ranks")

    def test_a_rank_that_hangs_up_without_dying_first(self):
        """A job that is stopped says nothing and does not end. Viewers stay, and the server still listens."""
        with Server() as server, server.viewer() as viewer:
            viewer.see(**VIEW)
            pid = server.ranks(1)[0]
            os.kill(pid, signal.SIGSTOP)
            viewer.view(**VIEW)
            self.assertEqual(server.status()["state"], "rendering")
            os.kill(pid, signal.SIGCONT)
            viewer.picture(viewer.last_view)
            os.kill(pid, signal.SIGSTOP)
            os.kill(pid, signal.SIGKILL)  # SIGKILL works on stopped processes, too.
            viewer.wait_state("restarting", 20 * SLOW)
            viewer.wait_state("ready", 60 * SLOW)

    def test_loading_is_interrupted(self):
        with Server() as server, server.viewer() as viewer:
            before = viewer.see(**VIEW).pixels()
            viewer.send(CHANGE, {"colorBy": "rotation:mag"})
            os.kill(server.ranks(1)[0], signal.SIGKILL)
            viewer.wait_state("restarting", 20 * SLOW)
            viewer.wait_state("ready", 60 * SLOW)
            after = viewer.see(**VIEW)
            if viewer.scene["scene"]["shading"].get("colorBy", "") == "":
                self.assertEqual(after.pixels(), before)

    def test_viewers_who_come_while_it_is_away(self):
        with Server() as server, server.viewer() as viewer:
            before = viewer.see(**VIEW).pixels()
            os.kill(server.ranks(1)[0], signal.SIGKILL)
            viewer.wait_state("restarting", 20 * SLOW)
            with server.viewer() as late:
                self.assertEqual(late.see(**VIEW).pixels(), before)

    def test_ten_deaths_leave_nothing_behind(self):
        with Server() as server, server.viewer(timeout=120 * SLOW) as viewer:
            viewer.see(**VIEW)
            files, memory = None, None
            for death in range(10):
                os.kill(server.ranks(1)[0], signal.SIGKILL)
                viewer.wait_state("restarting", 30 * SLOW)
                viewer.wait_state("ready", 60 * SLOW)
                viewer.see(**VIEW)
                if death == 1:
                    files, memory = open_files(server.pid), memory_bytes(server.pid)
            self.assertEqual(open_files(server.pid), files)
            self.assertLess(memory_bytes(server.pid), memory + (8 << 20))
            self.assertEqual(len(server.strays()), 1)


@unittest.skipUnless(has_gl(), "no OpenGL in this build or on this machine, or with sanitizers")
class DeviceFails(unittest.TestCase):
    """The GPU is reset: the rank says so and ends, another is started, and the views come back."""

    def reset(self, *options, ranks=1):
        with tempfile.TemporaryDirectory() as folder:
            mark = os.path.join(folder, "reset")
            environment = {"LD_PRELOAD": gl_faults, "AEOLIC_TEST_RESET": mark}
            with Server("--backend", "gl", *options, environment=environment) as server, \
                    server.viewer(timeout=120 * SLOW) as viewer:
                before = viewer.see(**VIEW).pixels()
                old = server.ranks(ranks)
                with open(mark, "w"):
                    viewer.view(**VIEW)
                    viewer.wait_state("restarting", 30 * SLOW)
                os.remove(mark)
                within(60, lambda: server.status()["state"] == "ready" and server.ranks(ranks) != old, "another start")
                self.assertEqual(viewer.see(**VIEW).pixels(), before)
                within(10, lambda: not any(map(alive, old)), "the end of the ranks")
                self.assertIn("it was reset for what this rank drew, and its context is lost", server.log())

    def test_the_only_rank(self):
        self.reset()

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    def test_two_ranks(self):
        self.reset("--ranks", "2", ranks=2)


def script(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w") as file:
        file.write("#!/bin/sh\n" + text)
    os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
    return path


class NeverStarts(unittest.TestCase):
    def expect_failed(self, server, text, seconds):
        with server.viewer(timeout=seconds * SLOW) as viewer:
            viewer.wait_state("failed")
            self.assertIn(text, viewer.state["message"])
            self.assertEqual(server.status()["state"], "failed")
            # Later viewers are told so, the server still answers, and the job is not started again and again.
            before, start = cpu_seconds(server.pid), time.monotonic()
            with server.viewer() as late:
                late.wait_state("failed", 10 * SLOW)
            time.sleep(2)
            busy = (cpu_seconds(server.pid) - before) / (time.monotonic() - start)
            self.assertLess(busy, 0.2, "a busy loop")
            self.assertEqual(server.strays(), [])

    def test_a_launcher_that_ends_at_once_is_tried_six_times(self):
        with Server("--launcher", "sh -c 'echo x >>starts; exit 3'") as server:
            start = time.monotonic()
            self.expect_failed(server, "ended with code 3; given up after 6 starts", 90)
            self.assertGreater(time.monotonic() - start, 3, "with pauses between")
            with open(os.path.join(server.folder, "starts")) as starts:
                self.assertEqual(len(starts.readlines()), 6)

    def test_a_job_that_ends_after_joining(self):
        """It loads the scene and dies, again and again: that is no start to count on either."""
        with Server("--launcher", "sh -c '\"$@\" & pid=$!; sleep 0.7; kill -9 $pid; wait' sh") as server:
            self.expect_failed(server, "given up after 6 starts", 120)


def cpu_seconds(pid):
    with open(f"/proc/{pid}/stat") as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


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
        for number in (signal.SIGTERM, signal.SIGINT):
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

    def test_asked_to_while_it_loads_or_waits(self):
        for options in ([], ["--launcher", "sh -c 'sleep 60'"], ["--launcher", "false"]):
            with Server(*options) as server:
                time.sleep(random.Random(len(options)).random() / 2)
                server.process.terminate()
                server.process.wait(10 * SLOW)
                self.assertEqual(server.process.returncode, 0, options)
                within(5, lambda: not server.strays(), "the end of all it started")

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

    def test_asked_to_while_the_job_does_not_listen(self):
        with Server() as server:
            os.kill(server.ranks(1)[0], signal.SIGSTOP)
            server.process.terminate()
            server.process.wait(10 * SLOW)
            self.assertEqual(server.process.returncode, 0)
            within(5, lambda: not server.strays(), "the end of all it started")


if __name__ == "__main__":
    unittest.main()
