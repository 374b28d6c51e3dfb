"""A viewer without a window, of Python's standard library alone: what the tests and the soak drive a server with.

It is no second client library but a second reading of docs/protocol.md: whatever the server sends that is not as it is
written there fails the test.
"""
import base64
import json
import os
import socket
import struct
import time
import urllib.parse
import zlib

HELLO, VIEW, SHOWN, CHANGE, FOLLOW, START, PICK = 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07
WELCOME, STATE, SCENE, FRAME, TILE, FRAME_END, NOTICE, OFFER, CHANGED, PICKED = range(0x41, 0x4B)
RAW, JPEG, PNG, LZ4, LZO = range(5)


class Closed(Exception):
    """The server hung up: with a WebSocket close code, or, None, without a word."""

    def __init__(self, code, reason=""):
        super().__init__(f"closed with {code} {reason}")
        self.code, self.reason = code, reason


class JobLost(AssertionError):
    """A picture is waited for that will not come: the job was given up, or it dies whatever it draws."""


class Refused(Exception):
    """The server answered the upgrade with something else than 101."""

    def __init__(self, status, head):
        super().__init__(f"refused with {status}")
        self.status, self.head = status, head


def split(address):
    """host, port, token of an address as the server prints it."""
    parts = urllib.parse.urlsplit(address)
    return parts.hostname, parts.port, urllib.parse.parse_qs(parts.query).get("token", [""])[0]


def message(kind, payload=b"", magic=0xAE, version=1, reserved=0, length=None):
    if isinstance(payload, dict):
        payload = json.dumps(payload).encode()
    elif isinstance(payload, int):
        payload = struct.pack("<I", payload)
    return struct.pack("<BBBBI", magic, version, kind, reserved, len(payload) if length is None else length) + payload


def ws_frame(payload, opcode=2, fin=True, length=None, masked=True):
    """One WebSocket frame of a client; `length` may lie. The mask is zero: the rule asks for one, not for a secret."""
    size = len(payload) if length is None else length
    head = bytes([(0x80 if fin else 0) | opcode])
    bit = 0x80 if masked else 0
    if size < 126:
        head += bytes([bit | size])
    elif size < 65536:
        head += bytes([bit | 126]) + struct.pack(">H", size)
    else:
        head += bytes([bit | 127]) + struct.pack(">Q", size)
    return head + (b"\0\0\0\0" if masked else b"") + payload


def upgrade(path, host="x", extra=""):
    key = base64.b64encode(os.urandom(16)).decode()
    return (f"GET {path} HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n{extra}\r\n").encode()


class Wire:
    """A socket that is read in exact pieces; the end of the stream is Closed(None)."""

    def __init__(self, host, port, timeout, context=None):
        self.socket = socket.create_connection((host, port), timeout)
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        if context:
            self.socket = context.wrap_socket(self.socket, server_hostname=host)
        self.buffer = bytearray()

    def fill(self):
        try:
            got = self.socket.recv(1 << 18)
        except ConnectionError:
            got = b""
        if not got:
            raise Closed(None)
        self.buffer += got

    def take(self, count):
        while len(self.buffer) < count:
            self.fill()
        piece = bytes(self.buffer[:count])
        del self.buffer[:count]
        return piece

    def until(self, mark):
        while mark not in self.buffer:
            self.fill()
        return self.take(self.buffer.index(mark) + len(mark))

    def rest(self):
        """Everything that comes until the other side hangs up."""
        try:
            while True:
                self.fill()
        except Closed:
            return self.take(len(self.buffer))

    def send(self, data):
        try:
            self.socket.sendall(data)
        except ConnectionError:
            raise Closed(None) from None

    def close(self):
        self.socket.close()


