"""Times vtkSurfaceLICMapper on one surface: an orbit of FRAMES views, 360/FRAMES degrees apart, every frame a full LIC.

Arguments: FILE.vtp VECTORS SIZE STEPS FRAMES OUT.png. Step length 1, enhanced LIC off, vectors normalized, z up, a camera
that fits the surface with zoom 1.5. Writes the first view to OUT.png. Prints one JSON line: median milliseconds per frame,
covered share of the picture, and the first view's camera, so that another renderer can take the same views.
"""
import json
import sys
import time

import numpy as np
from vtkmodules.vtkRenderingLICOpenGL2 import vtkSurfaceLICMapper
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  registers the OpenGL classes
from vtkmodules.util.numpy_support import vtk_to_numpy

path, vectors, size, steps, frames, out = sys.argv[1:7]
size, steps, frames = int(size), int(steps), int(frames)

reader = vtkXMLPolyDataReader()
reader.SetFileName(path)
normals = vtkPolyDataNormals()
normals.SetInputConnection(reader.GetOutputPort())
normals.SplittingOff()
normals.Update()
surface = normals.GetOutput()
surface.GetPointData().SetActiveVectors(vectors)

mapper = vtkSurfaceLICMapper()
mapper.SetInputData(surface)
mapper.SetInputArrayToProcess(0, 0, 0, 0, vectors)
mapper.SetScalarVisibility(0)
lic = mapper.GetLICInterface()
lic.SetNumberOfSteps(steps)
lic.SetStepSize(1.0)
lic.SetEnhancedLIC(0)
lic.SetNormalizeVectors(1)

actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddActor(actor)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetMultiSamples(0)
window.SetSize(size, size)
window.AddRenderer(renderer)
camera = renderer.GetActiveCamera()
camera.SetPosition(-1.0, -1.0, 0.7)
camera.SetFocalPoint(0.0, 0.0, 0.0)
camera.SetViewUp(0.0, 0.0, 1.0)
renderer.ResetCamera()
camera.Zoom(1.5)
first_view = {"position": camera.GetPosition(), "focal": camera.GetFocalPoint(), "up": [0, 0, 1], "fov": camera.GetViewAngle()}
window.Render()  # Shaders compile here, outside the timing.

seconds, covered = [], []
grab = vtkWindowToImageFilter()
grab.SetInput(window)
grab.ReadFrontBufferOff()
for _ in range(frames):
    camera.Azimuth(360.0 / frames)  # The last of them is the first view again.
    start = time.perf_counter()
    window.Render()
    window.WaitForCompletion()
    seconds.append(time.perf_counter() - start)
    grab.Modified()
    grab.Update()
    rgb = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(size, size, -1)
    covered.append(float((rgb != rgb[-1, 0]).any(axis=2).mean()))

writer = vtkPNGWriter()
writer.SetFileName(out)
writer.SetInputConnection(grab.GetOutputPort())
writer.Write()

opengl = [line for line in window.ReportCapabilities().split("\n") if "renderer string" in line.lower()]
print(json.dumps({
    "peer": "vtkSurfaceLICMapper",
    "opengl": opengl[0].split(":", 1)[1].strip() if opengl else "",
    "median_total_ms": round(1000 * float(np.median(seconds)), 1),
    "covered": round(float(np.mean(covered)), 4),
    "camera": first_view,
}))
