#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "reader/ensight/ensight_stream.h"
#include "reader/parts/part_source.h"

namespace aeolic {

/// The elements of one kind in a part.
struct EnSightSection {
    std::string name;  ///< "hexa8", "g_hexa8"; "block" where the part is one.
    std::size_t count = 0;
    bool kept = false;  ///< A face or a cell. Ghosts, lines and points are only counted.
    PartCells cells;    ///< Of a section that is kept, without the points between corners.
};

struct EnSightPart {
    int number = 0;
    std::string name;  ///< Its description; "part N" where that is empty.
    bool block = false;
    std::array<std::vector<float>, 3> points;  ///< x, y and z of each.
    std::vector<EnSightSection> sections;

    std::size_t pointCount() const { return points[0].size(); }
    std::size_t cells() const;  ///< In the sections that are kept.
    bool fillsSpace() const;    ///< Some of them are no faces.
};

/// All parts of a geometry file, and how numbers stand in the case's files. Throws InputError, which begins with the
/// file's name, for a file that is cut off, unknown or absurd: coordinates beyond 1e30, corners beyond the points.
struct EnSightGeometry {
    EnSightFormat format;
    std::vector<EnSightPart> parts;
    std::map<int, std::size_t> indices;  ///< Of the parts, by their numbers.
};
EnSightGeometry readEnSightGeometry(const EnSightPlace& place);

/// The points and cells of a part behind "block …", as the line `kind` says.
void readEnSightBlock(EnSightStream& stream, const std::string& kind, EnSightPart& part);

/// Coordinates, each finite and within 1e30.
std::vector<float> readEnSightCoordinates(EnSightStream& stream, std::size_t count);

}  // namespace aeolic
