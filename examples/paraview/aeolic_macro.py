"""A macro for ParaView: draws the active source by Aeolic, as the active view shows it, and shows the picture beside it.

Macros > Import new macro… takes this file. The picture has the view's camera, size and background, the source's colours
with their map and range, and streaks along the vectors that the Surface LIC representation has chosen, or else along the
first vectors there are. It needs the program `aeolic` on the path, or its place in the environment variable AEOLIC.
"""
import math
import os
import shutil
import subprocess
import tempfile

from paraview import print_error, print_warning, servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

SHOWN = "Aeolic"  # The name of the picture in the pipeline browser.
FLAT_DEGREES = 1.0  # The narrowest lens of Aeolic. From far away it draws nearly a parallel projection.


def surface_of(source, moment):
    """What the source shows at that moment, as one vtkPolyData."""
    if source.GetDataInformation().IsCompositeDataSet():
        source = servermanager.filters.MergeBlocks(Input=source)  # Not registered: the pipeline browser never sees them.
    outside = servermanager.filters.ExtractSurface(Input=source)
    outside.UpdatePipeline(moment)
    data = servermanager.Fetch(outside)
    if data is None or data.GetNumberOfPolys() + data.GetNumberOfStrips() == 0:
        raise RuntimeError("the active source has no surface")
    return data


def place_of(data, association):
    return data.GetCellData() if association == "CELLS" else data.GetPointData()


def vectors_of(display, data):
    """(association, name) of the vectors to follow."""
    chosen = getattr(display, "SelectInputVectors", None)
    if display.Representation == "Surface LIC" and chosen and chosen[1]:
        return chosen[0], chosen[1]
    for association in ("POINTS", "CELLS"):
        arrays = place_of(data, association)
        for i in range(arrays.GetNumberOfArrays()):
            array = arrays.GetArray(i)  # None for texts.
            if array and array.GetNumberOfComponents() == 3 and array.GetName() not in (None, "Normals"):
                return association, array.GetName()
    raise RuntimeError("the active source has no vectors; expected an array of three components on points or cells")


def color_word(rgb):
    return "".join(f"{round(255 * min(max(part, 0.0), 1.0)):02x}" for part in rgb)


def write_map(table, path):
    """Writes the colours of a view's colour map from its low end to its high end. Gives the values at the ends."""
    low, high = table.RGBPoints[0], table.RGBPoints[-4]
    colors = table.GetClientSideObject()
    with open(path, "w", encoding="ascii") as file:
        for i in range(256):
            part = (i + 0.5) / 256
            value = low * (high / low) ** part if table.UseLogScale and low > 0 else low + (high - low) * part
            rgb = [0.0] * 3
            colors.GetColor(value, rgb)
            file.write(",".join(f"{one:.6f}" for one in rgb) + "\n")
    return low, high


def component_of(array, component):
    """One component of an array's tuples, or their length, as an array with the name that ParaView shows."""
    values = vtk_to_numpy(array).reshape(array.GetNumberOfTuples(), -1).astype("f8")
    part = values[:, component] if component is not None else (values * values).sum(1) ** 0.5
    made = numpy_to_vtk(part, deep=True)
    made.SetName(f"{array.GetName()} {'Magnitude' if component is None else 'XYZ'[component] if component < 3 else component}")
    return made


def color_words(display, view, data, drawn, folder):
    """The options that show the source's colours. Adds the values that they are for to `drawn`."""
    association, name = (tuple(display.ColorArrayName) + (None, None))[:2]
    table = display.LookupTable
    if not name or not table:
        return []
    array = place_of(data, association).GetArray(name)
    if array is None:
        raise RuntimeError(f"the surface has no array '{name}', which the source is coloured by")
    if not display.MapScalars or table.VectorMode == "RGBA Colors" or table.InterpretValuesAsCategories:
        print_warning(f"aeolic: '{name}' holds colours or categories; the surface is drawn without them")
        return []
    if array.GetNumberOfComponents() > 1:
        array = component_of(array, table.VectorComponent if table.VectorMode == "Component" else None)
    place_of(drawn, association).AddArray(array)
    low, high = write_map(table, os.path.join(folder, "colors.csv"))
    words = ["--color-by", f"surface:{array.GetName()}", "--colormap", os.path.join(folder, "colors.csv"),
             "--color-scale", "log" if table.UseLogScale else "linear", "--nan-color", color_word(table.NanColor)]
    if low < high:
        words += ["--color-range", f"{low!r},{high!r}"]
    if table.UseBelowRangeColor:
        words += ["--below-color", color_word(table.BelowRangeColor)]
    if table.UseAboveRangeColor:
        words += ["--above-color", color_word(table.AboveRangeColor)]
    bar = simple.GetScalarBar(table, view) if display.IsScalarBarVisible(view) else None
    if bar is None:
        return words + ["--scalar-bar", "off"]
    return words + ["--scalar-bar", "on", "--legend", " ".join([bar.Title, bar.ComponentTitle]).strip() or array.GetName()]


