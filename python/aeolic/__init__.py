"""Flow drawn on surfaces: line integral convolution, fast and the same everywhere.

    import aeolic
    picture = aeolic.render("body.vtp", vectors="wallShearStress", color_by="p", camera={"azimuth": 50})
    picture.save("body.png")

render() draws one picture; Renderer loads once and draws many. The keywords of both are the options of the program: see
help(aeolic.Renderer). Surface, Grid and Volume are data in memory. InputError names the fault in the input in one line.
"""
from ._checks import path as _path
from ._core import InputError, Picture, __version__
from ._data import Grid, Surface, Volume
from ._plane import lic2d
from ._info import ArrayInfo, FileInfo, PartInfo, info
from ._pick import PickedPlace, PictureBuffers
from ._render import Renderer, render
from ._show import Viewer
from ._streamlines import Streamline, Streamlines, streamlines
from ._topology import Topology, TopologyLine, separation, topology

__all__ = ["ArrayInfo", "FileInfo", "Grid", "InputError", "PartInfo", "PickedPlace", "Picture", "PictureBuffers", "Renderer",
           "Streamline", "Streamlines", "Surface", "Topology", "TopologyLine", "Viewer", "Volume", "info", "lic2d", "render",
           "separation", "streamlines", "topology"]


def _save(self, path):
    """Writes a .png, .jpg or .webp file: the bytes that `aeolic render` writes. Raises InputError for another kind of
    name, OSError if the file cannot be written."""
    self._save(_path("path", path))


_save.__name__, _save.__qualname__ = "save", "Picture.save"
Picture.save = _save
Picture.__module__ = "aeolic"
InputError.__doc__ = "The input was wrong: one line that names the file or option, what was found and what was expected."
