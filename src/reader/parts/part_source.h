#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "data/part_info.h"
#include "data/piece_run.h"
#include "description/file_kinds.h"
#include "reader/binary/numbers.h"

namespace aeolic {

/// What a cell is once the points between its corners are left out. Corners are counted as in EnSight, CGNS and Exodus:
/// of a wedge and a hexahedron around the lower face, seen from within, then around the upper one.
enum class CellShape { triangle, quad, polygon, tetra, pyramid, wedge, hexahedron, polyhedron };

constexpr bool fillsSpace(CellShape shape)
{
    return shape >= CellShape::tetra;
}

/// How many corners a cell of the shape has; 0 where each has its own number.
constexpr std::size_t cornersOf(CellShape shape)
{
    constexpr std::size_t corners[] = {3, 4, 0, 4, 5, 6, 8, 0};
    return corners[std::size_t(shape)];
}

/// Cells of one shape, one after the other.
struct PartCells {
    CellShape shape = CellShape::triangle;
    std::size_t count = 0;
    std::vector<std::int64_t> corners;  ///< From 0. Of a polyhedron those of its faces.
    std::vector<std::int64_t> sizes;    ///< [count] Corners of each polygon, faces of each polyhedron; else empty.
    std::vector<std::int64_t> ofFaces;  ///< Corners of each face of each polyhedron; else empty.
};

/// Whether there are as many corners as the cells need, and sizes and faces where they need them.
bool sizesFit(const PartCells& cells);

/// The cells between points in rows, as many in each direction as `lengths` says, the first direction fastest:
/// hexahedra or, where points go in two directions alone, quads. None where they go in fewer.
PartCells orderedCells(std::span<const std::int64_t> lengths);

/// Where a part has no value.
inline constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

using PartPoints = std::shared_ptr<const std::vector<glm::dvec3>>;
using PartValues = std::shared_ptr<const std::vector<float>>;

/// One array of the values of its components, each of which may be empty; null where all are. Vectors have three
/// components, of which a third that is not there is 0. Where numbers differ, calls `fail` with what was found and what
/// was expected, which throws.
PartValues joinedValues(const std::vector<std::vector<float>>& components, const std::vector<std::string>& names,
                        const std::function<void(const std::string&, const std::string&)>& fail);

/// The data read of a part. It may have more points than its cells have corners.
struct PartMesh {
    PartPoints points;
    std::vector<PartCells> cells;
    std::vector<PartValues> values;          ///< Of each array that was asked for; null where the part has none.
    bool shared = false;                     ///< All such parts of the file have the same points.
    bool floatPoints = false;                ///< Coordinates are floats.
    std::vector<std::uint64_t> places = {};  ///< [cells] Where each stands among those of all pieces; empty: not told.

    std::size_t cellCount() const;
};

struct PartArray {
    std::string name;
    bool onPoints = true;
    int components = 1;  ///< 1 or 3.
    NumberType type = NumberType::float32;
};

/// A file of several parts, at one of its times: first asked what it holds, then read part by part. Every failure is an
/// InputError that begins with the file's name.
class PartSource {
public:
    virtual ~PartSource() = default;

    const std::vector<PartArray>& arrays() const { return arrays_; }  ///< Each name once on points and once on cells.
    const std::vector<double>& times() const { return times_; }       ///< Increasing; empty where nothing changes.
    virtual const std::vector<PartInfo>& parts() { return parts_; }

    /// `wanted`: indices of arrays(). Of each that the part has, one tuple for each of its points or cells.
    virtual PartMesh read(std::size_t part, const std::vector<std::size_t>& wanted) = 0;

    /// Several parts, all faces or all cells, as one, with the points that they have in common; nothing: each is read
    /// by itself.
    virtual std::optional<PartMesh> readTogether(const std::vector<std::size_t>&, const std::vector<std::size_t>&)
    {
        return std::nullopt;
    }

    /// The vectors that are drawn of these parts where none are named; empty: the file does not say.
    virtual std::string usualVectors(const std::vector<std::size_t>&) const { return {}; }

    /// Throws InputError where one of these arrays is there at other times alone.
    virtual void requireAtTime(const std::vector<std::string>&) {}

    /// Leaves out all but these pieces, perhaps none, and tells places. Only of a file that lies in pieces.
    virtual void keepPieces(const PieceRun&) {}

    /// The cells will be looked up as they are. Otherwise polyhedra may come cut into simpler cells.
    virtual void keepPolyhedra() {}

protected:
    std::vector<PartArray> arrays_;
    std::vector<double> times_;
    std::vector<PartInfo> parts_;
};

/// The numbers of the parts that are meant, increasing: those that `wanted` names (chooseParts()). Where it names none:
/// for a surface the usual ones that are faces, for a field all that fill space; all where there are none of these.
/// Throws InputError, which begins with `where`.
std::vector<std::size_t> chosenParts(const std::vector<PartInfo>& parts, const std::vector<std::string>& wanted,
                                     FileUse use, const std::string& where);

}  // namespace aeolic
