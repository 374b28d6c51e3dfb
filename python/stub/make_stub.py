"""Writes aeolic/__init__.pyi: make_stub.py FILE. The module that it imports tells which options there are."""
import sys

import aeolic
from aeolic import _options, _plane

HEAD = '''\
# Made of the program's table of options by make_stub.py.
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Literal, NamedTuple

import numpy
from numpy.typing import ArrayLike

__version__: str

class InputError(ValueError): ...

class Picture:
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def channels(self) -> int: ...
    @property
    def shape(self) -> tuple[int, int, int]: ...
    @property
    def __array_interface__(self) -> dict[str, Any]: ...
    def save(self, path: str | os.PathLike[str]) -> None: ...
    def _repr_png_(self) -> bytes: ...

class Viewer:
    address: str
    height: int
    @property
    def is_open(self) -> bool: ...
    def value(self, control: str) -> float: ...
    def set_value(self, control: str, value: float) -> None: ...
    def close(self) -> None: ...
    def __enter__(self) -> Viewer: ...
    def __exit__(self, *_: Any) -> None: ...

class ArrayInfo(NamedTuple):
    name: str
    association: str
    type: str
    components: int
    range: tuple[float, float] | None

class PartInfo(NamedTuple):
    name: str
    type: str
    cells: int
    fills_space: bool

class FileInfo(NamedTuple):
    text: str
    kind: str
    points: int
    cells: int
    bounds: tuple[float, float, float, float, float, float] | None
    times: tuple[float, ...]
    arrays: tuple[ArrayInfo, ...]
    parts: tuple[PartInfo, ...]
    vectors: str | None
    suggestions: tuple[str, ...]

class PickedPlace(NamedTuple):
    position: tuple[float, float, float]
    depth: float
    normal: tuple[float, float, float]
    triangle: int
    surface: str
    vector_name: str | None
    vector: tuple[float, float, float] | None
    tangential: tuple[float, float, float] | None
    scalar: float | None
    scalar_name: str | None

class PictureBuffers(NamedTuple):
    depth: numpy.ndarray
    normal: numpy.ndarray
    flow: numpy.ndarray
    lic: numpy.ndarray
    scalar: numpy.ndarray | None
    surface: numpy.ndarray
    @property
    def covered(self) -> numpy.ndarray: ...

class Streamline(NamedTuple):
    length: float
    closed: bool
    positions: numpy.ndarray
    vectors: numpy.ndarray
    scalars: numpy.ndarray | None


class Streamlines:
    spacing: float
    scalar_name: str | None
    lines: tuple[Streamline, ...]
    def save(self, path: str | os.PathLike[str]) -> None: ...


class TopologyLine(NamedTuple):
    kind: str
    saddle: int | None
    end: int | None
    length: float
    strength: float
    positions: numpy.ndarray
    vectors: numpy.ndarray
    scalars: numpy.ndarray | None

class Topology:
    positions: numpy.ndarray
    kinds: tuple[str, ...]
    attracts: numpy.ndarray
    indices: numpy.ndarray
    strengths: numpy.ndarray
    vectors: numpy.ndarray
    scalars: numpy.ndarray | None
    scalar_name: str | None
    lines: tuple[TopologyLine, ...]
    def save(self, path: str | os.PathLike[str]) -> None: ...

class Surface:
    def __init__(self, points: ArrayLike, triangles: ArrayLike | None = ..., *,
                 polygons: tuple[ArrayLike, ArrayLike] | None = ...,
                 point_data: Mapping[str, ArrayLike] | None = ..., cell_data: Mapping[str, ArrayLike] | None = ...) -> None: ...

class Grid:
    def __init__(self, origin: Sequence[float], spacing: Sequence[float] | float, point_data: Mapping[str, ArrayLike],
                 cell_data: Mapping[str, ArrayLike] | None = ...) -> None: ...

class Volume:
    def __init__(self, points: ArrayLike, cells: ArrayLike | tuple[ArrayLike, ArrayLike], types: ArrayLike | None = ..., *,
                 faces: tuple[ArrayLike, ArrayLike] | None = ...,
                 point_data: Mapping[str, ArrayLike] | None = ..., cell_data: Mapping[str, ArrayLike] | None = ...) -> None: ...
'''

