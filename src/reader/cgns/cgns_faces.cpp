#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "reader/cgns/cgns_zone.h"

namespace aeolic {
namespace {

using Wholes = std::vector<std::int64_t>;

/// "IFaceCenter" says the direction; else it is the one in which the range has a single layer.
std::optional<std::size_t> directionOf(const CgnsBoundary& boundary, const Wholes& first, const Wholes& last,
                                       const Wholes& lengths)
{
    const std::size_t indices = first.size();
    for (std::size_t d = 0; d < indices; ++d)
        if (boundary.location == std::string(1, "IJK"[d]) + "FaceCenter") return d;
    std::optional<std::size_t> direction;
    for (std::size_t d = 0; d < indices; ++d)
        if (first[d] == last[d] && (!direction || first[d] == 1 || first[d] == lengths[d])) direction = d;
    return direction;
}

}  // namespace

CellFaces CgnsZone::facesOf(const CgnsBoundary& boundary, bool behind) const
{
    points();  // So that its number of points is what the file has.
    if (structured_) return structuredFaces(boundary);
    return boundary.byPoints ? facesBetween(boundary, behind) : listedFaces(boundary, behind);
}

/// A part of a layer of a structured zone; the faces are seen from outside where its indices are right-handed.
CellFaces CgnsZone::structuredFaces(const CgnsBoundary& boundary) const
{
    const std::size_t indices = vertices_.size();
    CellFaces found;
    if (!boundary.range || boundary.numbers.size() != 2 * indices || indices != 3 || dimension_ < 3) {
        if (dimension_ < 3) return found;  // Of a sheet it is a line.
        boundary.node->fail("it lists its points or faces one by one", "a PointRange, in a structured zone");
    }
    Wholes first(indices), last(indices);
    for (std::size_t d = 0; d < indices; ++d) {
        first[d] = std::min(boundary.numbers[d], boundary.numbers[indices + d]);
        last[d] = std::max(boundary.numbers[d], boundary.numbers[indices + d]);
    }
    const auto direction = directionOf(boundary, first, last, vertices_);
    if (!direction) boundary.node->fail("its range is not one layer", "one direction in which it begins where it ends");
    for (std::size_t d = 0; d < indices; ++d) {
        if (!boundary.byPoints && d != *direction) ++last[d];  // Of faces: the points behind the last.
        if (first[d] < 1 || last[d] > vertices_[d])
            boundary.node->fail(fmt::format("its range goes from {} to {}", first[d], last[d]),
                                fmt::format("1 to {} in the direction {}", vertices_[d], "ijk"[d]));
    }
    const std::size_t d = *direction, a = (d + 1) % 3, b = (d + 2) % 3;
    const std::int64_t steps[] = {1, vertices_[0], vertices_[0] * vertices_[1]};
    const Wholes cells = cellLengths();
    const std::int64_t cellSteps[] = {1, cells[0], cells[0] * cells[1]};
    const bool atEnd = first[d] == vertices_[d];
    // The first direction that runs fastest comes first, so that faces are in the order of their numbers.
    const std::size_t fast = std::min(a, b), slow = std::max(a, b);
    for (std::int64_t j = first[slow]; j < last[slow]; ++j)
        for (std::int64_t i = first[fast]; i < last[fast]; ++i) {
            const std::int64_t at = (first[d] - 1) * steps[d] + (i - 1) * steps[fast] + (j - 1) * steps[slow];
            std::int64_t corners[] = {at, at + steps[a], at + steps[a] + steps[b], at + steps[b]};
            if (!atEnd) std::swap(corners[1], corners[3]);
            found.faces.add(corners);
            found.cells.push_back(std::min(first[d] - 1, cells[d] - 1) * cellSteps[d] + (i - 1) * cellSteps[fast] +
                                  (j - 1) * cellSteps[slow]);
        }
    return found;
}

/// The numbers that a boundary lists, or the range that it says.
Wholes CgnsZone::numbersOf(const CgnsBoundary& boundary, std::int64_t most) const
{
    const Wholes& numbers = boundary.numbers;
    for (const std::int64_t number : numbers)
        if (number < 1 || number > most)
            boundary.node->fail(fmt::format("it has the number {}", number), fmt::format("1 to {}", most));
    if (!boundary.range) return numbers;
    if (numbers.size() != 2 || numbers[1] < numbers[0])
        boundary.node->fail(fmt::format("its range is {}", fmt::join(numbers, " to ")), "first and last");
    Wholes all(std::size_t(numbers[1] - numbers[0]) + 1);
    std::iota(all.begin(), all.end(), numbers[0]);
    return all;
}

CellFaces CgnsZone::listedFaces(const CgnsBoundary& boundary, bool behind) const
{
    std::map<const CgnsSection*, FaceList> known;
    std::map<const CgnsSection*, Wholes> parents;
    CellFaces found;
    for (const CgnsSection& section : sections_) {
        const auto lowest = std::ranges::min_element(boundary.numbers);
        const auto highest = std::ranges::max_element(boundary.numbers);
        if (section.dimension != 2 || section.count() == 0 || *lowest > section.last || *highest < section.first)
            continue;
        known.emplace(&section, facesByNumber(section));
        if (behind) parents.emplace(&section, parentsOf(section));
    }
    bool all = true;
    for (const std::int64_t number : numbersOf(boundary, lastElement())) {
        const auto place = std::ranges::find_if(
            known, [&](const auto& each) { return number >= each.first->first && number <= each.first->last; });
        const std::size_t at = place == known.end() ? 0 : std::size_t(number - place->first->first);
        if (place == known.end() || at >= place->second.count() || place->second.face(at).empty())
            boundary.node->fail(fmt::format("the element {} is not a face", number), "faces of the zone");
        found.faces.add(place->second.face(at));
        const Wholes none, &own = behind ? parents[place->first] : none;
        found.cells.push_back(at < own.size() ? own[at] : -1);
        all = all && found.cells.back() >= 0;
    }
    if (behind && !all) {
        const Wholes cells = cellsBehind(found.faces, this->cells());
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (found.cells[i] < 0) found.cells[i] = cells[i];
    }
    return found;
}

/// All faces that lie between the points: elements of the zone or, where there are none, its outer sides.
CellFaces CgnsZone::facesBetween(const CgnsBoundary& boundary, bool behind) const
{
    std::vector<bool> chosen(points()->size());
    for (const std::int64_t number : numbersOf(boundary, std::int64_t(chosen.size())))
        chosen[std::size_t(number - 1)] = true;
    CellFaces found;
    for (const CgnsSection& section : sections_) {
        if (section.dimension != 2 || dimension_ != 3 || section.count() == 0) continue;
        const FaceList all = facesByNumber(section);
        for (std::size_t i = 0; i < all.count(); ++i) {
            const auto face = all.face(i);
            if (!face.empty() &&
                std::ranges::all_of(face, [&](std::int64_t corner) { return chosen[std::size_t(corner)]; }))
                found.faces.add(face);
        }
    }
    if (found.faces.count() == 0) return dimension_ == 3 ? outerFacesOf(cells(), chosen) : found;
    found.cells = behind ? cellsBehind(found.faces, cells()) : Wholes(found.faces.count(), -1);
    return found;
}

/// The cell that each face of a section belongs to, as the file says it; empty where it does not, or where cells are
/// not counted as they are numbered.
Wholes CgnsZone::parentsOf(const CgnsSection& section) const
{
    const auto node = section.node->child("ParentElements");
    const auto old = section.node->child("ParentData");
    Wholes parents = node ? node->wholes() : old ? old->wholes() : Wholes();
    if (parents.size() < section.count()) return {};
    parents.resize(section.count());
    for (std::int64_t& parent : parents) parent = cellByNumber(parent);
    return parents;
}

/// A cell's place among cells(), by its number; -1 where there is none.
std::int64_t CgnsZone::cellByNumber(std::int64_t number) const
{
    std::int64_t before = 0, found = -1;
    for (const bool polyhedra : {false, true})  // The order of cells().
        for (const CgnsSection& section : sections_) {
            if (section.dimension != dimension_ || (section.type == kCgnsNface) != polyhedra) continue;
            if (section.type == kCgnsMixed) return -1;  // Some of its elements may be no cells.
            if (number >= section.first && number <= section.last) found = before + number - section.first;
            before += std::int64_t(section.count());
        }
    return found;
}

}  // namespace aeolic