class Frame:
    """A picture, complete: its tiles as they came."""

    def __init__(self, payload):
        (self.frame, self.viewer, self.view, self.width, self.height, self.asked_width,
         self.flags) = struct.unpack("<7I", payload)
        self.tiles, self.bytes, self.stats, self.ms = {}, 0, None, 0.0
        self.lossless = self.flags == 1

    def add(self, payload):
        frame, first, rows, width, rank, codec, channels, crc = struct.unpack("<IIIIHBBI", payload[:24])
        encoded = payload[24:]
        assert frame == self.frame and width == self.width and first + rows <= self.height, "a tile beyond its frame"
        assert zlib.crc32(encoded) == crc, "a wrong checksum"
        assert first not in self.tiles, "a tile twice"
        self.tiles[first] = (rows, rank, codec, channels, encoded)
        self.bytes += len(encoded)

    def end(self, stats):
        at = 0
        for first, tile in sorted(self.tiles.items()):
            assert first == at, "rows missing or twice"
            at += tile[0]
        assert at == self.height, "rows missing"
        self.stats = stats

    def ranks(self):
        return {tile[1] for tile in self.tiles.values()}

    def pixels(self):
        """The bytes of all rows of a picture in PNG tiles."""
        out = b""
        for _, (rows, _, codec, channels, encoded) in sorted(self.tiles.items()):
            assert codec == PNG, "only png is decoded here"
            width, height, got, data = decode_png(encoded)
            assert (width, height, got) == (self.width, rows, channels), "a tile is not what it says"
            out += data
        return out


