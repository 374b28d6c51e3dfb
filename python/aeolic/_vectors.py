"""Which arrays in memory are flow: of two components where the data are flat, and of whole numbers."""
import json
import re
from collections.abc import Mapping

import numpy

_KINDS = ("point_data", "cell_data")
_TEXTURE = re.compile(r"^t(exture)?[ _]?coord", re.IGNORECASE)  # Places in a texture are no flow.


def _components(array):
    return array.shape[1] if array.ndim == 2 else 1


def _is_flat(memory):
    """Whether all of it has the same z."""
    if "axes" not in memory and "origin" in memory:
        return memory["dims"][2] <= 1
    axes = memory.get("axes", (None,) * 3)
    heights = memory["points"][:, 2] if axes[2] is None else axes[2]
    return len(heights) > 0 and heights.min() == heights.max()


def _only_one(memory):
    """(where, name) of the array that can but be meant where the library finds none that it takes for vectors by itself:
    those have three components, are not whole numbers, and are no normals. None where it is not clear."""
    normals = {name for (_, what), name in memory["active"].items() if what == "normals"} | {"Normals"}
    arrays = [(where, name, array) for where in _KINDS for name, array in memory[where]
              if name not in normals and array.dtype != numpy.uint8]  # Bytes are colours and marks.
    three = [entry for entry in arrays if _components(entry[2]) == 3]
    if any(array.dtype.kind == "f" for _, _, array in three):
        return None
    found = three
    if not three and _is_flat(memory):
        found = [entry for entry in arrays if _components(entry[2]) == 2 and not _TEXTURE.match(entry[1])]
    return found[0][:2] if len(found) == 1 else None


def prepared(data, vectors, kept=None):
    """What the library is told of a Surface, Grid or Volume, of which it may draw the array `vectors`, or any where that
    is empty. `kept`: {(where, "vectors"): name} of the array that is drawn whatever the data say; empty: as they say.
    Vectors of two components get a third one of 0."""
    if data is None:
        return None
    memory = data._memory
    active = dict(memory["active"])
    if kept:
        active = {attribute: name for attribute, name in active.items() if attribute[1] != "vectors"} | kept
    if not vectors and not any(what == "vectors" for _, what in active):
        meant = _only_one(memory)
        if meant is not None:
            active[meant[0], "vectors"] = meant[1]

    def widened(where, name, array):
        is_flow = name == vectors or (not vectors and active.get((where, "vectors")) == name)
        if not is_flow or _components(array) != 2:
            return array
        wide = numpy.zeros((len(array), 3), array.dtype)
        wide[:, :2] = array
        return wide
    return {**memory, "active": active,
            **{where: [(name, widened(where, name, array)) for name, array in memory[where]] for where in _KINDS}}


def named_vectors(vectors, scene):
    """The name of the array that vectors= names, or else the scene; empty where neither does."""
    if vectors is None and scene is not None:
        vectors = _vectors_of(scene)
    inner = re.fullmatch(r"(?:wallShear|reversed)\((.*)\)", vectors) if isinstance(vectors, str) else None
    return inner[1] if inner else vectors or ""


def _vectors_of(scene):
    if not isinstance(scene, Mapping):
        try:
            with open(scene, encoding="utf-8") as file:
                scene = json.load(file)
        except (OSError, TypeError, ValueError):  # Who reads it for the library says what is wrong.
            return ""
    field = scene.get("field") if isinstance(scene, Mapping) else None
    return field.get("vectors", "") if isinstance(field, Mapping) else ""
