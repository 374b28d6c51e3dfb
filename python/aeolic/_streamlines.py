"""Evenly spaced streamlines on a surface, as numpy arrays."""
from typing import Any, NamedTuple, Optional

from ._checks import lines_file
from ._options import KEYWORDS, documented
from ._render import Renderer


class Streamline(NamedTuple):
    """A streamline on a surface."""
    length: float  #: World units.
    closed: bool  #: It comes back to its beginning: the first place and the last are the same.
    positions: Any  #: (places, 3), downstream.
    vectors: Any  #: (places, 3), as the data have them.
    scalars: Optional[Any]  #: (places,) of color_by; None without it.


class Streamlines:
    """Streamlines that keep about the same distance from each other.

    spacing: that distance, world units. lines: a tuple of Streamline. scalar_name: what color_by names; None without it.
    """

    def __init__(self, core):
        self._core = core
        self.spacing, self.scalar_name = core.spacing, core.scalar_name
        self.lines = tuple(Streamline(*line) for line in core.lines())

    def save(self, path):
        """Writes a .vtp or .csv file, as `aeolic extract streamlines` does. Raises InputError for another kind of name,
        OSError if the file cannot be written."""
        self._core.save(*lines_file(path))

    def __repr__(self):
        return f"<aeolic.Streamlines, {len(self.lines)} lines {self.spacing:.6g} apart>"


@documented(KEYWORDS)
def streamlines(surface=None, *, field=None, scene=None, progress=None, **options):
    """The Streamlines of the flow on a surface: those of overlay="streamlines:PX" where they are as far apart as in the middle
    of the picture. The arguments are those of Renderer. Renderer.streamlines() gives those of a scene that is loaded."""
    return streamlines_of(Renderer(surface, field=field, scene=scene, progress=progress, **options))


def streamlines_of(renderer):
    return Streamlines(renderer._loaded.streamlines())