def decode_png(data):
    """Width, height, channels and pixels of an 8-bit PNG that is not interlaced."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlace = struct.unpack(">IIBBBBB", body)
            assert depth == 8 and interlace == 0 and color in (2, 6)
            channels = 3 if color == 2 else 4
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    filtered, stride = zlib.decompress(packed), width * channels
    before, out = bytearray(stride), bytearray()
    for y in range(height):
        kind = filtered[y * (stride + 1)]
        row = bytearray(filtered[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride) if kind else ():
            left = row[i - channels] if i >= channels else 0
            up = before[i]
            corner = before[i - channels] if i >= channels else 0
            if kind == 1:
                guess = left
            elif kind == 2:
                guess = up
            elif kind == 3:
                guess = (left + up) // 2
            else:
                p = left + up - corner
                guess = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))[2]
            row[i] = (row[i] + guess) & 255
        out += row
        before = row
    return width, height, channels, bytes(out)


class Viewer:
    """Calls wait at most `timeout` seconds and raise TimeoutError then, Closed when the server hangs up."""

    def __init__(self, address, codecs=("jpeg", "png"), name="test", timeout=60, hello=True, context=None, receive_bytes=0,
                 path="/stream", direct=False, fields=""):
        host, port, token = split(address)
        self.wire = Wire(host, port, timeout, context)
        if receive_bytes:
            self.wire.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, receive_bytes)
        self.timeout, self.state, self.scene, self.welcome = timeout, {}, None, None
        self.notices, self.states, self.frame, self.last_view, self.offer = [], [], None, 0, None
        self.picked = None  # The newest answer to a Pick.
        self.answered = None  # The newest change of its own that is answered.
        self.restarts = 0  # How often the job went away while this viewer was there.
        self.wire.send(upgrade(path + ("?token=" + token if token else ""), f"{host}:{port}", fields))
        head = self.wire.until(b"\r\n\r\n").decode()
        if not head.startswith("HTTP/1.1 101 "):
            raise Refused(int(head.split()[1]), head)
        if hello:
            self.send(HELLO, {"codecs": list(codecs), "name": name, "direct": direct})
            while self.welcome is None:
                self.step()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.wire.close()

    @property
    def number(self):
        return self.welcome["viewer"]

    def send(self, kind, payload=b"", **wrong):
        self.wire.send(ws_frame(message(kind, payload, **wrong)))

    def receive(self):
        """The next WebSocket message; pings are answered."""
        while True:
            first, second = self.wire.take(2)
            size = second & 127
            if size == 126:
                size = struct.unpack(">H", self.wire.take(2))[0]
            elif size == 127:
                size = struct.unpack(">Q", self.wire.take(8))[0]
            payload, opcode = self.wire.take(size), first & 15
            if opcode == 8:
                self.wire.send(ws_frame(payload, 8))
                code = struct.unpack(">H", payload[:2])[0] if len(payload) > 1 else 1005
                raise Closed(code, payload[2:].decode())
            if opcode == 9:
                self.wire.send(ws_frame(payload, 10))
            elif opcode == 2:
                assert first & 0x80, "a message in pieces"
                return payload

    def step(self, show=True):
        """Takes the next message; a Frame if that made one whole."""
        data = self.receive()
        magic, version, kind, reserved, length = struct.unpack("<BBBBI", data[:8])
        assert (magic, version, reserved, length) == (0xAE, 1, 0, len(data) - 8), "not a message of the protocol"
        payload = data[8:]
        if kind == FRAME:
            self.frame = Frame(payload)
        elif kind == TILE:
            assert self.frame and struct.unpack("<I", payload[:4])[0] == self.frame.frame, "a tile without its frame"
            self.frame.add(payload)
        elif kind == FRAME_END:
            assert self.frame and struct.unpack("<I", payload[:4])[0] == self.frame.frame, "an end without its frame"
            self.frame.end(json.loads(payload[4:]))
            done, self.frame = self.frame, None
            if show:
                self.send(SHOWN, done.frame)
            return done
        elif kind == WELCOME:
            self.welcome = json.loads(payload)
        elif kind == STATE:
            before, self.state = self.state.get("state"), json.loads(payload)
            self.restarts += self.state["state"] == "restarting" != before
            self.states.append(self.state["state"])
        elif kind == SCENE:
            self.scene = json.loads(payload)
        elif kind == OFFER:
            self.offer = json.loads(payload)["direct"]
        elif kind == CHANGED:
            self.answered = struct.unpack("<I", payload)[0]
        elif kind == PICKED:
            self.picked = json.loads(payload)
        elif kind == NOTICE:
            self.notices.append(json.loads(payload))
        else:
            raise AssertionError(f"a message of type {kind}")
        return None

    def take_direct(self, links):
        """The next frame of a viewer that has connections to the ranks, `links` by rank: what does not come through the server
        comes there."""
        frame, stats = None, None
        while stats is None:
            data = self.receive()
            if data[2] == FRAME:
                frame = Frame(data[8:])
            elif data[2] == TILE:
                frame.add(data[8:])
            elif data[2] == FRAME_END:
                stats = json.loads(data[12:])
        for stripe in stats["ranks"]:
            while stripe["rows"] > sum(tile[0] for tile in frame.tiles.values() if tile[1] == stripe["rank"]):
                data = links[stripe["rank"]].receive()
                assert data[2] == TILE, "something else on a connection for tiles"
                if struct.unpack("<I", data[8:12])[0] == frame.frame:  # Tiles of frames that were given up do not count.
                    frame.add(data[8:])
        frame.end(stats)
        self.send(SHOWN, frame.frame)
        return frame

    def view(self, width=64, height=48, moving=False, **options):
        """Asks for a view. Returns its number."""
        self.last_view += 1
        self.send(VIEW, {"view": self.last_view, "moving": moving, "width": width, "height": height, **options})
        return self.last_view

    def pick(self, x, y, width=64, height=48, **options):
        """What that view shows at a pixel, or the words of a refusal."""
        self.last_view += 1
        asked, told = self.last_view, len(self.notices)
        self.send(PICK, {"view": asked, "moving": False, "width": width, "height": height, "x": x, "y": y, **options})
        self.until(lambda _: (self.picked and self.picked["view"] == asked) or len(self.notices) > told)
        return self.notices[-1]["message"] if len(self.notices) > told else self.picked["place"]

    def until(self, what, seconds=None, show=True):
        """Steps until what(frame or None) is true. Returns its value."""
        end = time.monotonic() + (seconds or self.timeout)
        while True:
            self.wire.socket.settimeout(max(0.01, end - time.monotonic()))
            result = what(self.step(show))
            if result:
                self.wire.socket.settimeout(self.timeout)
                return result
            if time.monotonic() > end:
                raise TimeoutError("it did not come")

    def picture(self, number=None, seconds=None):
        """The next frame, or the frame of the own view with that number. Raises JobLost where it will not come."""
        restarts, notices = self.restarts, len(self.notices)

        def is_it(frame):
            if frame and (number is None or (frame.viewer, frame.view) == (self.number, number)):
                return frame
            given_up = [notice["message"] for notice in self.notices[notices:] if "not tried again" in notice["message"]]
            if given_up or self.state.get("state") == "failed" or self.restarts > restarts + 3:
                raise JobLost(f"no picture; the job was started again {self.restarts - restarts} times: {given_up or self.state}")
            return None
        return self.until(is_it, seconds)

    def see(self, seconds=None, **view):
        """Asks for a view and gets it."""
        return self.picture(self.view(**view), seconds)

    def wait_state(self, state, seconds=None):
        if self.state.get("state") != state:
            self.until(lambda _: self.state.get("state") == state, seconds)
        return self.state

    def loaded(self, seconds=None):
        if self.scene is None:
            self.until(lambda _: self.scene is not None, seconds)
        return self

    def closed(self, seconds=20):
        """The code that the server hangs up with."""
        try:
            self.until(lambda _: False, seconds)
        except Closed as end:
            self.farewell = end.reason
            return end.code
        return "still open"