def camera_word(view):
    """The view's camera. One of parallel projection becomes one with a long lens far away."""
    focal = list(view.CameraFocalPoint)
    eye, fov = list(view.CameraPosition), view.CameraViewAngle
    if view.CameraParallelProjection:
        away = [e - f for e, f in zip(eye, focal)]
        fov = FLAT_DEGREES
        distance = view.CameraParallelScale / math.tan(math.radians(fov) / 2)
        eye = [f + a * distance / math.hypot(*away) for f, a in zip(focal, away)]

    def numbers(values):
        return ",".join(repr(float(value)) for value in values)
    return f"position={numbers(eye)};focal={numbers(focal)};up={numbers(view.CameraViewUp)};fov={float(fov)!r}"


def draw(path):
    """Writes the picture of the active source and view to `path`. Raises RuntimeError with the line that says why not."""
    source, view = simple.GetActiveSource(), simple.GetActiveView()
    if source is None or not hasattr(view, "CameraPosition"):
        raise RuntimeError("there is no active source, or no active view of it")
    if source == simple.FindSource(SHOWN):
        raise RuntimeError("the active source is Aeolic's own picture; choose what to draw in the pipeline browser")
    program = os.environ.get("AEOLIC") or shutil.which("aeolic")
    if not program:
        raise RuntimeError("there is no program aeolic on the path, and AEOLIC names none")
    display = simple.GetRepresentation(source, view)
    data = surface_of(source, view.ViewTime)
    place, vectors = vectors_of(display, data)
    drawn = vtkPolyData()
    drawn.CopyStructure(data)
    place_of(drawn, place).AddArray(place_of(data, place).GetArray(vectors))
    with tempfile.TemporaryDirectory() as folder:
        colors = color_words(display, view, data, drawn, folder)
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(os.path.join(folder, "surface.vtp"))
        writer.SetInputData(drawn)
        if not writer.Write():
            raise RuntimeError("the surface cannot be written for aeolic")
        words = [program, "render", "--surface", writer.GetFileName(), "--vectors", vectors, *colors,
                 "--camera", camera_word(view), "--background", color_word(view.GetRenderer().GetBackground()),
                 "--size", "x".join(str(side) for side in view.ViewSize), "-o", path]
        done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip() or "aeolic failed")


def fill(beside, picture):
    """Lets a flat view show as much of itself as the picture needs."""
    left, right, low, high, _, _ = picture.GetDataInformation().GetBounds()
    beside.CameraPosition, beside.CameraFocalPoint = [right / 2, high / 2, right + high], [right / 2, high / 2, 0]
    beside.CameraViewUp = [0, 1, 0]
    width, height = beside.ViewSize
    beside.CameraParallelScale = max(high - low, (right - left) * height / max(width, 1)) / 2


def show(path):
    """Shows the picture in a view of its own: the same one for every picture. Source and view stay what is active."""
    source, view = simple.GetActiveSource(), simple.GetActiveView()
    picture = simple.FindSource(SHOWN)
    if picture is None:
        picture = simple.PNGSeriesReader(registrationName=SHOWN, FileNames=[path])
    picture.FileNames = [path]
    picture.UpdatePipeline()
    for beside in simple.GetRenderViews():
        if any(shown.Visibility and getattr(shown, "Input", None) == picture for shown in beside.Representations):
            break
    else:
        beside = simple.CreateView("RenderView")
        beside.InteractionMode = "2D"
        beside.OrientationAxesVisibility = 0
        simple.AssignViewToLayout(view=beside, layout=simple.GetLayout(view), hint=0)
        display = simple.Show(picture, beside, "UniformGridRepresentation")
        display.Representation = "Slice"
        simple.ColorBy(display, ("POINTS", "PNGImage"))
        display.MapScalars = 0
    fill(beside, picture)
    simple.Render(beside)
    simple.SetActiveView(view)
    simple.SetActiveSource(source)


if __name__ in ("__main__", "__vtkconsole__"):
    try:
        picture_file = os.path.join(tempfile.mkdtemp(prefix="aeolic-"), "picture.png")
        draw(picture_file)
        show(picture_file)
        print(picture_file)
    except RuntimeError as error:
        print_error(f"aeolic: {error}")
