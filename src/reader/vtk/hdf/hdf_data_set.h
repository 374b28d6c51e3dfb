#pragma once

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "data/vtk/arrays.h"
#include "reader/hdf5/hdf5_file.h"

namespace aeolic {

/// One data set of a VTKHDF file: a group that says its type. "The VTKHDF file format", versions 1 and 2. Throws
/// InputError, which begins with the file's name.
class HdfDataSet {
public:
    /// Looks at names, shapes and times alone.
    explicit HdfDataSet(const Hdf5Object& group);

    const std::string& type() const { return type_; }  ///< "ImageData", "UnstructuredGrid" or "PolyData".
    const std::vector<ArrayInfo>& arrays() const { return arrays_; }
    const std::vector<double>& times() const { return times_; }

    /// Pieces of the file are one. Values are floats, but those of masks.
    vtkSmartPointer<vtkDataSet> read(std::size_t step, const std::vector<ArrayInfo>& kept) const;

private:
    struct Step;  // Where a step's numbers begin.
    struct Cells;
    struct Place {
        std::uint64_t point, cell;
    };

    void findArrays(bool onPoints);
    Step placeOf(std::size_t step, std::size_t topologies) const;
    vtkSmartPointer<vtkDataSet> readImage(std::size_t step, const std::vector<ArrayInfo>& kept) const;
    vtkSmartPointer<vtkDataSet> readGrid(std::size_t step, const std::vector<ArrayInfo>& kept) const;
    vtkSmartPointer<vtkDataSet> readPolygons(std::size_t step, const std::vector<ArrayInfo>& kept) const;
    std::vector<std::int64_t> pointsOf(const Step& place) const;
    Cells cellsOf(const Hdf5Object& group, const Step& place, std::size_t topology,
                  const std::vector<std::int64_t>& points) const;
    void addArrays(vtkDataSet& to, std::size_t step, const std::vector<ArrayInfo>& kept, const Place& begin) const;
    std::uint64_t arrayBegin(const ArrayInfo& array, std::size_t step) const;

    Hdf5Object group_;
    std::optional<Hdf5Object> steps_;
    std::string type_;
    std::vector<ArrayInfo> arrays_;
    std::vector<double> times_;
};

}  // namespace aeolic
