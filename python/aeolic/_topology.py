"""The skeleton of the flow on a surface, as numpy arrays."""
from typing import Any, NamedTuple, Optional

from ._checks import lines_file
from ._options import KEYWORDS, documented
from ._render import Renderer


class TopologyLine(NamedTuple):
    """A line that parts regions of the flow: from a saddle, or an open one, which streamlines gather at."""
    kind: str  #: "separation" (downstream of its saddle) or "attachment" (upstream)
    saddle: Optional[int]  #: Which of the points it begins at; None for an open line.
    end: Optional[int]  #: The point it ends at; None where it leaves the surface or closes.
    length: float  #: World units.
    strength: float  #: That of its saddle. Of an open line: by which power of e streamlines lie closer on it than on average.
    positions: Any  #: (places, 3), from the saddle on; of an open line downstream.
    vectors: Any  #: (places, 3), as the data have them.
    scalars: Optional[Any]  #: (places,) of color_by; None without it.


class Topology:
    """The critical points of the flow along a surface, and the lines that leave its saddles.

    positions: (points, 3) float64. kinds: of each "node", "focus", "centre", "saddle" or "multiple". attracts: (points,) 1
    for a node or focus that streamlines run into, -1 for one that they come out of, else 0. indices: (points,) turns of the
    flow around it. strengths: (points,) the root of the determinant of the flow's derivative. vectors: (points, 3).
    scalars: (points,) of color_by, and scalar_name; None without it. lines: a tuple of TopologyLine.
    """

    def __init__(self, core):
        self._core = core
        self.__dict__.update(core.points())
        self.lines = tuple(TopologyLine(*line) for line in core.lines())

    def save(self, path):
        """Writes a .vtp or .csv file, as `aeolic extract` does. Raises InputError for another kind of name, OSError
        if the file cannot be written."""
        self._core.save(*lines_file(path))

    def __repr__(self):
        return f"<aeolic.Topology of {len(self.kinds)} points and {len(self.lines)} lines>"


@documented(KEYWORDS)
def topology(surface=None, *, field=None, scene=None, progress=None, **options):
    """The Topology of the flow on a surface: what overlay="topology" draws. The arguments are those of Renderer; persistence=
    says which pairs of points are left out. Renderer.topology() gives that of a scene that is loaded already."""
    return topology_of(Renderer(surface, field=field, scene=scene, progress=progress, **options))


@documented(KEYWORDS)
def separation(surface=None, *, field=None, scene=None, progress=None, **options):
    """The open lines of separation and attachment of the flow on a surface, as a Topology without points: what
    overlay="separation" draws, the strongest first. The arguments are those of Renderer; lines closer together than
    persistence= are one. Renderer.separation() gives those of a scene that is loaded already."""
    return separation_of(Renderer(surface, field=field, scene=scene, progress=progress, **options))


def topology_of(renderer):
    return Topology(renderer._loaded.topology())


def separation_of(renderer):
    return Topology(renderer._loaded.separation())
