"""The options of the command line as keywords: from the one table that the program has, too."""
import inspect
import json
import math
import numbers
import os
from collections.abc import Iterable, Mapping

import numpy

from . import _core
from ._checks import path, text

InputError = _core.InputError

# "color_by" -> its row: the "option" of the command line, the "key" of scene files, "group", "type", "default" and "help".
TABLE = {row["name"]: row for row in _core.option_table()}
LOADED = ("surface", "field")  # Arguments of their own: they may be data in memory, too.
KEYWORDS = [name for name in TABLE if name not in LOADED]
FILES = (*LOADED, "colormap")  # What may be a file's name.


def _takes_effect_later(name):
    """Whether an option can be changed without loading the scene anew."""
    return name == "size" or (TABLE[name]["group"] in ("lic", "shading") and name != "color_by")


CHANGEABLE = [name for name in KEYWORDS if _takes_effect_later(name)]


def _is_switch(name):
    """Whether an option takes on and off, perhaps beside other names."""
    kind = TABLE[name]["type"] if name in TABLE else ""
    return kind == "bool" or '"on"' in kind


def _text(name, value):
    """What one would type for the value."""
    if isinstance(value, numpy.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, str):
        return str.__str__(value)  # The value of an enum.
    if isinstance(value, (bool, numpy.bool_)):
        return ("on" if value else "off") if _is_switch(name) else str(bool(value))
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        return repr(float(value))
    if isinstance(value, os.PathLike) and isinstance(os.fspath(value), str):
        return os.fspath(value)
    if isinstance(value, Mapping) and name == "camera":
        return ";".join(f"{key}={_text(key, item)}" for key, item in value.items() if item is not None)
    if isinstance(value, Iterable) and not isinstance(value, (bytes, bytearray, Mapping)):
        return ("x" if name == "size" else ",").join(_text(name, item) for item in value)
    raise TypeError(f"{name}: found {type(value).__name__}; expected a number, a text, True or False, or several numbers")


def _typed(name, value):
    return (path if name in FILES else text)(name, _text(name, value))


def _json_number(where, value):
    if isinstance(value, (bool, numpy.bool_)):
        return bool(value)
    try:
        found = int(value) if isinstance(value, numbers.Integral) else float(value)
        finite = math.isfinite(found)
    except OverflowError:
        finite = False
    if not finite:
        raise InputError(f"{where}: found {value}; expected finite numbers")
    return found


def plain(where, value):
    """The value as JSON has it: a text, a number, True or False, or a list of numbers."""
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        value = value.tolist()
    if isinstance(value, str):
        return text(where, value)
    scalar = (numbers.Real, numpy.bool_)
    if isinstance(value, scalar):
        return _json_number(where, value)
    if isinstance(value, (list, tuple)) and all(isinstance(item, scalar) for item in value):
        return [_json_number(where, item) for item in value]
    raise InputError(f"{where}: found {type(value).__name__}; expected a number, a text, True or False, or several numbers")


def camera_text(camera):
    """None where the camera says nothing."""
    typed = None if camera is None else _typed("camera", camera)
    return None if typed == "" and isinstance(camera, Mapping) else typed


def scene_given(scene):
    """(name of a scene file, what one holds): one of both, or neither."""
    if not isinstance(scene, Mapping):
        return None if scene is None else path("scene", scene), None
    try:
        return None, json.dumps(scene, allow_nan=False)
    except (TypeError, ValueError) as error:
        raise InputError(f"scene: {error}; expected what a scene file holds, as Renderer.scene tells it") from None


def texts(options):
    """{"--color-by": "p"} of {"color_by": "p"}, for the library. None, which stands for what holds without the option, is left out."""
    found = {}
    for name, value in options.items():
        typed = camera_text(value) if name == "camera" else None if value is None else _typed(name, value)
        if typed is not None:
            found[TABLE[name]["option"]] = typed
    return found


def documented(names):
    """Gives a function, or a class's constructor, the signature that its options have, and their descriptions."""
    def document(it):
        function = it.__init__ if inspect.isclass(it) else it
        kept = [p for p in inspect.signature(function).parameters.values() if p.kind != p.VAR_KEYWORD]
        options = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=TABLE[name]["type"])
                   for name in names]
        function.__signature__ = inspect.Signature(kept + options)
        if it.__doc__:  # python -OO leaves texts out.
            lines = [f"    {name}: {TABLE[name]['help']}".replace("\n", "\n        ") for name in names]
            it.__doc__ += "\n\nOptions, with their defaults in brackets:\n\n" + "\n".join(lines) + "\n"
        return it
    return document
