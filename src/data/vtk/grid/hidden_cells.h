#pragma once

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <string>

namespace aeolic {

/// What the data's vtkGhostType hides: cells, or points and so the cells around them.
struct HiddenParts {
    bool cells = false, points = false;
};
HiddenParts hiddenPartsOf(vtkDataSet& data);

/// The shown cells of a structured data set that hides some, as an unstructured grid with all points and the values
/// of those cells. Throws InputError that begins with `path` where memory is missing.
vtkSmartPointer<vtkUnstructuredGrid> shownCells(vtkDataSet& data, const std::string& path);

/// Makes nothing of a grid's cells that are hidden, touch a hidden point, or are there once more in finer ones. VTK's
/// filters see that for structured grids alone; the hidden cells of these it may have made cells of no type, with
/// corners. `marked`: has the flags, for the same cells and points.
void leaveOutHidden(vtkUnstructuredGrid& grid, vtkDataSet& marked);

}  // namespace aeolic
