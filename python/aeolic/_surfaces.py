"""Several surfaces in one picture, as the scene file lists them."""
import json
import os
from collections.abc import Mapping

from ._checks import nearest, text
from ._options import TABLE, InputError, plain

# What an item may say, and the scene file's name of it.
KEYS = {name: TABLE[name]["key"].split(".")[1] if name in TABLE else name
        for name in ("surface", "vectors", "color_by", "colormap", "color_range", "legend", "streaks", "shown")}


def _name(where, value):
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if not isinstance(value, str):
        raise InputError(f"{where}: found {type(value).__name__}; "
                         "expected a file's name or another text that names a surface")
    return text(where, value)  # A scene is JSON, which has no names in other bytes.


def _item(where, given):
    if not isinstance(given, Mapping):
        return {"spec": _name(where, given)}
    item = {}
    for key, value in given.items():
        if key not in KEYS:
            raise InputError(f"{where}: {key!r}: unknown key; expected one of {', '.join(KEYS)}" +
                             nearest(key, KEYS))
        if value is not None:
            item[KEYS[key]] = _name(f"{where}: surface", value) if key == "surface" else plain(f"{where}: {key}", value)
    return item


def items_of(surface):
    """The JSON of "surfaces", of a list; else an empty text."""
    if not isinstance(surface, (list, tuple)):
        return ""
    if not surface:
        raise InputError("surface: found an empty list; expected at least one surface")
    return json.dumps([_item(f"surface[{index}]", given) for index, given in enumerate(surface)])


def contexts_of(given):
    """The surfaces that are drawn plain, as texts."""
    if given is None:
        return []
    if not isinstance(given, (list, tuple)):
        given = [given]
    return [_name(f"context[{index}]", value) for index, value in enumerate(given)]
