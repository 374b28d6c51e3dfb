#include "reader/cgns/cgns_zone.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace aeolic {
namespace {

std::string textOf(const CgnsNodePtr& node, const std::string& label)
{
    const auto found = node->childOf(label);
    return found ? found->text() : "";
}

std::vector<std::string> familiesOf(const CgnsNodePtr& node)
{
    std::vector<std::string> names;
    for (const char* label : {"FamilyName_t", "AdditionalFamilyName_t"})
        for (const CgnsNodePtr& family : node->children(label))
            if (!family->text().empty()) names.push_back(family->text());
    return names;
}

std::vector<std::int64_t> rindOf(const CgnsNodePtr& node)
{
    const auto rind = node->childOf("Rind_t");
    return rind ? rind->wholes() : std::vector<std::int64_t>();
}

/// Numbers of a node: the first of each name stands.
void addFields(const CgnsNodePtr& solution, bool onPoints, std::vector<CgnsField>& fields)
{
    const std::vector<std::int64_t> rind = rindOf(solution);
    for (const CgnsNodePtr& array : solution->children("DataArray_t"))
        if (array->type() && std::ranges::none_of(fields, [&](const CgnsField& field) {
                return field.name == array->name() && field.onPoints == onPoints;
            }))
            fields.push_back({array->name(), array, onPoints, rind});
}

}  // namespace

CgnsZone::CgnsZone(const CgnsNodePtr& base, const CgnsNodePtr& zone, std::size_t step) : node_(zone)
{
    const std::vector<std::int64_t> dimensions = base->wholes();
    if (dimensions.empty() || dimensions[0] < 1 || dimensions[0] > 3)
        base->fail("it does not say how many dimensions its cells have", "1 to 3");
    structured_ = textOf(zone, "ZoneType_t") != "Unstructured";
    readSize(int(dimensions[0]));
    if (!structured_) readSections();
    for (const CgnsNodePtr& grid : chosen("GridCoordinates_t", "GridCoordinates", step))
        if (!coordinates_ || grid->name() == "GridCoordinates") coordinates_ = grid;
    readFields(step);
    readBoundaries(base);
}

std::vector<std::string> CgnsZone::families() const
{
    return familiesOf(node_);
}

void CgnsZone::readSize(int cellDimension)
{
    const std::vector<std::int64_t> sizes = node_->wholes();
    const std::size_t indices = structured_ ? std::size_t(cellDimension) : 1;
    if (sizes.size() < 3 * indices)
        fail(fmt::format("its size has {} numbers", sizes.size()), fmt::format("{}", 3 * indices));
    vertices_.assign(sizes.begin(), sizes.begin() + std::ptrdiff_t(indices));
    dimension_ = 0;
    for (const std::int64_t length : vertices_) {
        if (length < (structured_ ? 1 : 0))
            fail(fmt::format("it has {} points", fmt::join(vertices_, " x ")), "some in each direction");
        dimension_ += length > 1;
    }
}

void CgnsZone::readSections()
{
    for (const CgnsNodePtr& node : node_->children("Elements_t")) {
        const std::vector<std::int64_t> kind = node->wholes();
        const auto range = node->child("ElementRange");
        const std::vector<std::int64_t> ends = range ? range->wholes() : std::vector<std::int64_t>();
        if (kind.empty() || ends.size() != 2 || ends[0] < 1 || ends[1] < ends[0] - 1)
            node->fail("it does not say which elements it has", "a kind, and a range of numbers from 1");
        CgnsSection section{node, kind[0], ends[0], ends[1]};
        const CgnsElement* element = findCgnsElement(section.type);
        if (section.type == kCgnsMixed && section.count() > 0) {
            const auto corners = node->child("ElementConnectivity");
            if (corners && corners->shape().size() == 1 && corners->shape()[0] > 0)
                element = findCgnsElement(corners->read<std::int64_t>({0}, {1}).front());
        }
        section.dimension = section.type == kCgnsNgon    ? 2
                            : section.type == kCgnsNface ? 3
                            : element                    ? element->dimension
                                                         : 0;
        if (!element && section.type != kCgnsNgon && section.type != kCgnsNface && section.count() > 0)
            node->fail(fmt::format("its elements are of the unknown kind {}", kind[0]), "a kind of CGNS 4");
        sections_.push_back(std::move(section));
    }
    std::ranges::stable_sort(sections_, [](const CgnsSection& a, const CgnsSection& b) { return a.first < b.first; });
    dimension_ = 0;
    for (std::size_t i = 0; i < sections_.size(); ++i) {
        if (i > 0 && sections_[i].first <= sections_[i - 1].last)
            sections_[i].node->fail(fmt::format("its elements begin at {}", sections_[i].first),
                                    fmt::format("more than {}, where others end", sections_[i - 1].last));
        if (sections_[i].count() > 0) dimension_ = std::max(dimension_, sections_[i].dimension);
    }
}

