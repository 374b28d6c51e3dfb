#include "reader/fluent/fluent_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

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

void FluentMesh::read(const FluentRange& range, MeshFaces& to) const
{
    const auto pointCount = std::int64_t(points()->size());
    const std::int64_t cellCount = cells_.empty() ? 0 : cells_.back().last;
    if (std::uint64_t(std::max(pointCount, cellCount)) > MeshFaces::kMost)
        text_.fail(fmt::format("it has {} points and {} cells", pointCount, cellCount), "at most 2^31");
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
        std::ranges::reverse(corners);
        to.corners.insert(to.corners.end(), corners.begin(), corners.end());
        to.ends.push_back(to.corners.size());
        to.inside.push_back(std::uint32_t(first));
        to.outside.push_back(std::uint32_t(second));
    }
}

std::vector<PartCells> FluentMesh::cellsOf(int zone) const
{
    if (!all_ && !cells_.empty()) {
        MeshFaces faces;
        for (const FluentRange& range : faces_) read(range, faces);
        all_.emplace(std::move(faces), std::size_t(cells_.back().last), FirstCorner::last, text_.path());
    }
    std::vector<PartCells> cells;
    for (const FluentRange& range : cells_) {
        if (range.zone != zone) continue;
        std::vector<PartCells> some =
            dimensions_ == 2 ? all_->polygons(range.first, range.last) : all_->cells(range.first, range.last);
        std::move(some.begin(), some.end(), std::back_inserter(cells));
    }
    return cells;
}

}  // namespace aeolic