SOURCES = '''\
{indent}surface: str | os.PathLike[str] | Surface | Sequence[str | os.PathLike[str] | Mapping[str, Any]] | Any | None = ..., *,
{indent}field: str | os.PathLike[str] | Grid | Volume | Any | None = ...,
{indent}scene: str | os.PathLike[str] | Mapping[str, Any] | None = ...,
{indent}progress: Callable[[str, float], Any] | None = ...,
'''


def options(names, indent):
    return "".join(f"{indent}{name}: {_options.TABLE[name]['type']} | None = ...,\n" for name in names)


def stub():
    deep, indent = " " * 8, " " * 4
    return (HEAD + "\nclass Renderer:\n    def __init__(\n        self,\n" + SOURCES.format(indent=deep) +
            options(_options.KEYWORDS, deep) + "    ) -> None: ...\n" +
            "    def render(self, camera: Mapping[str, Any] | str | None = ...) -> Picture: ...\n" +
            "    def frames(self) -> Iterator[Picture]: ...\n" +
            "    def save_animation(self, path: str | os.PathLike[str], progress: Callable[[str, float], Any] | None = ...) -> None: ...\n" +
            "    def show(self, *, browser: bool | None = ..., controls: Mapping[str, Any] | None = ..., title: str = ...,\n"
            "             port: int = ..., height: int = ..., proxy: str | None = ...) -> Viewer: ...\n" +
            "    def set(\n        self, *,\n" + options(_options.CHANGEABLE, deep) + "    ) -> None: ...\n" +
            "    def set_data(self, surface: Surface | Any | None = ..., field: Grid | Volume | Any | None = ...,\n"
            "                 progress: Callable[[str, float], Any] | None = ...) -> None: ...\n"
            "    def set_shown(self, shown: Sequence[bool]) -> None: ...\n"
            "    def buffers(self, camera: Mapping[str, Any] | str | None = ...) -> PictureBuffers: ...\n"
            "    def pick(self, x: int, y: int, camera: Mapping[str, Any] | str | None = ...) -> PickedPlace | None: ...\n"
            "    def topology(self) -> Topology: ...\n"
            "    def separation(self) -> Topology: ...\n"
            "    def streamlines(self) -> Streamlines: ...\n"
            "    @property\n    def time(self) -> float: ...\n    @time.setter\n    def time(self, moment: float) -> None: ...\n" +
            "    @property\n    def times(self) -> tuple[float, ...]: ...\n" +
            "".join(f"    @property\n    def {name}(self) -> dict[str, Any]: ...\n" for name in ("info", "stats", "scene")) +
            "\ndef render(\n" + SOURCES.format(indent=indent) + options(_options.KEYWORDS, indent) + ") -> Picture: ...\n" +
            "def topology(\n" + SOURCES.format(indent=indent) + options(_options.KEYWORDS, indent) + ") -> Topology: ...\n" +
            "def separation(\n" + SOURCES.format(indent=indent) + options(_options.KEYWORDS, indent) + ") -> Topology: ...\n" +
            "def streamlines(\n" + SOURCES.format(indent=indent) + options(_options.KEYWORDS, indent) + ") -> Streamlines: ...\n" +
            "def info(path: str | os.PathLike[str]) -> FileInfo: ...\n" +
            "def lic2d(\n    u: ArrayLike, v: ArrayLike, *, spacing: Sequence[float] | float = ..., texture: ArrayLike | None = ...,\n"
            "    boundary: Literal[\"closed\", \"periodic\"] = ...,\n"
            "    uv_mode: Literal[\"velocity\", \"polarization\"] = ...,\n" + options(_plane.PLANE_OPTIONS, indent) +
            ") -> numpy.ndarray: ...\n")


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(stub())
