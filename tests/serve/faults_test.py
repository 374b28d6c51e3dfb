"""The render job dies, in every way it can: viewers stay connected, and their views come back."""
import array
import os
import re
import signal
import stat
import tempfile
import time
import unittest

import suite
from server import SLOW, Server, alive, gl_faults, has_gl, has_mpirun, memory_bytes, open_files, parent_of, within
from suite import waits
from viewer import CHANGE, START, JobLost

VIEW = {"camera": {"azimuth": 33, "elevation": 12}, "width": 90, "height": 70}


class Killed(unittest.TestCase):
    def kill_while_moving(self, server, victim, ranks):
        """Ends a process of the job while a viewer moves; the same view must come back on the same connection."""
        with server.viewer(timeout=120 * SLOW) as viewer, server.viewer() as resting:
            before = viewer.see(**VIEW).pixels()
            self.assertEqual(resting.see(**VIEW).pixels(), before)
            restarts = server.status()["restarts"]
            for azimuth in range(5):
                viewer.see(moving=True, camera={"azimuth": azimuth})
            viewer.states.clear()
            for azimuth in range(5):
                viewer.view(moving=True, camera={"azimuth": azimuth})
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

    def stopped_while(self, drawing, *options, ranks=1):
        """Stops a rank with SIGSTOP. The job is started again, with the views there were, and nothing of the old is left."""
        limit = 3
        with Server("--silence-limit", str(limit), "--ranks", str(ranks), *options) as server, \
                server.viewer(timeout=120 * SLOW) as viewer:
            before = viewer.see(**VIEW).pixels()
            old = server.ranks(ranks)
            time.sleep(2 * limit)
            self.assertEqual(server.ranks(ranks), old, "who says nothing but answers pings is alive")
            os.kill(old[-1], signal.SIGSTOP)
            stopped = time.monotonic()
            if drawing:
                viewer.view(**VIEW)
            viewer.wait_state("restarting", (limit + 5) * SLOW)
            self.assertIn(f"rank {ranks - 1} on ", viewer.state["message"])
            self.assertIn(f"has not answered for {limit} s", viewer.state["message"])
            within(limit + 5 - (time.monotonic() - stopped), lambda: server.ranks(ranks) and not set(server.ranks(ranks)) & set(old),
                   "another start")
            viewer.wait_state("ready", 60 * SLOW)
            self.assertEqual(viewer.see(**VIEW).pixels(), before)
            within(5, lambda: not any(map(alive, old)), "the end of the stopped rank and the others")

    @waits(10)
    def test_the_only_rank_stops_while_idle(self):
        self.stopped_while(False)

    @waits(10)
    def test_the_only_rank_stops_while_it_draws(self):
        self.stopped_while(True)

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    @waits(10)
    def test_one_of_three_ranks_stops_while_idle(self):
        self.stopped_while(False, ranks=3)

    @unittest.skipUnless(has_mpirun, "no mpirun, or a build without MPI")
    @waits(10)
    def test_one_of_three_ranks_stops_while_it_draws(self):
        self.stopped_while(True, ranks=3)

    @waits(6)
    def test_drawing_for_long_is_not_silence_but_has_a_limit_of_its_own(self):
        with Server("--silence-limit", "2", "--draw-limit", "6", "--threads", "1") as server, \
                server.viewer(timeout=120 * SLOW) as viewer:
            before = viewer.see(**VIEW).pixels()
            began = time.monotonic()
            viewer.view(width=4096, height=4096, lic={"method": "direct", "steps": 510}, camera={"azimuth": 1})
            viewer.view(**VIEW)  # It waits. Sent later, it might come when the renderer is back and draws the costly one again.
            viewer.wait_state("restarting", 20 * SLOW)
            self.assertGreater(time.monotonic() - began, 5)
            self.assertIn("took more than 6 s for one picture", viewer.state["message"])
            viewer.wait_state("ready", 60 * SLOW)
            self.assertEqual(viewer.see(**VIEW).pixels(), before)

    @waits(4)
    def test_a_rank_does_not_outlive_a_silent_server_for_long(self):
        """The server is stopped, as a host that vanished would be: its ranks end. When it goes on, it starts others."""
        with Server("--silence-limit", "3") as server, server.viewer(timeout=120 * SLOW) as viewer:
            before = viewer.see(**VIEW).pixels()
            rank = server.ranks(1)[0]
            os.kill(server.pid, signal.SIGSTOP)
            try:
                within(3 + 5, lambda: not alive(rank), "the rank's end")
            finally:
                os.kill(server.pid, signal.SIGCONT)
            viewer.wait_state("restarting", 20 * SLOW)
            viewer.wait_state("ready", 60 * SLOW)
            self.assertEqual(viewer.see(**VIEW).pixels(), before)

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


