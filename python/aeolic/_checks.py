"""Single texts, names and numbers, as the library takes them; or one line that says what was expected."""
import functools
import inspect
import operator
import os
import reprlib

from . import _core

InputError = _core.InputError


def _encoded(where, value, errors):
    if "\0" in value:
        raise InputError(f"{where}: found {value!r}; expected a text without NUL")
    try:
        return value.encode("utf-8", errors)
    except UnicodeEncodeError:
        raise InputError(f"{where}: found {value!a}; expected a text in UTF-8") from None


def text(where, value):
    """The text, of whatever class of texts it was."""
    if not isinstance(value, str):
        raise TypeError(f"{where}: found {type(value).__name__}; expected a text")
    return _encoded(where, value, "strict").decode()


def path(where, value):
    """A file's name in the system's bytes: os.listdir() gives names that are not UTF-8 as surrogates."""
    if isinstance(value, os.PathLike):
        value = os.fspath(value)
    if not isinstance(value, str):
        raise TypeError(f"{where}: found {type(value).__name__}; expected a file's name")
    return _encoded(where, value, "surrogateescape")


def lines_file(value):
    """The name of a file for points and lines, and whether it is to have comma-separated values."""
    name = path("path", value)
    ending = os.path.splitext(os.fsdecode(name))[1].lower()
    if ending not in (".vtp", ".csv"):
        raise InputError(f"path: found '{os.fsdecode(name)}'; expected a name ending in .vtp or .csv")
    return name, ending == ".csv"


def number(where, value):
    try:
        return float(value)
    except (ValueError, OverflowError):
        raise InputError(f"{where}: found {reprlib.repr(value)}; expected a number") from None
    except TypeError:
        raise TypeError(f"{where}: found {type(value).__name__}; expected a number") from None


def whole(where, value, least, most):
    try:
        found = int(value) if isinstance(value, str) else operator.index(value)
    except (TypeError, ValueError):
        found = int(value) if isinstance(value, float) and value.is_integer() else None
    if found is None or not least <= found <= most:
        raise InputError(f"{where}: found {reprlib.repr(value)}; expected {least} to {most}")
    return found


def nearest(typed, names):
    """"; did you mean NAME?", or nothing where none is near."""
    return _core.nearest(str(typed).encode("utf-8", "replace"), list(names))


def refuse_unknown(function, given, known):
    """Raises TypeError for a keyword that there is not, with the nearest one that there is."""
    for name in given:
        if name not in known:
            raise TypeError(f"{function}() got an unexpected keyword argument {name!r}" + nearest(name, known))


def suggesting(function):
    """The function, or a class's constructor, that names the nearest keyword in the place of one that there is not."""
    *owner, name = function.__qualname__.split(".")
    known = list(inspect.signature(function).parameters)[len(owner):]

    @functools.wraps(function)
    def checked(*args, **given):
        refuse_unknown(owner[-1] if name == "__init__" else name, given, known)
        return function(*args, **given)
    return checked
