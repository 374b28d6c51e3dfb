#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

/// Data that are sound and ugly: seeds from which damage finds more than from tidy ones.
namespace aeolic::test {

/// Polygons that are bent inwards, or without an area, or there twice; strips, lines and vertices. With `tooShort` also
/// those that are none, which VTK's XML writer does not take.
vtkSmartPointer<vtkPolyData> oddPolygons(bool tooShort);

/// A cell of every kind that VTK knows the shape of, and of some whose corners say nothing.
vtkSmartPointer<vtkUnstructuredGrid> oddCells();

}  // namespace aeolic::test
