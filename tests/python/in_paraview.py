"""Runs in ParaView's Python: views, what ParaView makes of them, and what the macro makes of them.

Arguments: FOLDER, which holds the surfaces, and into which the pictures and facts.json go.
"""
import importlib.util
import json
import os
import pathlib
import sys

import numpy
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

folder = pathlib.Path(sys.argv[1])
macro_file = pathlib.Path(__file__).resolve().parents[2] / "examples" / "paraview" / "aeolic_macro.py"
specification = importlib.util.spec_from_file_location("aeolic_macro", macro_file)
macro = importlib.util.module_from_spec(specification)
specification.loader.exec_module(macro)
facts = {}


def pixels(path):
    reader = servermanager.sources.PNGSeriesReader(FileNames=[str(path)])  # Not simple's, which would become active.
    reader.UpdatePipeline()
    image = servermanager.Fetch(reader)
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3].copy()
    return values


def fresh(source, moment=0.0, size=(300, 200)):
    """A view of the source alone, turned."""
    view = simple.CreateView("RenderView")
    view.ViewSize = list(size)
    view.OrientationAxesVisibility = 0
    view.ViewTime = moment
    display = simple.Show(source, view)
    simple.SetActiveView(view)
    simple.SetActiveSource(source)
    simple.ResetCamera(view)
    view.GetActiveCamera().Azimuth(40)
    view.GetActiveCamera().Elevation(30)
    return view, display


def take(name, view, display):
    """ParaView's picture, without light, and the macro's."""
    display.Ambient, display.Diffuse = 1.0, 0.0
    simple.Render(view)
    simple.SaveScreenshot(str(folder / "view.png"), view)
    numpy.save(folder / f"{name}-view.npy", pixels(folder / "view.png"))
    macro.draw(str(folder / f"{name}.png"))
    numpy.save(folder / f"{name}-macro.npy", pixels(folder / f"{name}.png"))
    facts[name] = {"camera": [list(view.CameraPosition), list(view.CameraFocalPoint), list(view.CameraViewUp)],
                   "fov": view.CameraViewAngle, "background": list(view.Background),
                   "active": simple.GetActiveView() == view}


def color(view, display, association, name, points, **settings):
    simple.ColorBy(display, (association, name))
    table = simple.GetColorTransferFunction(name, display, True)  # Of this display alone.
    table.RGBPoints, table.ColorSpace = points, settings.pop("ColorSpace", "RGB")
    for key, value in settings.items():
        setattr(table, key, value)
    display.LookupTable = table
    display.SetScalarBarVisibility(view, False)
    return table


def body():
    return simple.XMLPolyDataReader(FileName=[str(folder / "body.vtp")])


def complaint(action):
    try:
        action()
    except RuntimeError as error:
        return str(error)
    return None


# Colours on points, over a part of their range, in a view in perspective.
source = body()
view, display = fresh(source)
color(view, display, "POINTS", "q", [0.3, 1, 0, 0, 1.5, 0, 1, 0, 2.5, 0, 0, 1])
take("points", view, display)
facts["points"]["sources"] = len(simple.GetSources())

# The picture beside the view, twice.
for _ in range(2):
    macro.show(str(folder / "points.png"))
beside = [one for one in simple.GetRenderViews() if one != view]
facts["shown"] = {"views": len(beside), "source": simple.GetActiveSource() == source, "view": simple.GetActiveView() == view}
beside[0].ViewSize = [300, 200]
macro.show(str(folder / "points.png"))
simple.SaveScreenshot(str(folder / "beside.png"), beside[0])
numpy.save(folder / "shown.npy", pixels(folder / "beside.png"))
simple.SetActiveSource(simple.FindSource("Aeolic"))
facts["of itself"] = complaint(lambda: macro.draw(str(folder / "none.png")))

# As the menu runs it.
simple.SetActiveSource(source)
exec(compile(macro_file.read_text(), str(macro_file), "exec"), {"__name__": "__vtkconsole__"})

# The same in equal ratios.
view, display = fresh(source)
color(view, display, "POINTS", "q", [0.01, 1, 0, 0, 0.5, 0, 1, 0, 3, 0, 0, 1], UseLogScale=1)
take("log", view, display)

# Colours on cells with others below and above, in parallel projection, and a legend.
view, display = fresh(source)
view.CameraParallelProjection = 1
view.CameraParallelScale = 0.8
table = color(view, display, "CELLS", "c", [128, 0, 0, 0, 512, 1, 1, 0], UseBelowRangeColor=1,
              BelowRangeColor=[0, 0, 1], UseAboveRangeColor=1, AboveRangeColor=[1, 0, 1])
take("cells", view, display)
display.SetScalarBarVisibility(view, True)
simple.Render(view)
macro.draw(str(folder / "legend.png"))
numpy.save(folder / "legend-macro.npy", pixels(folder / "legend.png"))

# One component of vectors, in steps, by Surface LIC's own choice of vectors where there are two.
view, display = fresh(source)
color(view, display, "POINTS", "tau", [0.0, 1, 1, 0, 1, 0, 0, 1], VectorMode="Component", VectorComponent=1, Discretize=1,
      NumberOfTableValues=2)
take("component", view, display)

# The vectors that Surface LIC follows, which are not the first.
calculator = simple.Calculator(Input=source, ResultArrayName="across", Function="iHat*tau_Y-jHat*tau_X")
view, display = fresh(calculator)
take("first", view, display)
try:
    display.SetRepresentationType("Surface LIC")
    display.SelectInputVectors = ["POINTS", "across"]
    macro.draw(str(folder / "chosen.png"))
    numpy.save(folder / "chosen-macro.npy", pixels(folder / "chosen.png"))
except (RuntimeError, ValueError) as error:
    facts["no Surface LIC"] = str(error)

# Several parts in one source.
view, display = fresh(simple.GroupDatasets(Input=[body(), simple.XMLPolyDataReader(FileName=[str(folder / "other.vtp")])]))
color(view, display, "POINTS", "q", [0, 1, 0, 0, 3, 0, 0, 1])
take("parts", view, display)

# Data that change in time.
series = simple.PVDReader(FileName=str(folder / "series.pvd"))
simple.UpdatePipeline(1.0, series)
view, display = fresh(series, 1.0)
display.ColorArrayName = [None, ""]
take("time", view, display)

# What cannot be drawn.
view, display = fresh(simple.Sphere())
facts["no vectors"] = complaint(lambda: macro.draw(str(folder / "none.png")))
fresh(simple.Line())
facts["no surface"] = complaint(lambda: macro.draw(str(folder / "none.png")))
view, display = fresh(source)
program = os.environ.pop("AEOLIC")
path, os.environ["PATH"] = os.environ["PATH"], "/nowhere"
facts["no program"] = complaint(lambda: macro.draw(str(folder / "none.png")))
os.environ["AEOLIC"], os.environ["PATH"] = program, path
facts["no folder"] = complaint(lambda: macro.draw(str(folder / "none" / "none.png")))
simple.SetActiveSource(None)
facts["no source"] = complaint(lambda: macro.draw(str(folder / "none.png")))

(folder / "facts.json").write_text(json.dumps(facts))
