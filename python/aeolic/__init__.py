"""Flow drawn on surfaces: line integral convolution, fast and the same everywhere.

    import aeolic
    picture = aeolic.render("body.vtp", vectors="wallShearStress", color_by="p", camera={"azimuth": 50})
    picture.save("body.png")

render() draws one picture; Renderer loads once and draws many. The keywords of both are the options of the program: see
help(aeolic.Renderer). Surface, Grid and Volume are data in memory. InputError says in one line what is wrong with the input.
"""
import inspect as _inspect
import os as _os

from . import _core
from ._core import InputError, Picture, __version__
from ._data import Grid, Surface, Volume
from ._options import CHANGEABLE as _CHANGEABLE, KEYWORDS as _KEYWORDS, TABLE as _TABLE
from ._plane import PLANE_OPTIONS as _PLANE_OPTIONS, lic2d
from ._render import Renderer, info, render
from ._show import Viewer

__all__ = ["Grid", "InputError", "Picture", "Renderer", "Surface", "Viewer", "Volume", "info", "lic2d", "render"]


def _save(self, path):
    """Writes a .png, .jpg or .webp file: the bytes that `aeolic render` writes. Raises InputError for another kind of
    name, OSError if the file cannot be written."""
    name = _os.fspath(path)
    if not isinstance(name, str):
        raise InputError(f"-o: found '{name}'; expected a name ending in .png, .jpg or .webp")
    try:
        self._save(name)
    except RuntimeError as error:
        raise OSError(str(error)) from None


Picture.save = _save
Picture.__module__ = "aeolic"
InputError.__doc__ = "The input was wrong: one line that names the file or option, what was found and what was expected."


def _document(function, names):
    """Gives a function the signature that its options have, and their descriptions."""
    kept = [p for p in _inspect.signature(function).parameters.values() if p.kind != p.VAR_KEYWORD]
    options = [_inspect.Parameter(name, _inspect.Parameter.KEYWORD_ONLY, default=None, annotation=_TABLE[name]["type"])
               for name in names]
    function.__signature__ = _inspect.Signature(kept + options)
    lines = [f"    {name}: {_TABLE[name]['help']}".replace("\n", "\n        ") for name in names]
    return "\n\nOptions, with their defaults in brackets:\n\n" + "\n".join(lines) + "\n"


render.__doc__ += _document(render, _KEYWORDS)
Renderer.__doc__ += _document(Renderer.__init__, _KEYWORDS)
lic2d.__doc__ += _document(lic2d, _PLANE_OPTIONS)
Renderer.set.__doc__ += _document(Renderer.set, _CHANGEABLE)
