#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reader/netcdf/netcdf_file.h"

namespace aeolic {

/// The names of a grid's dimensions, slowest first: y and x, or z, y and x.
using GridAxes = std::vector<std::string>;

/// A variable whose values stand on a grid.
struct GridVariable {
    std::string name;
    GridAxes axes;
    std::vector<std::size_t> at;      ///< Which of the variable's dimensions each of the axes is.
    std::optional<std::size_t> time;  ///< Which of the variable's dimensions is time; nothing: none is.
};

/// A vector whose components are variables.
struct GridVector {
    std::string name;
    std::vector<std::size_t> of;  ///< Two or three variables.
    /// The dimensions of the points that the components are brought to. Each component may stand half a cell beside
    /// these points, along its own direction (the C grid of Arakawa and Lamb 1977).
    GridAxes axes;
    bool isEastward = false;  ///< The components are those towards east and north, not along the grid's lines.
    bool isFlow = false;      ///< Its unit is that of a flow or a stress.
};

/// What a netCDF file holds on grids of two or three dimensions, by the CF conventions (version 1.11, chapters 4 and
/// 5), and by what models do that do not keep to them.
struct GridVariables {
    std::vector<GridVariable> variables;
    std::vector<GridVector> vectors;
    std::map<std::string, std::vector<double>> times;  ///< Of each dimension of time.
};

/// Throws InputError where nothing stands on a grid.
GridVariables gridVariablesOf(const NetcdfFile& file);

/// What a variable's attributes say that it tells of.
enum class CoordinateKind { none, x, y, z, time };
inline constexpr CoordinateKind kKindOfAxis[] = {CoordinateKind::x, CoordinateKind::y, CoordinateKind::z};
CoordinateKind coordinateKindOf(const NetcdfFile& file, const std::string& variable);

/// Whether its unit is a degree.
bool isInDegrees(const NetcdfFile& file, const std::string& variable);

/// The longitudes or x, and the latitudes or y, of a curvilinear grid's points: variables over its y and x, perhaps
/// also over time. Those that the attribute `coordinates` of the variable `of` names go first, then those over
/// dimensions of the same names, then those over dimensions of the same lengths.
struct PlaneNames {
    std::string x, y;
    bool areNamed = false;  ///< By that attribute.
};
std::optional<PlaneNames> planeOf(const NetcdfFile& file, const GridAxes& axes, const std::string& of);

/// The coordinates along a dimension: of the dimension's name, or the only variable of this kind over it.
std::optional<std::string> coordinateOf(const NetcdfFile& file, const std::string& dimension, CoordinateKind kind);

/// Whether values on `from` can be brought to the points of `to`: each dimension is the same, or up to one longer or
/// shorter.
bool isStaggered(const NetcdfFile& file, const GridAxes& from, const GridAxes& to);

}  // namespace aeolic
