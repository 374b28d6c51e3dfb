"""Clients that send every kind of nonsense to a server, all the time: what `soak hostile` sets beside honest viewers.

Each kind is a generator function of a server's address. Each step of it does one rude thing; the next step comes after a
pause. A client that was hung up on, as it should be, comes back.
"""
import multiprocessing
import random
import socket
import struct
import time

from viewer import CHANGE, FOLLOW, HELLO, SHOWN, START, VIEW, Closed, Refused, Viewer, Wire, message, split, upgrade, ws_frame


def viewer_of(address, **options):
    return Viewer(address, **{"timeout": 20, "name": "rude", **options})


def drain(viewer):
    """Reads the bytes that have come, because the server disconnects clients that read nothing."""
    viewer.wire.socket.settimeout(0.01)
    try:
        while True:
            viewer.wire.fill()
            viewer.wire.buffer.clear()
    except (TimeoutError, socket.timeout):
        viewer.wire.socket.settimeout(20)


def absurd_changes(address, dice):
    with viewer_of(address) as viewer:
        while True:
            viewer.send(CHANGE, dice.choice([
                {"time": 1e31}, {"time": -1e300}, {"surface": "isosurface:p=1e999"}, {"surface": "isosurface:nothing=1"},
                {"surface": "slice:0,0,0:0,0,0"}, {"surface": "/etc/passwd"}, {"vectors": "x" * 9000}, {"colorBy": "a\0b"},
                {"surface": "slice:9e99,0,0:1,0,0"}]))
            drain(viewer)
            yield


def flood_of_changes(address, dice):
    with viewer_of(address) as viewer:
        while True:
            for _ in range(10):
                viewer.send(CHANGE, {"colorBy": dice.choice(["tornado:mag", "field:tornado:mag"])})  # Pictures cost the same.
            drain(viewer)
            yield


def absurd_views(address, dice):
    with viewer_of(address) as viewer:
        while True:
            viewer.view(**dice.choice([
                {"width": 4294967295, "height": 1}, {"width": 32768, "height": 32768, "lic": {"steps": 65536}},
                {"width": 4096, "height": 4096, "lic": {"method": "direct", "steps": 65536}}, {"lic": {"steps": -1}},
                {"camera": {"azimuth": 1e300}}, {"camera": {"fov": 0}}, {"shading": {"colormap": "none"}},
                {"camera": {"position": [1e300, 0, 0], "focal": [0, 0, 0]}}]))
            drain(viewer)
            yield


def flood_of_views(address, dice):
    with viewer_of(address) as viewer:
        while True:
            for _ in range(25):
                viewer.view(moving=True, width=320, height=240, camera={"azimuth": dice.uniform(0, 360)})
            viewer.send(SHOWN, 0xFFFFFFFF)
            drain(viewer)
            yield


def costly_views(address, dice):
    """Just within the budget: each takes many times what an honest one takes. It shows what it gets, as everybody does."""
    with viewer_of(address, timeout=600) as viewer:
        while True:
            camera = {"azimuth": dice.uniform(0, 360)}
            viewer.see(width=1000, height=1000, lic={"method": "direct", "steps": 200}, camera=camera)
            yield


def slow_reader(address, dice):
    with viewer_of(address, receive_bytes=4096) as viewer:
        while True:
            viewer.view(width=1000, height=1000, camera={"azimuth": dice.uniform(0, 360)})
            viewer.send(SHOWN, 0xFFFFFFFF)
            yield


def half_open(address, dice):
    host, port, token = split(address)
    starts = [b"", b"GET", upgrade("/stream?token=" + token)[:40], upgrade("/stream?token=" + token)]
    kept = []
    while True:
        wire = Wire(host, port, 20)
        wire.send(dice.choice(starts))
        kept.append(wire)
        if len(kept) > 20:
            kept.pop(0).close()
        yield


def wrong_tokens(address, dice):
    host, port, _ = split(address)
    while True:
        try:
            Viewer(f"http://{host}:{port}/?token=" + "".join(dice.choice("abcXYZ019-_") for _ in range(32))).wire.close()
        except Refused:
            pass
        yield


def junk(address, dice):
    host, port, _ = split(address)
    while True:
        with viewer_of(address, hello=dice.random() < 0.5) as viewer:
            good = message(VIEW, {"view": 1, "moving": False, "width": 9, "height": 9})
            bad = bytearray(dice.choice([good, message(FOLLOW, 7), message(HELLO, {}), message(START)]))
            for _ in range(3):
                bad[dice.randrange(len(bad))] = dice.randrange(256)
            viewer.wire.send(dice.choice([ws_frame(bytes(bad)), ws_frame(b"", length=1 << 62), dice.randbytes(200),
                                          ws_frame(b"x", opcode=dice.randrange(16)), ws_frame(struct.pack(">H", 1005), opcode=8)]))
        wire = Wire(host, port, 20)
        wire.send(dice.randbytes(300))
        wire.close()
        yield


def askers(address, dice):
    """Follows nobody, starts what runs, and leaves without a word."""
    while True:
        viewer = viewer_of(address)
        viewer.send(START)
        viewer.send(FOLLOW, dice.randrange(1 << 32))
        viewer.wire.close()
        yield


KINDS = {absurd_changes: 0.2, flood_of_changes: 0.1, absurd_views: 0.2, flood_of_views: 0.1, costly_views: 0.5, slow_reader: 0.5,
         half_open: 0.5, wrong_tokens: 0.3, junk: 0.2, askers: 0.5}  # The pause between two steps in seconds.


def behave(kind, address, seed, go, done):
    """One client of that kind, for ever."""
    dice, client = random.Random(seed), kind(address, random.Random(seed))
    while True:
        go.wait()
        try:
            next(client)
            done.value += 1
        except (Closed, Refused, OSError, StopIteration, AssertionError):
            client = kind(address, dice)
            time.sleep(0.2)
        time.sleep(KINDS[kind])


class Crowd:
    """One client of each kind, in processes of their own, so that they take no time from honest viewers' threads. To be made
    before those threads are. They are rude from begin() to rest(), and stay connected meanwhile."""

    def __init__(self, address, seed, kinds=tuple(KINDS)):
        self.done = {kind.__name__: multiprocessing.Value("Q", 0) for kind in kinds}
        self.go = multiprocessing.Event()
        self.processes = [self.process(kind, address, seed) for kind in kinds]

    def process(self, kind, address, seed):
        words = (kind, address, f"{seed} {kind.__name__}", self.go, self.done[kind.__name__])
        return multiprocessing.Process(target=behave, args=words, daemon=True)

    def __enter__(self):
        for process in self.processes:
            process.start()
        return self

    def begin(self):
        self.go.set()

    def rest(self):
        self.go.clear()

    def __exit__(self, *_):
        for process in self.processes:
            process.terminate()
            process.join()

    def steps(self):
        return {name: value.value for name, value in self.done.items()}
