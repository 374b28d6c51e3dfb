#pragma once

#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <string>
#include <vector>

namespace aeolic {

/// The dimension of cells of a VTK type: 0 for vertices and for cells of no type, 3 for cells that fill space.
int dimensionOfCells(int vtkType);

/// The highest dimension of a data set's cells; 0 where it has none.
int dimensionOfCells(vtkDataSet& data);

/// How many cells count for the mean at each point. Where cells of several dimensions meet at a point, only those of
/// the highest do: faces and lines beside a volume are its boundary, whose values are often zero.
struct CountingCells {
    std::vector<std::uint8_t> dimension;  ///< [points] Of those cells; 0 where there are none.
    std::vector<std::uint32_t> count;     ///< [points]
};
CountingCells countingCells(vtkDataSet& data);

/// Means at the points of the values of the cells that count there, with the name of `cellValues`. Hidden cells count
/// nowhere. Throws InputError that begins with `path`.
vtkSmartPointer<vtkFloatArray> meansAtPoints(vtkDataSet& data, vtkFloatArray& cellValues, const std::string& path);

}  // namespace aeolic
