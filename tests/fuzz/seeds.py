"""Writes the fuzzers' first inputs: seeds.py FOLDER. One good example of everything; the fuzzer does the rest."""
import json
import os
import struct
import sys
import zlib


def message(kind, payload=b""):
    if isinstance(payload, dict):
        payload = json.dumps(payload, separators=(",", ":")).encode()
    elif isinstance(payload, int):
        payload = struct.pack("<I", payload)
    return struct.pack("<BBBBI", 0xAE, 1, kind, 0, len(payload)) + payload


def record(what, data=b""):
    return struct.pack("<BH", what, len(data)) + data


def png(width, height):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = b"".join(b"\0" + bytes((x * 20) & 255 for x in range(width * 3)) for _ in range(height))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def frame(number, width, height):
    return struct.pack("<7I", number, 1, 1, width, height, width, 1)


def tile(number, first, rows, width, codec, encoded):
    return struct.pack("<IIIIHBBI", number, first, rows, width, 0, codec, 3, 0) + encoded


VIEW = {"view": 1, "moving": True, "width": 40, "height": 30,
        "camera": {"azimuth": 30.5, "position": [1, 2, 3], "focal": [0, 0, 0], "up": [0, 0, 1]},
        "lic": {"method": "direct", "steps": 5, "kernel": "hann", "phase": 1, "normalize": False},
        "shading": {"colormap": "turbo", "colorRange": [0, 1], "scalarBar": True, "background": "transparent"}}
HELLO = {"codecs": ["jpeg", "png", "lz4"], "direct": False, "name": "page"}
DRAWN, SHOWN, LATER, DEAD, LOADED = (record(3 * what) for what in (4, 5, 6, 7, 8))

GATEWAY = {
    "hello": record(0, message(1, HELLO)), "view": record(0, message(2, VIEW)) + DRAWN + SHOWN,
    "follow": record(0, message(5, 2)) + record(1, message(2, VIEW)) + DRAWN,
    "change": record(0, message(4, {"surface": "slice:0,0,0:0,0,1", "vectors": "U", "colorBy": "p", "time": 0.25})) + LOADED,
    "original": record(0, message(4, {"surface": "original"})) + LOADED,
    "death": record(0, message(2, VIEW)) + DEAD + DRAWN + record(1, message(2, VIEW)) + DEAD + DEAD,
    "slow": (record(0, message(2, VIEW)) + record(18, b"x" * 20) + DRAWN + record(18, b"x") + SHOWN) * 4,
    "payload": record(9, b"\2" + json.dumps(VIEW).encode()),
    "get": b"HGET /?token=0123456789abcdef HTTP/1.1\r\nHost: 127.0.0.1:8080\r\n\r\n",
    "cookie": b"HGET /status HTTP/1.1\r\nHost: localhost\r\nCookie: a=b; aeolic-8080=0123456789abcdef\r\n\r\n",
    "bearer": b"HHEAD /style.css HTTP/1.0\r\nAuthorization: Bearer 0123456789abcdef\r\nOrigin: http://x\r\nHost: x\r\n\r\n",
    "post": b"HPOST /stream?a=1&token=0123456789abcdef HTTP/1.1\r\nHost: [::1]:80\r\nContent-Length: 2\r\n\r\nxy",
}
LOOK, ROWS, END = record(3, b"\0\1"), record(4, b"\0\36"), record(5)
RANKS = {
    "frame": LOOK + ROWS + END, "pieces": LOOK + record(4, b"\0\12") + END + record(4, b"\12\24"), "overlap": LOOK + ROWS + ROWS,
    "tile": LOOK + record(0, message(0x45, tile(1, 0, 30, 40, 1, b"jpeg"))) + record(0, message(0x46, b"\1\0\0\0{}")),
    "scene": record(1, b"\x43" + json.dumps({"load": 1, "scene": {}}).encode()),
    "notice": LOOK + record(1, b"\x47" + json.dumps({"level": "error", "message": "no", "frame": 1}).encode()),
    "load failed": record(1, b"\x47" + json.dumps({"level": "error", "message": "no", "load": 1}).encode()),
    "progress": record(1, b"\x84" + json.dumps({"load": 1, "what": "reading", "fraction": 0.5}).encode()),
    "join": record(2, message(0x81, {"secret": "x", "rank": 0, "ranks": 2, "host": "n", "pid": 1, "direct": None})),
}
FRAMES = {
    "png": record(1, frame(1, 6, 4)) + record(2, tile(1, 0, 4, 6, 2, png(6, 4))) + record(3, b"\1\0\0\0{}"),
    "raw": record(1, frame(1, 5, 2)) + record(2, tile(1, 1, 1, 5, 0, b"x" * 15)) + record(2, tile(1, 0, 1, 5, 0, b"y" * 15)) +
           record(3, b"\1\0\0\0{}"),
    # One literal run of 12 bytes.
    "lz4": record(1, frame(1, 4, 1)) + record(2, tile(1, 0, 1, 4, 3, b"\xc0" + bytes(range(12)))) + record(3, b"\1\0\0\0{}"),
    "jpeg": record(1, frame(1, 8, 8)) + record(2, tile(1, 0, 8, 8, 1, b"\xff\xd8\xff\xc0\x00\x11\x08\x00\x08\x00\x08\x03")),
    "packed": b"".join(record(4, bytes([codec, 20, 9, channels])) for codec in range(4) for channels in range(2)),
    "damaged png": record(4, bytes([2, 40, 30, 0, 60, 0, 1])), "damaged jpeg": record(4, bytes([1, 40, 30, 79, 0, 3, 255])),
    "damaged lz4": record(4, bytes([3, 40, 30, 1, 5, 0, 128])),
    "headers": record(0, message(0x44, frame(1, 6, 4))) + record(0, message(0x42, {})),
}

