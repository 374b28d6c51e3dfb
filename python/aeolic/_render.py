"""Renderer, render() and info()."""
import json
import os
import threading
import warnings
import weakref
import webbrowser
from collections.abc import Iterable

from . import _core
from ._checks import number, path as path_of, refuse_unknown, suggesting, whole
from ._data import Grid, InputError, Surface, Volume
from ._options import CHANGEABLE, KEYWORDS, TABLE, camera_text, documented, scene_given, texts
from ._pick import PickedPlace, PictureBuffers
from ._show import Server, Viewer, in_notebook, proxy_text, served
from ._surfaces import contexts_of, items_of
from ._vectors import named_vectors, prepared
from ._vtk import field_of, is_vtk, surface_of, unwrapped


# Keywords that set() does not change, and those that it does.
ELSEWHERE = {"camera": "render(camera=…)", "time": "renderer.time = …"}
RELATIVE = ("azimuth", "elevation", "roll", "zoom")  # What a camera with a position does without.
ARGUMENTS = ["surface", "field", "scene", "progress", *KEYWORDS]


def _source(keyword, value, kinds, convert):
    """(text, memory): what the command line's option would say, or data in memory."""
    if value is None or isinstance(value, (str, os.PathLike)):
        return value, None
    if isinstance(value, kinds):
        return None, value
    value = unwrapped(value)
    if is_vtk(value):
        return None, convert(value)
    raise TypeError(f"{keyword}: found {type(value).__name__}; expected a text, "
                    f"{' or '.join('an aeolic.' + kind.__name__ for kind in kinds)}, or a VTK object")


def _as_surface(value):
    if not is_vtk(value, "vtkPolyData"):
        raise InputError(f"surface in memory: found a {value.GetClassName()}; expected a vtkPolyData (a field goes to field=)")
    return surface_of(value)


def _active_vectors(memory):
    """Where the vectors are that are drawn where no option names others, and their name; None where nothing says so."""
    active = {} if memory is None else memory["active"]
    return next(((key, active[key, "vectors"]) for key in ("point_data", "cell_data") if (key, "vectors") in active), None)


def _memory(data, vectors, drawn_before):
    """What the library is told of the data. drawn_before: the active vectors of the data before, as _active_vectors() gives
    them. They stay the active ones where the data have an array of that name."""
    if data is None or drawn_before is None:
        return prepared(data, vectors)
    key, name = drawn_before
    kept = next((arrays for arrays in (key, "point_data", "cell_data") if name in dict(data._memory[arrays])), None)
    active = {} if kept is None else {(kept, "vectors"): name}
    return prepared(data, vectors, active)


