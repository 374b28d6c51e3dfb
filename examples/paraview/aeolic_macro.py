"""A macro for ParaView: draws the active source by Aeolic, as the active view shows it, and opens the picture.

Macros > Import new macro… takes this file. The picture has the view's camera, size and background, the source's colours
with their map and range, and streaks along the vectors that the Surface LIC representation has chosen, or else along the
first point vectors. It needs the program `aeolic` on the path, or its place in the environment variable AEOLIC.
"""
import json
import os
import shutil
import subprocess
import tempfile
import webbrowser

from paraview import servermanager, simple


def surface_of(source):
    """What the source shows, as one vtkPolyData."""
    merged = simple.MergeBlocks(Input=source)
    outside = simple.ExtractSurface(Input=merged)
    try:
        outside.UpdatePipeline()
        return servermanager.Fetch(outside)
    finally:
        for made in (outside, merged):
            simple.Delete(made)


def vectors_of(display, data):
    """The name of the vectors to follow."""
    chosen = getattr(display, "SelectInputVectors", None)
    if display.Representation == "Surface LIC" and chosen and chosen[1]:
        return chosen[1]
    for arrays in (data.GetPointData(), data.GetCellData()):
        for i in range(arrays.GetNumberOfArrays()):
            name = arrays.GetArrayName(i)
            if arrays.GetArray(i) and arrays.GetArray(i).GetNumberOfComponents() == 3 and name != "Normals":
                return name
    raise RuntimeError("the active source has no vectors; expected an array of three components on points or cells")


def color_words(display, folder):
    """The options that show the source's colours, its own map included."""
    name = display.ColorArrayName[1] if display.ColorArrayName and display.ColorArrayName[0] else ""
    table = display.LookupTable
    if not name or not table:
        return []
    points = list(table.RGBPoints)
    low, high = points[0], points[-4]
    path = os.path.join(folder, "colors.json")
    with open(path, "w") as file:
        json.dump([{"Name": "of the view", "ColorSpace": str(table.ColorSpace), "RGBPoints": points}], file)
    arrays = [display.Input.PointData.GetArray(name), display.Input.CellData.GetArray(name)]
    count = max(array.GetNumberOfComponents() for array in arrays if array)
    words = ["--color-by", name if count == 1 else f"{name}:mag", "--colormap", path]
    return words + (["--color-range", f"{low!r},{high!r}"] if low < high else [])


def camera_word(view):
    def numbers(values):
        return ",".join(repr(float(value)) for value in values)
    return (f"position={numbers(view.CameraPosition)};focal={numbers(view.CameraFocalPoint)};"
            f"up={numbers(view.CameraViewUp)};fov={float(view.CameraViewAngle)!r}")


def background_word(view):
    return "".join(f"{round(255 * part):02x}" for part in view.Background)


def draw(path):
    """Writes the picture of the active source and view to `path`. Raises RuntimeError with the line that says why not."""
    source, view = simple.GetActiveSource(), simple.GetActiveView()
    if source is None or view is None:
        raise RuntimeError("there is no active source or view")
    program = os.environ.get("AEOLIC") or shutil.which("aeolic")
    if not program:
        raise RuntimeError("there is no program aeolic on the path, and AEOLIC names none")
    if getattr(view, "CameraParallelProjection", 0):
        print("aeolic: the view is in parallel projection; the picture is in perspective")
    data, display = surface_of(source), simple.GetDisplayProperties(source, view)
    with tempfile.TemporaryDirectory() as folder:
        from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(os.path.join(folder, "surface.vtp"))
        writer.SetInputData(data)
        if not writer.Write():
            raise RuntimeError("the surface cannot be written for aeolic")
        words = [program, "render", "--surface", writer.GetFileName(), "--vectors", vectors_of(display, data),
                 *color_words(display, folder), "--camera", camera_word(view), "--background", background_word(view),
                 "--size", "x".join(str(side) for side in view.ViewSize), "-o", path]
        done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip() or "aeolic failed")
    return path


if __name__ in ("__main__", "__vtkconsole__"):
    picture = draw(os.path.join(tempfile.mkdtemp(prefix="aeolic-"), "picture.png"))
    print(picture)
    webbrowser.open(f"file://{picture}")
