#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reader/fluent/fluent_sections.h"
#include "reader/parts/cells_of_faces.h"

namespace aeolic {

/// Cells or faces of a zone, which are numbered one after the other from 1.
struct FluentRange {
    int zone = 0;
    std::int64_t first = 1, last = 0;
    int kind = 0;   ///< Of faces: 2 between cells, 3 a wall …
    int shape = 0;  ///< Of faces: 2 lines, 3 triangles, 4 quadrilaterals; 0 and 5: each says it.
    const FluentSection* section = nullptr;

    std::size_t count() const { return std::size_t(last - first + 1); }
};

/// A zone as it is called.
struct FluentZone {
    std::string name, type;  ///< "wing", "wall"
};

/// The mesh in a Fluent file (.msh, .cas). Only the sections' heads are read before faces are asked for.
class FluentMesh {
public:
    explicit FluentMesh(const std::string& path);

    const FluentText& text() const { return text_; }
    int dimensions() const { return dimensions_; }
    bool swapped() const { return swapped_; }
    const std::map<int, FluentZone>& zones() const { return zones_; }
    const std::vector<FluentRange>& cells() const { return cells_; }
    const std::vector<FluentRange>& faces() const { return faces_; }

    PartPoints points() const;

    /// Adds the faces of a range.
    void read(const FluentRange& faces, MeshFaces& to) const;

    /// Cells of a zone, in the order of their numbers; polygons of a flat mesh.
    std::vector<PartCells> cellsOf(int zone) const;

private:
    void readHead(const FluentSection& section);
    FluentRange rangeOf(const FluentSection& section, const std::vector<std::string>& words) const;

    FluentText text_;
    int dimensions_ = 3;
    bool swapped_ = false;
    std::map<int, FluentZone> zones_;
    std::vector<FluentRange> nodes_, cells_, faces_;
    mutable PartPoints points_;
    mutable std::optional<CellsOfFaces> all_;  // Once cells were asked for.
};

}  // namespace aeolic