@documented(KEYWORDS)
class Renderer:
    """Draws flow on a surface. Loads once, and then draws any number of pictures.

    surface: a file's name, a built-in (teapot[:TRIANGLES], sphere, torus, plane, wave), a cut of the field
        (slice:OX,OY,OZ:NX,NY,NZ, isosurface:ARRAY=VALUE, boundary, image), an aeolic.Surface, or a vtkPolyData. Or a list,
        for several surfaces in one picture: of such texts, and of dicts of "surface" (such a text) and, where they are to
        differ from surface to surface, "vectors", "color_by", "colormap", "color_range", "legend", "streaks" (False: drawn
        without) and "shown" (False: loaded, but not drawn).
    field: a file's name, a built-in flow, an aeolic.Grid or aeolic.Volume, a vtkImageData, vtkUnstructuredGrid,
        vtkStructuredGrid or vtkRectilinearGrid; one that is even is a grid. None: the surface's own vectors.
    scene: the name of a scene file, or a dict of what one holds, as a Renderer's scene tells it; the other arguments
        override what it says.
    progress: is called with a text and a number from 0 to 1 while the scene loads. What it raises ends the loading.

    All other arguments are the options of `aeolic render --help`, with _ in the place of -. The same options give the
    same bytes.
    """

    def __init__(self, surface=None, *, field=None, scene=None, progress=None, **options):
        refuse_unknown("Renderer", options, ARGUMENTS)
        self._loaded = self._served = None
        self._viewer = lambda: None
        self._showing = threading.RLock()
        if progress is not None and not callable(progress):
            raise TypeError(f"progress: found {type(progress).__name__}; expected a function")
        items = items_of(surface)
        contexts = contexts_of(options.pop("context", None))
        surface_text, surface_memory = _source("surface", None if items else surface, (Surface,), _as_surface)
        field_text, field_memory = _source("field", field, (Grid, Volume), field_of)
        self._of_cells = isinstance(field_memory, Volume)
        given = texts({"surface": surface_text, "field": field_text, **options})
        if contexts and surface_memory is not None:
            raise InputError("context: found together with a surface in memory; expected a surface from a file, or none")
        vectors = named_vectors(options.get("vectors"), scene)
        memory = prepared(surface_memory, vectors), prepared(field_memory, vectors)
        self._active = tuple(map(_active_vectors, memory))
        self._loaded = _core.Loaded(*scene_given(scene), given, items, contexts, *memory, progress)

    @suggesting
    def render(self, camera=None):
        """A Picture. camera: a dict of azimuth, elevation, roll, zoom, fov (degrees; numbers), position, focal, up (three
        numbers each), or the command line's text; values not named are as they were when the Renderer was made."""
        return self._loaded.render(camera_text(camera))

    def frames(self):
        """The pictures of the animation that frames=, orbit= and time_range= describe, one after the other, whatever time= was
        set to."""
        for index in range(json.loads(self._loaded.scene())["output"]["frames"]):
            yield self._loaded.render_frame(index)

    def save_animation(self, path, progress=None):
        """Writes the pictures of frames() to one file: .webp, .apng or .mp4, or to numbered .png and .jpg. With flow="loop"
        also .html, a page that plays in any browser; such a cycle has 48 pictures where frames= does not say how many. All
        is checked before the first picture is drawn. progress as for Renderer."""
        if progress is not None and not callable(progress):
            raise TypeError(f"progress: found {type(progress).__name__}; expected a function")
        self._loaded.save_animation(path_of("path", path), progress)

    @documented(CHANGEABLE)
    def set(self, **options):
        """Changes options of the pictures to come. Nothing is loaded again. None brings back what holds without the option:
        what the scene file says, or the default."""
        refuse_unknown("set", options, KEYWORDS)
        for name in options:
            if name in ELSEWHERE:
                raise InputError(f"set: {name}: found an option that it does not change; expected {ELSEWHERE[name]}")
            if name not in CHANGEABLE:
                raise InputError(f"{name}: it belongs to the loaded scene; expected one of "
                                 f"{', '.join(CHANGEABLE)}, or a new Renderer")
        self._loaded.set(texts(options), [TABLE[name]["option"] for name, value in options.items() if value is None])

    @suggesting
    def set_data(self, surface=None, field=None, progress=None):
        """Shows other data in memory, in the place of the one of the same kind that the Renderer was made with: an
        aeolic.Surface or vtkPolyData; an aeolic.Grid or vtkImageData; an aeolic.Volume, vtkUnstructuredGrid,
        vtkStructuredGrid or vtkRectilinearGrid. None stays. Camera fit, noise and colour range stay those of the first."""
        surface_text, surface_memory = _source("surface", surface, (Surface,), _as_surface)
        field_text, field_memory = _source("field", field, (Grid, Volume), lambda data: field_of(data, self._of_cells))
        if surface_text is not None or field_text is not None:
            raise TypeError("set_data: found a text; expected data in memory (a file takes a new Renderer)")
        vectors = named_vectors(self.scene["field"]["vectors"], None)
        memory = [_memory(data, vectors, before) for data, before in zip((surface_memory, field_memory), self._active)]
        self._loaded.set_data(*memory, progress)

    def set_shown(self, shown):
        """Which of several surfaces are drawn in the pictures to come: a row of True and False, one for each in the order
        of scene["surfaces"], contexts last. Nothing is loaded again. Raises InputError for another number of them."""
        if isinstance(shown, (str, bytes)) or not isinstance(shown, Iterable):
            raise TypeError(f"set_shown: found {type(shown).__name__}; expected a row of True and False")
        try:
            switches = [bool(one) for one in shown]
        except ValueError:  # An array is neither true nor false.
            raise InputError("set_shown: found rows of several; expected a row of True and False") from None
        self._loaded.set_shown(switches)

    def pick(self, x, y, camera=None):
        """What the picture shows at pixel (x, y), counted from the upper left: a PickedPlace, or None on the background. camera
        as for render(). Nothing is drawn. Raises InputError for a pixel outside of the picture."""
        found = self._loaded.pick(x, y, camera_text(camera))
        return found and PickedPlace(**found)

    def buffers(self, camera=None):
        """What all pixels of the picture show: PictureBuffers. camera as for render()."""
        return PictureBuffers(**self._loaded.buffers(camera_text(camera)))

    def topology(self):
        """The Topology of the flow along the surface as it is shown now: its moment, its persistence. A
        surface in pieces is gathered on every rank; InputError where it has no memory for it."""
        from ._topology import topology_of  # It needs this module.
        return topology_of(self)

    def separation(self):
        """The open lines of separation and attachment on the surface as it is shown now, as a Topology without points. The
        rest is as for topology()."""
        from ._topology import separation_of  # It needs this module.
        return separation_of(self)

    def streamlines(self):
        """The Streamlines on the surface as it is shown now, as far apart as overlay= says where the surface's middle is in
        the picture. The rest is as for topology()."""
        from ._streamlines import streamlines_of  # It needs this module.
        return streamlines_of(self)

    @property
    def time(self):
        """The moment that render() and viewers show, in the data's own unit of time. Setting it loads data not yet in
        memory. The animation of frames() stays as it is, and so does what scene tells of time_range=."""
        return self._loaded.info()["time"]

    @time.setter
    def time(self, moment):
        self._loaded.set_time(number("time", moment))

    @property
    def times(self):
        """The moments of all steps, sorted; empty where nothing changes."""
        return tuple(self._loaded.info()["times"])

    @property
    def info(self):
        """Facts of the loaded scene: a dict of backend, device, simd, unused_gpu, threads, load_ms, field_bytes, triangles, times,
        time, warnings."""
        return self._loaded.info()

    @property
    def stats(self):
        """Where the last picture's time went: a dict as --stats writes it."""
        return json.loads(self._loaded.stats())

    @property
    def scene(self):
        """All options, as a scene file holds them: a dict, which Renderer(scene=…) takes."""
        scene = json.loads(self._loaded.scene())
        if "position" in scene["camera"]:  # Which nothing else of the view changes.
            scene["camera"] = {key: value for key, value in scene["camera"].items() if key not in RELATIVE}
        return scene

    @suggesting
    def show(self, *, browser=None, controls=None, title="Program", port=0, height=600, proxy=None):
        """Shows the scene in a browser, live: from a server in this process, with data in memory, too. What set(),
        set_data() and time change shows there at once. In a notebook the page is in the cell. Gives a Viewer. The page is
        there until that is closed, or until nobody holds the Renderer or a Viewer of it.

        browser: whether to open one. None: not in a notebook.
        controls: a dict of things on the page that Viewer.value() reads: (lowest, highest, value) for a slider, True or
            False for a switch, "button". title: what stands over them.
        port: of the server, on 127.0.0.1; 0: any that is free.
        height: of the page in a notebook, in pixels.
        proxy: the path under which the notebook's own address leads to this host's ports, such as "/proxy/{port}/". None:
            that of JupyterHub's jupyter-server-proxy in a kernel of one, else none.

        Raises InputError for a port that cannot be had, for controls that are none, and where the scene is shown
        already with others."""
        asked = served(port, title, controls)
        proxy, height = proxy_text(proxy), whole("height", height, 1, 100000)
        self._loaded.require_free()  # A progress function would wait for a thread that waits for it.
        with self._showing:
            if self._served is None or not self._served.is_open:
                self._served = Server(self, self._loaded, asked)
            else:
                self._served.refuse_others(*asked)
            viewer = self._viewer()
            if viewer is None or not viewer.is_open:  # Its page goes on without it.
                viewer = Viewer(self, self._served, height, proxy)
                self._viewer = weakref.ref(viewer)
        if browser or (browser is None and not in_notebook()):
            webbrowser.open(viewer.address)
        return viewer

    def __repr__(self):
        if self._loaded is None:
            return "<aeolic.Renderer of nothing>"
        info = self._loaded.info()
        return f"<aeolic.Renderer of {info['triangles']} triangles on {info['backend']}>"


@documented(KEYWORDS)
def render(surface=None, *, field=None, scene=None, progress=None, **options):
    """Draws one Picture: what `aeolic render` writes, or the first picture of an animation. The arguments are those of
    Renderer, which draws many. What `aeolic render` warns of is a UserWarning each."""
    refuse_unknown("render", options, ARGUMENTS)
    renderer = Renderer(surface, field=field, scene=scene, progress=progress, **options)
    picture = renderer._loaded.render_frame(0)
    for warning in dict.fromkeys(renderer._loaded.warnings()):
        warnings.warn(warning, stacklevel=2)
    return picture

