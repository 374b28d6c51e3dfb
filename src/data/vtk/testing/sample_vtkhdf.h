#pragma once

/// VTKHDF files for the tests, by the HDF5 library; compiled into the tests only.

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace aeolic::test {

struct SampleVtkHdf {
    bool newest = false;  ///< In HDF5's newest forms.
    bool packed = false;  ///< In chunks, by deflate.
    bool steps = false;   ///< Each of the data sets is a step, at the times 0, 0.5 …; else each is a piece of one.
    bool offsets = true;  ///< Of steps: arrays say where their own begin. Without, they go with points and cells.
    bool still = false;   ///< Of steps: points and cells are those of the first, and written once.
};

/// Writes image data, unstructured grids or polygons, all of one kind and with the same arrays.
void writeVtkHdf(const std::string& path, const std::vector<vtkSmartPointer<vtkDataSet>>& sets,
                 const SampleVtkHdf& sample = {});

/// Writes them as blocks named "block0", "block1" …; the assembly has them in "even" and "odd" of "all".
void writeVtkHdfBlocks(const std::string& path, const std::vector<vtkSmartPointer<vtkDataSet>>& sets);

}  // namespace aeolic::test
