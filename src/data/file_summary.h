#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/bounds.h"
#include "base/byte_message.h"

namespace aeolic {

struct ArraySummary {
    std::string name, association, type;  ///< "U", "points", "float"
    int components = 1;
    std::optional<std::array<double, 2>> range;  ///< Finite values; lengths where there are several components.
    std::int64_t masked = 0, nonFinite = 0;      ///< Tuples.
    bool active = false;                         ///< The file's own choice of vectors.
    std::vector<double> times = {};              ///< At which a case has it; empty: at all.
};

template <PerhapsConst<ArraySummary> Array, class Visit>
void withMembers(Array& array, const Visit& visit)
{
    visit(array.name, array.association, array.type, array.components, array.range, array.masked, array.nonFinite,
          array.active, array.times);
}

/// One of a file's parts that --surface can name.
struct PartSummary {
    std::string name, type;  ///< "terrain", "wall"
    std::vector<std::string> groups;
    std::int64_t polygons = 0;  ///< Or cells.
    bool fillsSpace = false, usual = true;
    Bounds boundsWorld = {};                ///< Empty where it is not known.
    std::vector<std::string> vectors = {};  ///< Its own in which something flows; of a file at rest all.
    std::optional<int> sideAcross = {};     ///< Of a case in two dimensions: the axis that this side lies across.
    /// A side of such a case, or of one around an axis.
    bool isSide() const { return type == "empty" || type == "wedge"; }
};

template <PerhapsConst<PartSummary> Part, class Visit>
void withMembers(Part& part, const Visit& visit)
{
    visit(part.name, part.type, part.groups, part.polygons, part.fillsSpace, part.usual, part.boundsWorld, part.vectors,
          part.sideAcross);
}

/// What a file holds.
struct FileSummary {
    std::string kind;  ///< "image data", "polygons" …
    bool isSurface = false;
    int dimension = 0;  ///< The largest of its cells': below 2 there is nothing to draw. Not of a case.
    std::int64_t points = 0, cells = 0, blocks = 0;
    std::optional<std::array<int, 3>> dims;                          ///< Only structured data has them.
    std::optional<std::array<double, 3>> spacingWorld, originWorld;  ///< Only image data has them.
    Bounds boundsWorld;                                              ///< Empty if no point is finite.
    std::vector<double> timeSteps;
    std::vector<PartSummary> parts;      ///< Empty: it is not of several parts.
    bool isOfFaces = false;              ///< Cells were not read: bounds, arrays, points, parts are those of faces.
    bool namesFiles = false;             ///< Its values stand in other files, so that its own size says nothing.
    bool isVolume = false;               ///< Some parts of a surface are a field, too.
    std::vector<ArraySummary> arrays;    ///< Without masks.
    std::optional<std::string> vectors;  ///< The array drawn by default, if there is one.
    std::string firstVectors;            ///< The first array that could be drawn, or empty.
};

template <PerhapsConst<FileSummary> Summary, class Visit>
void withMembers(Summary& summary, const Visit& visit)
{
    visit(summary.kind, summary.isSurface, summary.dimension, summary.points, summary.cells, summary.blocks,
          summary.dims, summary.spacingWorld, summary.originWorld, summary.boundsWorld, summary.timeSteps,
          summary.parts, summary.isOfFaces, summary.namesFiles, summary.isVolume, summary.arrays, summary.vectors,
          summary.firstVectors);
}

}  // namespace aeolic
