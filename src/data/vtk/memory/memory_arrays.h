#pragma once

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkIdTypeArray.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "aeolic/data.h"
#include "data/vtk/arrays.h"

namespace aeolic {

/// The caller's values as a VTK array: the caller's memory itself where tuples have no gaps, else a copy. Whoever may
/// write to it calls takeCopies() first. Throws InputError that begins with `where` for a view that makes no sense.
vtkSmartPointer<vtkDataArray> wrapped(const ArrayView& view, const std::string& where);

/// The same as indices of 64 bits; a copy where they are others. Throws InputError where they are no whole numbers.
vtkSmartPointer<vtkIdTypeArray> wrappedIndices(const ArrayView& view, const std::string& where);

/// The same as points. Throws InputError where they are no floats or doubles, three for each.
vtkSmartPointer<vtkPoints> wrappedPoints(const ArrayView& view, const std::string& where);

/// Cells that begin at `offsets` in `connectivity`; none where both are empty. Whether their points are there is for
/// requireSoundData() to say. Throws InputError, which begins with `name`, where offsets do not rise from 0 to the
/// number of indices; `cells` is what the message calls one of them.
vtkSmartPointer<vtkCellArray> wrappedCells(const ArrayView& offsets, const ArrayView& connectivity,
                                           const std::string& name, const char* cell);

/// Throws InputError where tuples have another number of components.
void requireComponents(const ArrayView& view, int expected, const std::string& where);

/// Adds arrays to the data set. Throws InputError where two have the same name or one has no name. Whether they have as
/// many tuples as there are points or cells is for requireSoundData() to say.
void addArrays(vtkDataSet& data, const std::vector<NamedArray>& arrays, bool onPoints, const std::string& where);

/// Replaces those of `arrays` whose memory is the caller's and that will be written to: where `always`, or where some
/// value will be masked. Returns whether the memory of the first is still the caller's.
bool takeCopies(vtkDataSet& data, const std::vector<ArrayInfo>& arrays, bool always);

}  // namespace aeolic
