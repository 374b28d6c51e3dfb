#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "aeolic/topology.h"

namespace aeolic {

/// Points and lines on a surface, on the way to a VTK XML polydata file. Cells are the single points first, and then
/// the lines, both in the order in which they came.
class SurfacePolydata {
public:
    void addPoint(const SurfaceValues& at);
    void addLine(const std::vector<SurfaceValues>& places);

    /// An array of the cells: values of the points and then of the lines.
    void addWhole(std::string name, std::vector<std::int64_t> values)
    {
        whole_.emplace_back(std::move(name), std::move(values));
    }
    void addNumbers(std::string name, std::vector<double> values)
    {
        numbers_.emplace_back(std::move(name), std::move(values));
    }

    /// Arrays of points are `vectors`, and the scalar by its name, where it has one.
    std::string text(const std::string& scalarName) const;

private:
    std::int64_t addPlace(const SurfaceValues& at);

    std::vector<double> positions_, vectors_, scalars_;
    std::vector<std::int64_t> verts_, vertEnds_, lines_, lineEnds_;
    std::vector<std::pair<std::string, std::vector<std::int64_t>>> whole_;
    std::vector<std::pair<std::string, std::vector<double>>> numbers_;
};

/// A text as a field of comma-separated values: in quotes where it has to be.
std::string csvText(const std::string& text);

/// The columns of a place in comma-separated values, with a comma in front of each: position, vector and, where it has
/// a name, the scalar. The names, and the values.
std::string csvPlaceNames(const std::string& scalarName);
std::string csvPlace(const SurfaceValues& at, bool hasScalar);

}  // namespace aeolic