/// Nodes of a label: those that the zone names for the step, or the ends of whose names it names; all where it names
/// none.
std::vector<CgnsNodePtr> CgnsZone::chosen(const std::string& label, const std::string& pointers, std::size_t step) const
{
    const auto iterative = node_->childOf("ZoneIterativeData_t");
    std::vector<CgnsNodePtr> named;
    bool names = false;
    for (const CgnsNodePtr& array : iterative ? iterative->children("DataArray_t") : std::vector<CgnsNodePtr>()) {
        if (!array->name().starts_with(pointers) || !array->name().ends_with("Pointers")) continue;
        const std::vector<std::string> steps = array->texts();
        names = true;
        if (step >= steps.size()) array->fail(fmt::format("it names {} nodes", steps.size()), "one for each time");
        if (const auto node = node_->child(steps[step])) {
            named.push_back(node);
            continue;
        }
        // Some programs name only the end that the nodes on points and in cells have in common.
        const std::size_t before = named.size();
        for (const CgnsNodePtr& node : node_->children(label))
            if (!steps[step].empty() && node->name().ends_with(steps[step])) named.push_back(node);
        if (named.size() == before && steps[step] != "Null")
            array->fail(fmt::format("it names '{}'", steps[step]), "a node of the zone");
    }
    return names ? named : node_->children(label);
}

void CgnsZone::readFields(std::size_t step)
{
    for (const CgnsNodePtr& solution : chosen("FlowSolution_t", "FlowSolution", step)) {
        const std::string location = textOf(solution, "GridLocation_t");
        CgnsBoundary place = placeOf(solution);
        const bool partial = !place.numbers.empty();
        if (!partial && (location.empty() || location == "Vertex")) addFields(solution, true, fields_);
        if (!partial && location == "CellCenter") addFields(solution, false, fields_);
        if (partial && location == "FaceCenter" && !structured_) {
            CgnsRegion region{"", std::move(place), {}};
            addFields(solution, false, region.fields);
            regions_.push_back(std::move(region));
        }
    }
    for (const CgnsNodePtr& node : chosen("ZoneSubRegion_t", "ZoneSubRegion", step)) {
        const std::string location = textOf(node, "GridLocation_t");
        const auto name = node->child("BCRegionName");
        CgnsRegion region{name ? name->text() : "", std::nullopt, {}};
        if (region.boundary.empty()) region.place = placeOf(node);
        if (region.boundary.empty() && (structured_ || region.place->numbers.empty() || region.place->byPoints))
            continue;
        if (location.empty() || location == "Vertex") continue;
        addFields(node, false, region.fields);
        regions_.push_back(std::move(region));
    }
}

/// Which points or faces a node says that it is about; no numbers where it says none.
CgnsBoundary CgnsZone::placeOf(const CgnsNodePtr& node) const
{
    CgnsBoundary place{node, "", {}, true, textOf(node, "GridLocation_t"), false, {}};
    place.byPoints = place.location.empty() || place.location == "Vertex";
    for (const char* name : {"PointRange", "PointList", "ElementRange", "ElementList"}) {
        const auto numbers = node->child(name);
        if (!numbers || !numbers->hasValue()) continue;
        place.numbers = numbers->wholes();
        place.range = std::string(name).ends_with("Range");
        if (std::string(name).starts_with("Element")) {
            place.byPoints = false;
            place.location = "FaceCenter";
        }
        break;
    }
    return place;
}

void CgnsZone::readBoundaries(const CgnsNodePtr& base)
{
    std::set<std::string> names;
    for (const CgnsNodePtr& all : node_->children("ZoneBC_t"))
        for (const CgnsNodePtr& node : all->children("BC_t")) {
            CgnsBoundary boundary = placeOf(node);
            boundary.type = node->text();
            boundary.groups = familiesOf(node);
            for (const std::string& family : boundary.groups) {
                const auto known = base->child(family);
                const std::string type = known ? textOf(known, "FamilyBC_t") : "";
                if (boundary.type == "FamilySpecified" && !type.empty()) boundary.type = type;
            }
            if (!boundary.numbers.empty() && names.insert(node->name()).second)
                boundaries_.push_back(std::move(boundary));
        }
}

}  // namespace aeolic
