"""Whoever connects and does not play by the rules is turned away, and nobody else notices."""
import os
import random
import socket
import struct
import threading
import time
import unittest

import suite
from server import SLOW, Server, memory_bytes, open_files, run, within
from suite import waits
from viewer import CHANGE, FOLLOW, HELLO, NOTICE, SHOWN, TILE, VIEW, WELCOME, Closed, Refused, Viewer, message, upgrade, ws_frame

HELLO_JSON = {"codecs": ["jpeg", "png"], "name": "hostile"}
VIEW_JSON = {"view": 1, "moving": False, "width": 64, "height": 48}


class Bystander(threading.Thread):
    """A viewer that keeps moving. Its trouble is the test's."""

    def __init__(self, server):
        super().__init__(daemon=True)
        self.viewer, self.frames, self.trouble, self.stopping = server.viewer(name="bystander"), 0, None, False
        self.between = threading.Lock()  # Held while a picture of its own is on its way.
        self.viewer.loaded()
        self.start()

    def run(self):
        try:
            while not self.stopping:
                with self.between:
                    self.viewer.see(moving=True, camera={"azimuth": self.frames % 360}, width=40, height=30)
                    self.frames += 1
                time.sleep(1 / 60)  # Asks as often as a page does, or the server would send it away.
        except Exception as error:
            self.trouble = error

    def still_gets_frames(self, more=3):
        before = self.frames
        within(20, lambda: self.trouble or self.frames >= before + more, "frames for the bystander")
        if self.trouble:
            raise self.trouble

    def stop(self):
        self.stopping = True
        self.join(30 * SLOW)
        self.viewer.wire.close()


