#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reader/cgns/cgns_elements.h"
#include "reader/cgns/cgns_node.h"
#include "reader/parts/cell_faces.h"

namespace aeolic {

/// A run of elements of a zone that is not structured.
struct CgnsSection {
    CgnsNodePtr node;
    std::int64_t type = 0, first = 1, last = 0;
    int dimension = 0;  ///< Of its elements; of the first where it is mixed.

    std::size_t count() const { return std::size_t(last - first + 1); }
};

/// Faces of a zone's edge, by what the file says of them.
struct CgnsBoundary {
    CgnsNodePtr node;
    std::string type;                   ///< "BCWall"
    std::vector<std::string> groups;    ///< Its families.
    bool byPoints = false;              ///< The numbers below are those of points, else of faces.
    std::string location;               ///< "FaceCenter", "IFaceCenter" …
    bool range = false;                 ///< They are first and last of a range.
    std::vector<std::int64_t> numbers;  ///< From 1; of a structured zone as many for each as it has indices.
};

/// Values of a zone: one component.
struct CgnsField {
    std::string name;
    CgnsNodePtr node;
    bool onPoints = true;
    std::vector<std::int64_t> rind;  ///< Layers around the zone, before and behind in each direction.
};

/// Values on some of a zone's faces alone.
struct CgnsRegion {
    std::string boundary;  ///< Whose faces they are on; empty where `place` says it.
    std::optional<CgnsBoundary> place;
    std::vector<CgnsField> fields;
};

/// A zone of a CGNS file at one moment: what it says of itself, and its grid.
class CgnsZone {
public:
    /// `step`: which of the file's times. Throws InputError, which begins with the file's name.
    CgnsZone(const CgnsNodePtr& base, const CgnsNodePtr& zone, std::size_t step);

    const std::string& name() const { return node_->name(); }
    bool structured() const { return structured_; }
    int dimension() const { return dimension_; }  ///< Of the cells that a solution in the cells is for.
    std::vector<std::string> families() const;

    const std::vector<CgnsSection>& sections() const { return sections_; }
    const std::vector<CgnsBoundary>& boundaries() const { return boundaries_; }
    const std::vector<CgnsField>& fields() const { return fields_; }
    const std::vector<CgnsRegion>& regions() const { return regions_; }

    PartPoints points() const;
    /// The zone's cells; those of a structured zone in the order of its indices.
    std::vector<PartCells> cells() const;
    PartCells facesOf(const CgnsSection& section) const;
    /// `behind`: the cells behind the faces are looked for, too.
    CellFaces facesOf(const CgnsBoundary& boundary, bool behind) const;

    /// The numbers that a boundary of a zone without structure lists, in its order, each from 1 to `most`.
    std::vector<std::int64_t> numbersOf(const CgnsBoundary& boundary, std::int64_t most) const;
    std::int64_t lastElement() const { return sections_.empty() ? 0 : sections_.back().last; }

    /// One value for each point or cell.
    std::vector<float> read(const CgnsField& field) const;
    std::vector<float> readList(const CgnsField& field) const;  ///< As many as there are.

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const
    {
        node_->fail(found, expected);
    }

private:
    void readSize(int cellDimension);
    void readSections();
    void readFields(std::size_t step);
    void readBoundaries(const CgnsNodePtr& base);
    CgnsBoundary placeOf(const CgnsNodePtr& node) const;
    std::vector<CgnsNodePtr> chosen(const std::string& label, const std::string& pointers, std::size_t step) const;

    std::size_t pointCount() const;
    std::vector<std::int64_t> cellLengths() const;
    std::vector<PartCells> cellsOf(const CgnsSection& section) const;
    std::vector<PartCells> polyhedra() const;
    FaceList facesByNumber(const CgnsSection& section) const;
    CellFaces structuredFaces(const CgnsBoundary& boundary) const;
    CellFaces listedFaces(const CgnsBoundary& boundary, bool behind) const;
    CellFaces facesBetween(const CgnsBoundary& boundary, bool behind) const;
    std::vector<std::int64_t> parentsOf(const CgnsSection& section) const;
    std::int64_t cellByNumber(std::int64_t number) const;
    template <class Number>
    std::vector<Number> readWithout(const CgnsNodePtr& node, const std::vector<std::int64_t>& rind,
                                    const std::vector<std::int64_t>& lengths) const;

    CgnsNodePtr node_;
    bool structured_ = false;
    int dimension_ = 3;
    std::vector<std::int64_t> vertices_;  // In each direction of a structured zone, else their number.
    std::vector<CgnsSection> sections_;   // By their first number.
    std::vector<CgnsBoundary> boundaries_;
    std::vector<CgnsField> fields_;
    std::vector<CgnsRegion> regions_;
    CgnsNodePtr coordinates_;
    mutable PartPoints points_;
};

}  // namespace aeolic
