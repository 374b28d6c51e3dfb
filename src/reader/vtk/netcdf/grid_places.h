#pragma once

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <vector>

#include "reader/netcdf/netcdf_file.h"
#include "reader/vtk/netcdf/grid_variables.h"

namespace aeolic {

/// Where the points of a grid are.
struct GridPlaces {
    std::array<std::vector<double>, 3> lines;  ///< Along x, y and z, each increasing; z has one where there are two.
    std::array<bool, 3> turned{};              ///< The file has them the other way round.
    std::vector<double> x, y;                  ///< [rows * columns] Of a curvilinear grid; else empty.
    bool inDegrees = false;                    ///< x and y are longitude and latitude.

    std::size_t columns() const { return lines[0].size(); }
    std::size_t rows() const { return lines[1].size(); }
    std::size_t layers() const { return lines[2].size(); }
    std::size_t count() const { return columns() * rows() * layers(); }
    bool isCurvilinear() const { return !x.empty(); }
    double xAt(std::size_t row, std::size_t column) const;
    double yAt(std::size_t row, std::size_t column) const;
};

/// The places of the points of a variable's grid. Throws InputError where coordinates are not finite, or neither grow
/// nor shrink.
GridPlaces placesOf(const NetcdfFile& file, const GridAxes& axes, const std::string& variable);

/// A grid without values: uniform, rectilinear or curvilinear. Cells of a curvilinear one that have a corner without a
/// place, or that lie across the map's edge, are hidden.
vtkSmartPointer<vtkDataSet> dataSetOf(const GridPlaces& places);

}  // namespace aeolic