class Hostile(unittest.TestCase):
    """All tests share one server: what one client does must not harm the next."""

    @classmethod
    def setUpClass(cls):
        cls.server = Server()
        cls.bystander = Bystander(cls.server)

    @classmethod
    def tearDownClass(cls):
        cls.bystander.stop()
        cls.server.__exit__()

    def setUp(self):
        self.restarts = self.server.status()["restarts"]

    def tearDown(self):
        self.bystander.still_gets_frames()
        status = self.server.status()
        self.assertEqual(status["restarts"], self.restarts, "the job noticed")
        self.assertIsNone(self.server.process.poll(), "the gateway ended: " + self.server.log())
        # Clients that were sent away are gone.
        within(10, lambda: self.server.status()["viewers"] == 1, "the hostile viewer leaving")

    def joined(self, **options):
        return self.server.viewer(name="hostile", **options)

    def expect_end(self, viewer, code, reason=""):
        self.assertEqual(viewer.closed(20 * SLOW), code)
        self.assertIn(reason, viewer.farewell)
        viewer.wire.close()

    # Clients without a token.

    @waits(20)
    def test_wrong_tokens(self):
        for token in ("", "wrong", self.server.token[:-1], self.server.token + "x", self.server.token.swapcase(), "%00"):
            for path in ("/", "/status", "/stream", "/nothing"):
                wire = self.server.wire()
                wire.send(f"GET {path}?token={token} HTTP/1.1\r\nHost: x\r\nCookie: aeolic-0={token}\r\n\r\n".encode())
                answer = wire.rest()
                self.assertTrue(answer.startswith(b"HTTP/1.1 401 "), answer)
                self.assertTrue(answer.endswith(b"\r\n\r\n"), "a body")
                self.assertNotIn(b"erver", answer)
            if token != "%00":  # The viewer's own parsing of addresses cannot handle %00.
                with self.assertRaises(Refused) as refused:
                    Viewer(f"http://{self.server.host}:{self.server.port}/?token={token}")
                self.assertEqual(refused.exception.status, 401)
            with self.assertRaises(Refused):
                Viewer(f"http://{self.server.host}:{self.server.port}/")
        result = run("grab", f"http://{self.server.host}:{self.server.port}/?token=wrong", "-o",
                     os.path.join(self.server.folder, "x.png"))
        self.assertNotEqual(result.returncode, 0)
        self.assertEqual(len(result.stderr.splitlines()), 1)
        self.assertIn("token", result.stderr)

    def test_other_origins(self):
        own = f"http://{self.server.host}:{self.server.port}"
        for origin, status in ((own, b"101"), ("http://evil.example", b"403"), ("null", b"403"), ("https" + own[4:], b"403")):
            wire = self.server.wire()
            wire.send(upgrade("/stream?token=" + self.server.token, f"{self.server.host}:{self.server.port}",
                              f"Origin: {origin}\r\n"))
            self.assertIn(status, wire.until(b"\r\n\r\n")[:13], origin)
            wire.close()

    # What is not HTTP.

    def test_binary_junk_instead_of_http(self):
        dice = random.Random(1)
        for size in (1, 7, 100, 5000, 70000):
            wire = self.server.wire()
            try:
                wire.send(bytes(dice.randrange(256) for _ in range(size)))
                wire.socket.shutdown(socket.SHUT_WR)
            except (Closed, OSError):
                continue
            self.assertNotIn(b"200", wire.rest()[:20])

    def test_requests_that_are_too_large(self):
        token = self.server.token
        for request in (f"GET /?token={token} HTTP/1.1\r\nHost: x\r\nX: {'x' * 20000}\r\n\r\n",
                        f"GET /?token={token}&{'x' * 20000} HTTP/1.1\r\nHost: x\r\n\r\n",
                        f"GET /?token={token} HTTP/1.1\r\nHost: x\r\n" + "X: y\r\n" * 3000 + "\r\n",
                        f"POST /?token={token} HTTP/1.1\r\nHost: x\r\nContent-Length: 9999999999\r\n\r\n",
                        f"POST /?token={token} HTTP/1.1\r\nHost: x\r\nContent-Length: -1\r\n\r\n",
                        f"POST /?token={token} HTTP/1.1\r\nHost: x\r\nTransfer-Encoding: chunked\r\n\r\nffffffffff\r\n"):
            wire = self.server.wire()
            try:
                wire.send(request.encode())
            except Closed:
                continue
            self.assertNotIn(b" 200 ", wire.rest()[:20], request[:60])

    def test_pipelined_requests_are_answered_in_turn(self):
        wire = self.server.wire()
        one = f"GET /status?token={self.server.token} HTTP/1.1\r\nHost: x\r\n"
        wire.send((one + "\r\n" + one + "Connection: close\r\n\r\n").encode())
        self.assertEqual(wire.rest().count(b"HTTP/1.1 200 OK"), 2)

    @waits(11)
    def test_headers_that_come_a_byte_at_a_time_are_given_ten_seconds(self):
        slow = [self.server.wire() for _ in range(20)]
        half = [self.server.wire() for _ in range(20)]  # As many clients say nothing more at all.
        for wire in half:
            wire.send(b"GET / HTTP/1.1\r\nHo")
        start, open_ones = time.monotonic(), slow
        while open_ones and time.monotonic() - start < 40 * SLOW:
            still = []
            for wire in open_ones:
                try:
                    wire.socket.send(b"x")
                    still.append(wire)
                except OSError:
                    wire.close()
            open_ones = still
            time.sleep(0.25)
        self.assertFalse(open_ones, "they are still listened to")
        for wire in half:
            self.assertEqual(wire.rest(), b"")
            wire.close()

    # What is not a WebSocket.

    def test_frames_that_the_rules_of_websockets_forbid(self):
        good = message(VIEW, VIEW_JSON)
        for name, data in {
                "not masked": ws_frame(good, masked=False), "an unknown kind": ws_frame(good, opcode=5),
                "a continuation of nothing": ws_frame(good, opcode=0), "reserved bits": b"\xf2" + ws_frame(good)[1:],
                "a ping in pieces": ws_frame(b"x", opcode=9, fin=False), "a ping too long": ws_frame(b"x" * 200, opcode=9),
                "a close of one byte": ws_frame(b"x", opcode=8),
                "a close with a forbidden code": ws_frame(struct.pack(">H", 1005), opcode=8)}.items():
            with self.subTest(name):
                viewer = self.joined()
                viewer.wire.send(data)
                self.expect_end(viewer, 1002)

    def test_junk_after_the_handshake(self):
        dice = random.Random(2)
        for _ in range(20):
            viewer = self.joined(hello=False)
            try:
                viewer.wire.send(bytes(dice.randrange(256) for _ in range(300)))
                viewer.wire.socket.shutdown(socket.SHUT_WR)
            except (Closed, OSError):
                pass
            self.assertNotEqual(viewer.closed(20 * SLOW), "still open")
            viewer.wire.close()

    def test_messages_over_their_limit(self):
        viewer = self.joined()
        viewer.wire.send(ws_frame(b"", length=1 << 62))
        self.expect_end(viewer, 1009)
        # What the server has not read when it hangs up makes the system reset the connection, and the code may be lost.
        viewer = self.joined()
        viewer.wire.send(ws_frame(message(VIEW, b" " * (16 * 1024 + 1))))
        self.assertIn(viewer.closed(20 * SLOW), (1009, None))
        viewer.wire.close()
        viewer = self.joined()
        piece = ws_frame(b"x" * 1000, opcode=0, fin=False)
        try:
            viewer.wire.send(ws_frame(b"x", fin=False) + piece * 1000)  # In small pieces, without end.
        except Closed:
            pass
        self.assertIn(viewer.closed(20 * SLOW), (1009, None))
        viewer.wire.close()

    def test_half_a_frame_and_then_silence_or_the_end(self):
        whole = ws_frame(message(VIEW, VIEW_JSON))
        for count in (1, 3, 8, len(whole) - 1):
            viewer = self.joined()
            viewer.wire.send(whole[:count])
            self.bystander.still_gets_frames()
            viewer.wire.close()  # Half-open: it never says goodbye.

    # What is not a message of the protocol.

    def test_malformed_messages_are_a_protocol_error(self):
        for name, data in {
                "no header": b"", "half a header": message(VIEW, VIEW_JSON)[:5],
                "another magic": message(VIEW, VIEW_JSON, magic=0xAF), "another version": message(VIEW, VIEW_JSON, version=2),
                "a reserved byte": message(VIEW, VIEW_JSON, reserved=1), "truncated": message(VIEW, VIEW_JSON)[:-1],
                "too long": message(VIEW, VIEW_JSON) + b" ", "a length that lies": message(VIEW, VIEW_JSON, length=3),
                "the largest length": message(VIEW, VIEW_JSON, length=0xFFFFFFFF),
                "an unknown type": message(0x07), "a start of something": message(0x06, {}), "what the server says": message(WELCOME, {}),
                "what a rank says": message(TILE, b"x" * 30), "what the job is told": message(0x82, {}),
                "a notice": message(NOTICE, {"level": "error"}), "Hello twice": message(HELLO, HELLO_JSON),
                "not JSON": message(VIEW, b"{"), "not an object": message(VIEW, b"[]"), "not UTF-8": message(VIEW, b'{"a":"\xff"}'),
                "nested": message(VIEW, b'{"a":' + b"[" * 8000), "no view": message(VIEW, {}),
                "an unknown key": message(VIEW, {**VIEW_JSON, "field": {}}),
                "a negative size": message(VIEW, {**VIEW_JSON, "width": -1}),
                "no pixels": message(VIEW, {**VIEW_JSON, "width": 0}), "shown nothing": message(SHOWN),
                "shown too much": message(SHOWN, b"12345678"), "follow text": message(FOLLOW, b"x"),
                "an unknown change": message(CHANGE, {"field": "/etc/passwd"})}.items():
            with self.subTest(name):
                viewer = self.joined()
                viewer.wire.send(ws_frame(data))
                self.expect_end(viewer, 1002, "a view with an unknown key" if name == "an unknown key" else "")

    def test_text(self):
        viewer = self.joined()
        viewer.wire.send(ws_frame(b"hello", opcode=1))
        self.expect_end(viewer, 1002, "a text message")

    def test_first_messages_that_are_no_hello(self):
        for name, data in {"a view": message(VIEW, VIEW_JSON), "a hello without png": message(HELLO, {"codecs": ["jpeg"]}),
                           "a hello without codecs": message(HELLO, {}), "shown": message(SHOWN, 1)}.items():
            with self.subTest(name):
                viewer = self.joined(hello=False)
                viewer.wire.send(ws_frame(data))
                self.expect_end(viewer, 1002)

    @waits(5)
    def test_no_hello_in_time(self):
        viewer = self.joined(hello=False)
        start = time.monotonic()
        self.expect_end(viewer, 1008)
        self.assertGreater(time.monotonic() - start, 4)

    def test_too_many_requests(self):
        viewer = self.joined()
        shown = ws_frame(message(SHOWN, 0))
        try:
            for _ in range(200):
                viewer.wire.send(shown * 100)
        except Closed:
            pass
        self.assertIn(viewer.closed(20 * SLOW), (1008, None))
        viewer.wire.close()

    def test_random_damage_to_good_messages(self):
        """Each is answered, refused or hung up on, within the time; the tearDown sees what it does to others."""
        dice = random.Random(3)
        goods = [message(VIEW, {**VIEW_JSON, "camera": {"azimuth": 3.5}, "lic": {"steps": 4}}), message(FOLLOW, 1),
                 message(CHANGE, {"colorBy": "", "time": 0.5}), message(SHOWN, 3), message(HELLO, HELLO_JSON)]
        for _ in range(60):
            data = bytearray(dice.choice(goods))
            for _ in range(dice.randrange(1, 6)):
                data[dice.randrange(8 if dice.random() < 0.3 else len(data))] = dice.randrange(256)
            viewer = self.joined()
            viewer.wire.send(ws_frame(bytes(data)))
            viewer.wire.close()

    # Viewers that keep to the rules but behave badly.

    def test_who_never_reads_costs_no_memory(self):
        viewer = self.joined(receive_bytes=4096)
        before = memory_bytes(self.server.pid)
        for i in range(200):
            viewer.view(moving=True, width=800, height=600, camera={"azimuth": i})
            time.sleep(0.01)
        self.bystander.still_gets_frames()
        grown = memory_bytes(self.server.pid) - before
        viewer.wire.close()
        self.assertLess(grown, (30 << 20) * SLOW, "two frames, not two hundred")

    @waits(8)
    def test_who_says_shown_without_reading_costs_no_memory(self):
        viewer = self.joined(receive_bytes=4096)
        def for_others():
            with self.bystander.between:  # None of the bystander's is on its way, which the server may have counted.
                return self.server.status()["frames"] - self.bystander.frames

        before, drawn = memory_bytes(self.server.pid), for_others()
        lies, start, longest = 0, time.monotonic(), 25  # Who takes nothing for half a minute is sent away.
        while (took := time.monotonic() - start) < min(8 * SLOW, longest) or (took < longest and for_others() <= drawn):
            viewer.view(width=2000, height=2000, camera={"azimuth": lies})
            viewer.send(SHOWN, self.server.status()["frames"])
            lies += 1
            time.sleep(0.1)
        self.bystander.still_gets_frames()
        grown = memory_bytes(self.server.pid) - before
        drawn = for_others() - drawn
        viewer.wire.close()
        self.assertGreater(drawn, 0)
        self.assertLess(drawn, 7, "it has read none")  # The server cannot control what the system's own buffers take.
        self.assertLess(grown, (60 << 20) * SLOW, "two frames, not all that it says it has shown")

    @waits(32)
    def test_who_takes_no_byte_for_half_a_minute_is_disconnected(self):
        """It goes on saying that it has shown everything, so it is not idle. Who reads slowly stays."""
        stuck, slow = self.joined(receive_bytes=4096), self.joined(receive_bytes=4096)
        try:
            for viewer in (stuck, slow):
                viewer.view(width=1500, height=1500)
            start, gone = time.monotonic(), None
            while gone is None and time.monotonic() - start < 60 * SLOW:
                try:
                    stuck.send(SHOWN, self.server.status()["frames"])
                except Closed:
                    gone = time.monotonic() - start
                slow.wire.socket.recv(4096)
                slow.send(SHOWN, 0)
                self.bystander.still_gets_frames()
                time.sleep(0.5)
            self.assertIsNotNone(gone, "it is still there")
            self.assertGreater(gone, 25)
            self.assertLess(gone, 40 * SLOW)
            slow.send(SHOWN, 0)
        finally:
            stuck.wire.close()
            slow.wire.close()

    def test_many_who_come_and_go_leave_nothing(self):
        def files():
            return open_files(self.server.pid)
        before = files()
        for i in range(100):
            viewer = self.joined()
            if i % 3 == 0:
                viewer.view()
            if i % 3 == 1:
                viewer.wire.send(ws_frame(struct.pack(">H", 1000), 8))
            viewer.wire.close()
        within(20, lambda: files() <= before + 1, f"{before} files being open again")


if __name__ == "__main__":
    suite.main()