PLY_HEADER = (b"ply\nformat %s 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
              b"property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\nelement face 1\n"
              b"property list uchar int vertex_indices\nproperty float q\nend_header\n")
PLY_VERTICES = [(0, 0, 0, 0, 0, 1, 7), (1, 0, 0, 0, 0, 1, 8), (0, 1, 0, 0, 0, 1, 9)]


def binary_ply(order):
    return (b"".join(struct.pack(order + "6fB", *v) for v in PLY_VERTICES) + struct.pack(order + "B3if", 3, 0, 1, 2, 0.5))


PLY = {
    "text": PLY_HEADER % b"ascii" + "".join(" ".join(map(str, v)) + "\n" for v in PLY_VERTICES).encode() + b"3 0 1 2 0.5\n",
    "little": PLY_HEADER % b"binary_little_endian" + binary_ply("<"), "big": PLY_HEADER % b"binary_big_endian" + binary_ply(">"),
}
SERIES = {
    "json": b'J{"file-series-version": "1.0", "files": [{"name": "a.vtp", "time": 0}, {"name": "b.vtp", "time": 1.5}]}',
    "xml": b'X<VTKFile type="Collection" version="0.1"><Collection><DataSet timestep="0" part="0" file="a.vtp"/>\n'
           b'<DataSet timestep="1e3" file="b.vtp"/></Collection></VTKFile>\n',
}
SCENE = {
    "full": json.dumps({"version": 1, "surface": {"spec": "a.vtp"}, "field": {"vectors": "v", "precision": "float16"},
                        "lic": {"steps": 128, "step": 1.0}, "shading": {"colorBy": "p", "colormap": "coolwarm"},
                        "camera": {"position": [2.15, -1.1, 0.95], "focal": [0, 0, 0], "up": [0, 0, 1], "fov": 25},
                        "time": {"range": [0, 1]}, "output": {"width": 1600, "height": 1000}}).encode(),
    "empty": b"{}",
}

if __name__ == "__main__":
    for target, seeds in (("gateway", GATEWAY), ("ranks", RANKS), ("frames", FRAMES), ("ply", PLY),
                          ("series", SERIES), ("scene", SCENE)):
        folder = os.path.join(sys.argv[1], target)
        os.makedirs(folder, exist_ok=True)
        for name, data in seeds.items():
            with open(os.path.join(folder, "seed " + name), "wb") as file:
                file.write(data)
