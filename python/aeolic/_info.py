"""What files hold."""
from typing import NamedTuple, Optional, Tuple

from . import _core
from ._checks import path as path_of


class ArrayInfo(NamedTuple):
    """An array of a file."""
    name: str
    association: str  #: "points", "cells" or "field"
    type: str  #: "float", "double", "int" …
    components: int
    range: Optional[Tuple[float, float]]  #: Of finite values, of lengths where it has several components.


class PartInfo(NamedTuple):
    """A part of a file that a surface can name: FILE:PART."""
    name: str
    type: str
    cells: int  #: Polygons of a surface.
    fills_space: bool


class FileInfo(NamedTuple):
    """What a file holds. str() of it is the text of `aeolic info`."""
    text: str
    kind: str  #: "polygons", "image data" …
    points: int
    cells: int
    bounds: Optional[Tuple[float, float, float, float, float, float]]  #: x, y, z: least and most of each.
    times: Tuple[float, ...]  #: Empty where nothing changes.
    arrays: Tuple[ArrayInfo, ...]
    parts: Tuple[PartInfo, ...]  #: Empty where it is not of several parts.
    vectors: Optional[str]  #: The array that is drawn where none is named.
    suggestions: Tuple[str, ...]  #: `aeolic render` commands to try first.

    def __str__(self):
        return self.text

    def __repr__(self):
        names = ", ".join(array.name for array in self.arrays)
        return f"<aeolic.FileInfo: {self.kind}, {self.points} points, {self.cells} cells, arrays: {names or 'none'}>"


def info(path):
    """What a file holds, and what to draw first: a FileInfo, whose text is that of `aeolic info`. Reads the whole file, or
    the first of a series. Raises InputError if it cannot be read."""
    told = _core.file_info(path_of("path", path))
    told["arrays"] = tuple(ArrayInfo(*array) for array in told["arrays"])
    told["parts"] = tuple(PartInfo(*part) for part in told["parts"])
    return FileInfo(**told)
