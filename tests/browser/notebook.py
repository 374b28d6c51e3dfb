"""Stands in for a notebook's kernel: shows a scene, writes its cell's HTML, and does what each line of its input says."""
import json
import sys
import time

import aeolic
import numpy


def cell(viewer):
    print(json.dumps({"html": viewer._repr_html_()}), flush=True)


y, x = numpy.meshgrid(numpy.linspace(0, 1, 60), numpy.linspace(0, 1, 60), indexing="ij")
points = numpy.stack([x, y, 0.2 * x * y], -1).reshape(-1, 3).astype("f4")
at = numpy.arange(60 * 59).reshape(59, 60)[:, :59].reshape(-1)
triangles = numpy.concatenate([numpy.stack([at, at + 1, at + 61], -1), numpy.stack([at, at + 61, at + 60], -1)])


def sheet(turn):
    tau = numpy.stack([numpy.cos(turn + 6 * y), numpy.sin(turn + 6 * x), 0 * x], -1).reshape(-1, 3).astype("f4")
    return aeolic.Surface(points, triangles, point_data={"tau": tau})


renderers = [aeolic.Renderer(sheet(turn), vectors="tau", backend="cpu") for turn in (0.0, 1.0)]
begun = time.monotonic()
viewers = [renderers[0].show(browser=False, height=500, controls={"speed": (0, 2, 0.5), "pause": False, "step": "button"}, title="Solver"),
           renderers[1].show(browser=False, height=300)]
for viewer in viewers:
    cell(viewer)
for line in sys.stdin:
    word, *rest = line.split()
    if word == "set":
        renderers[0].set(colormap=rest[0], contrast=float(rest[1]))
    elif word == "data":
        renderers[0].set_data(sheet(float(rest[0])))
    elif word == "values":
        print(json.dumps({name: viewers[0].value(name) for name in ("speed", "pause", "step")}), flush=True)
    elif word == "close":
        viewers[int(rest[0])].close()
