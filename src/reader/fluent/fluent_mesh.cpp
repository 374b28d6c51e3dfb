#include "reader/fluent/fluent_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "reader/parts/cell_of_faces.h"

namespace aeolic {
namespace {

std::string describe(const FluentRange& range)
{
    return fmt::format("the zone {}, from {} to {}", range.zone, range.first, range.last);
}

}  // namespace

FluentMesh::FluentMesh(const std::string& path) : text_(path)
{
    for (const FluentSection& section : text_.sections()) readHead(section);
    for (auto* ranges : {&nodes_, &cells_, &faces_}) {
        std::sort(ranges->begin(), ranges->end(),
                  [](const FluentRange& a, const FluentRange& b) { return a.first < b.first; });
        std::int64_t next = 1;
        for (const FluentRange& range : *ranges) {
            if (range.first != next)
                text_.fail(fmt::format("its numbers begin at {} in {}", range.first, describe(range)),
                           fmt::format("{}, behind the others", next));
            next = range.last + 1;
        }
    }
    if (nodes_.empty() || faces_.empty()) text_.fail("it has no nodes or no faces", "a mesh");
}

FluentRange FluentMesh::rangeOf(const FluentSection& section, const std::vector<std::string>& words) const
{
    if (words.size() < 4)
        text_.fail(fmt::format("a section {} has {} words in its head", section.index, words.size()),
                   "zone, first, last, kind");
    FluentRange range{int(text_.number(words[0], 16)), text_.number(words[1], 16), text_.number(words[2], 16),
                      int(text_.number(words[3], 16))};
    if (words.size() > 4) range.shape = int(text_.number(words[4], 16));
    range.section = &section;
    if (range.zone != 0 && (range.first < 1 || range.last < range.first - 1))
        text_.fail(fmt::format("it has {}", describe(range)), "a run of numbers from 1");
    return range;
}

void FluentMesh::readHead(const FluentSection& section)
{
    const std::vector<std::string> words = section.index == 0 ? std::vector<std::string>() : text_.words(section);
    if (section.index == 2 && !words.empty()) {
        dimensions_ = int(text_.number(words[0], 10));
        if (dimensions_ != 2 && dimensions_ != 3)
            text_.fail(fmt::format("it has {} dimensions", dimensions_), "2 or 3");
    }
    if (section.index == 4 && !words.empty()) swapped_ = fluentIsSwapped(words);
    if (section.index == 10 || section.index == 12 || section.index == 13) {
        const FluentRange range = rangeOf(section, words);
        if (range.zone == 0 || range.last < range.first) return;  // It only says how many there are.
        (section.index == 10 ? nodes_ : section.index == 12 ? cells_ : faces_).push_back(range);
    }
    if ((section.index == 39 || section.index == 45) && words.size() > 2)
        zones_[int(text_.number(words[0], 10))] = {words[2], words[1]};
    for (const int refined : {58, 59, 61, 62, 63})
        if (section.index == refined)
            text_.fail(fmt::format("its grid is refined with hanging nodes, or not conformal (section {})", refined),
                       "cells that share whole faces (in Fluent, convert them to polyhedra or export CGNS)");
}

PartPoints FluentMesh::points() const
{
    if (points_) return points_;
    auto points = std::make_shared<std::vector<glm::dvec3>>();
    for (const FluentRange& range : nodes_) {
        FluentNumbers numbers(text_, *range.section, swapped_);
        for (std::size_t i = 0; i < range.count(); ++i) {
            glm::dvec3 point(0);
            for (int c = 0; c < dimensions_; ++c) point[c] = numbers.real();
            points->push_back(point);
        }
    }
    points_ = std::move(points);
    return points_;
}

void FluentMesh::read(const FluentRange& range, FluentFaces& to) const
{
    const auto pointCount = std::int64_t(points()->size());
    const std::int64_t cellCount = cells_.empty() ? 0 : cells_.back().last;
    FluentNumbers numbers(text_, *range.section, swapped_);
    const bool counted = range.shape == 0 || range.shape == 5;
    const auto size = std::size_t(counted ? 0 : range.shape);
    if (size > 4 || (size > 0 && size < 2))
        text_.fail(fmt::format("its faces are of the kind {}", range.shape), "2 to 5, or 0");
    std::vector<std::int64_t> corners;
    for (std::size_t i = 0; i < range.count(); ++i) {
        std::int64_t own = counted ? numbers.whole() : std::int64_t(size);
        if (own < 2 || own > pointCount)
            text_.fail(fmt::format("a face has {} corners in {}", own, describe(range)), "2 or more");
        corners.clear();
        for (; own > 0; --own) {
            const std::int64_t corner = numbers.whole();
            if (corner < 1 || corner > pointCount)
                text_.fail(fmt::format("a face has the corner {} in {}", corner, describe(range)),
                           fmt::format("1 to {}", pointCount));
            corners.push_back(corner - 1);
        }
        const std::int64_t first = numbers.whole(), second = numbers.whole();
        if (first < 0 || first > cellCount || second < 0 || second > cellCount)
            text_.fail(fmt::format("a face is between the cells {} and {} in {}", first, second, describe(range)),
                       fmt::format("0 to {}", cellCount));
        // The corners turn around a thumb that points to the first cell.
        std::reverse(corners.begin(), corners.end());
        to.faces.add(corners);
        to.inside.push_back(first);
        to.outside.push_back(second);
    }
}

void FluentMesh::readAllFaces() const
{
    if (!ofCells_.empty() || cells_.empty()) return;
    for (const FluentRange& range : faces_) read(range, all_);
    ofCells_.resize(std::size_t(cells_.back().last));
    for (std::size_t i = 0; i < all_.inside.size(); ++i) {
        if (all_.inside[i] > 0) ofCells_[std::size_t(all_.inside[i] - 1)].push_back(std::int64_t(i) + 1);
        if (all_.outside[i] > 0) ofCells_[std::size_t(all_.outside[i] - 1)].push_back(-std::int64_t(i) - 1);
    }
}

std::vector<PartCells> FluentMesh::cellsOf(int zone) const
{
    readAllFaces();
    std::vector<PartCells> cells;
    const auto add = [&](CellShape shape) -> PartCells& {
        if (cells.empty() || cells.back().shape != shape) cells.push_back({shape, 0, {}, {}, {}});
        ++cells.back().count;
        return cells.back();
    };
    for (const FluentRange& range : cells_) {
        if (range.zone != zone) continue;
        for (std::int64_t number = range.first; number <= range.last; ++number) {
            std::vector<std::vector<std::int64_t>> turned;
            std::vector<std::span<const std::int64_t>> faces;
            const auto& own = ofCells_[std::size_t(number - 1)];
            turned.reserve(own.size());
            for (const std::int64_t face : own) {
                const auto corners = all_.faces.face(std::size_t(std::abs(face) - 1));
                turned.emplace_back(corners.begin(), corners.end());
                if (face < 0) std::reverse(turned.back().begin(), turned.back().end());
                faces.emplace_back(turned.back());
            }
            if (dimensions_ == 2) {
                const auto polygon = polygonOfEdges(faces);
                if (polygon.empty())
                    text_.fail(fmt::format("the cell {} has {} edges that close no polygon", number, faces.size()),
                               "edges that close");
                PartCells& to = add(CellShape::polygon);
                to.sizes.push_back(std::int64_t(polygon.size()));
                to.corners.insert(to.corners.end(), polygon.begin(), polygon.end());
            } else if (const auto simple = cellOfFaces(faces)) {
                PartCells& to = add(simple->shape);
                to.corners.insert(to.corners.end(), simple->corners.begin(), simple->corners.end());
            } else {
                if (faces.size() < 4)
                    text_.fail(fmt::format("the cell {} has {} faces", number, faces.size()), "four or more");
                PartCells& to = add(CellShape::polyhedron);
                to.sizes.push_back(std::int64_t(faces.size()));
                for (const auto& face : faces) {
                    if (face.size() < 3)
                        text_.fail(fmt::format("the cell {} has a face of {} corners", number, face.size()),
                                   "three or more");
                    to.ofFaces.push_back(std::int64_t(face.size()));
                    to.corners.insert(to.corners.end(), face.begin(), face.end());
                }
            }
        }
    }
    return cells;
}

}  // namespace aeolic