class Isosurface(unittest.TestCase):
    def test_one_that_memory_has_no_room_for_is_refused_and_the_job_lives(self):
        """Values that alternate from sample to sample: some four triangles in each cell."""
        side = 120
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "f.nhdr")
            with open(path, "w") as header:
                header.write("NRRD0004\ntype: float\ndimension: 4\n"
                             f"sizes: 3 {side} {side} {side}\nspacings: nan 1 1 1\n"
                             "kinds: vector domain domain domain\nendian: little\nencoding: raw\ndata file: f.raw\n")
            with open(os.path.join(folder, "f.raw"), "wb") as data:
                low, high = array.array("f", [1, 0, 0]).tobytes(), array.array("f", [2, 0, 0]).tobytes()
                odd, even = (low + high) * (side // 2), (high + low) * (side // 2)
                data.write(((odd + even) * (side // 2) + (even + odd) * (side // 2)) * (side // 2))
            scene = ["--surface", "boundary", "--field", path, "--steps", "8"]
            with Server(scene=scene) as server, server.viewer() as viewer:
                viewer.see(**VIEW)
                with open(f"/proc/{server.ranks(1)[0]}/status") as status:
                    takes = int(re.search(r"VmPeak:\s+(\d+)", status.read())[1])  # KiB
                vectors = viewer.scene["choices"]["vectors"][0]
            with Server("--launcher", f"sh -c 'ulimit -v {takes + 400_000}; exec \"$@\"' sh", scene=scene) as server, \
                    server.viewer(timeout=120 * SLOW) as viewer:
                before = viewer.see(**VIEW).pixels()
                viewer.send(CHANGE, {"surface": f"isosurface:{vectors}:mag=1.5"})
                viewer.until(lambda _: viewer.notices)
                self.assertIn("million triangles", viewer.notices[0]["message"])
                self.assertIn("of memory that is available", viewer.notices[0]["message"])
                self.assertEqual(viewer.see(**VIEW).pixels(), before)
                self.assertEqual(server.status()["restarts"], 0)


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

    def test_whatever_it_draws(self):
        """The view is not tried a third time. A test that waits for it ends then, and not when its time is up."""
        with tempfile.NamedTemporaryFile(prefix="aeolic_reset_") as mark:
            environment = {"LD_PRELOAD": gl_faults, "AEOLIC_TEST_RESET": mark.name}
            with Server("--backend", "gl", environment=environment) as server, server.viewer(timeout=120 * SLOW) as viewer:
                start = time.monotonic()
                with self.assertRaisesRegex(JobLost, "not tried again"):
                    viewer.see(**VIEW)
                self.assertLess(time.monotonic() - start, 30 * SLOW)
                self.assertEqual(server.status()["restarts"], 2)

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

    @waits(10)
    def test_a_launcher_that_ends_at_once_is_tried_six_times(self):
        with Server("--launcher", "sh -c 'echo x >>starts; exit 3'") as server:
            start = time.monotonic()
            self.expect_failed(server, "ended with code 3; given up after 6 starts", 90)
            self.assertGreater(time.monotonic() - start, 3, "with pauses between")
            with open(os.path.join(server.folder, "starts")) as starts:
                self.assertEqual(len(starts.readlines()), 6)

    @waits(10)
    def test_what_the_launcher_said_last_is_told(self):
        ruler = "-" * 30
        says = f"sh -c 'echo {ruler}; echo There are not enough slots >&2; echo {ruler}; exit 1'"
        with Server("--launcher", says) as server:
            self.expect_failed(server, "ended with code 1: There are not enough slots; given up after 6 starts", 90)

    @waits(14)
    def test_a_viewer_asks_for_another_start(self):
        """What was wrong with the launcher is put right meanwhile."""
        with Server("--launcher", "sh -c 'test -e mended || exit 3; exec \"$@\"' sh") as server:
            with server.viewer(timeout=90 * SLOW) as viewer:
                viewer.wait_state("failed")
                viewer.send(START)
                viewer.until(lambda _: viewer.state["state"] != "failed", 10 * SLOW)
                viewer.wait_state("failed")
                self.assertIn("given up after 6 starts", viewer.state["message"])
                with open(os.path.join(server.folder, "mended"), "w"):
                    time.sleep(5)  # Nobody may ask all the time.
                viewer.send(START)
                viewer.wait_state("ready", 60 * SLOW)
                viewer.see(**VIEW)

    @waits(15)
    def test_a_job_that_ends_after_joining(self):
        """It loads the scene and dies, again and again: that is no start to count on either."""
        with Server("--launcher", "sh -c '\"$@\" & pid=$!; sleep 0.7; kill -9 $pid; wait' sh") as server:
            self.expect_failed(server, "given up after 6 starts", 120)


def cpu_seconds(pid):
    with open(f"/proc/{pid}/stat") as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


if __name__ == "__main__":
    suite.main()
