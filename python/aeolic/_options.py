"""The options of the command line as keywords: from the one table that the program has, too."""
import math
import numbers
import os
from collections.abc import Iterable, Mapping

import numpy

from . import _core

InputError = _core.InputError

# "color_by" -> its row: "name" on the command line, "group", "type", "default" and "help".
TABLE = {row["name"][2:].replace("-", "_"): row for row in _core.option_table()}
LOADED = ("surface", "field")  # Arguments of their own: they may be data in memory, too.
KEYWORDS = [name for name in TABLE if name not in LOADED]


def _takes_effect_later(name):
    """Whether an option can be changed without loading the scene anew."""
    return name == "size" or (TABLE[name]["group"] in ("lic", "shading") and name != "color_by")


CHANGEABLE = [name for name in KEYWORDS if _takes_effect_later(name)]


def _text(name, value):
    """What one would type for the value."""
    if isinstance(value, numpy.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, str):
        return str(value)
    if isinstance(value, (bool, numpy.bool_)):
        return "on" if value else "off"
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


def plain(where, value):
    """The value as JSON has it: a text, a number, True or False, or a list of numbers."""
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        value = value.tolist()
    numbers_only = isinstance(value, (list, tuple)) and all(isinstance(item, numbers.Real) for item in value)
    for number in value if numbers_only else [value] if isinstance(value, numbers.Real) else []:
        try:
            finite = math.isfinite(number)
        except OverflowError:
            finite = False
        if not finite:
            raise InputError(f"{where}: found {number}; expected finite numbers")
    if numbers_only or isinstance(value, (str, numbers.Real)):
        return list(value) if numbers_only else value
    raise InputError(f"{where}: found {type(value).__name__}; expected a number, a text, True or False, or several numbers")


def refuse_unknown(function, given, known):
    """Raises TypeError for a keyword that there is not, with the nearest one that there is."""
    for name in given:
        if name not in known:
            raise TypeError(f"{function}() got an unexpected keyword argument '{name}'" + _core.nearest(name, list(known)))


def camera_text(camera):
    return None if camera is None else _text("camera", camera)


def texts(options):
    """{"--color-by": "p"} of {"color_by": "p"}. None stands for what holds without the option."""
    found = {}
    for name, value in options.items():
        if value is None or (name == "camera" and isinstance(value, Mapping) and not value):
            continue
        found[TABLE[name]["name"]] = _text(name, value)
    return found
