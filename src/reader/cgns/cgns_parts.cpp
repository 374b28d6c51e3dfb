#include "reader/parts/open_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "aeolic/error.h"
#include "data/vector_names.h"
#include "reader/cgns/cgns_zone.h"

namespace aeolic {
namespace {

std::vector<double> timesOf(const std::vector<CgnsNodePtr>& bases)
{
    for (const CgnsNodePtr& base : bases) {
        const auto iterative = base->childOf("BaseIterativeData_t");
        for (const char* name : {"TimeValues", "IterationValues"}) {
            const auto values = iterative ? iterative->child(name) : nullptr;
            if (!values || !values->hasValue()) continue;
            std::vector<double> times = values->read<double>();
            for (std::size_t i = 0; i < times.size(); ++i)
                if (!std::isfinite(times[i]) || (i > 0 && times[i] <= times[i - 1]))
                    values->fail(fmt::format("its time {} is {}", i, times[i]), "times that are finite and increase");
            return times;
        }
    }
    return {};
}

class CgnsParts : public PartSource {
public:
    CgnsParts(const std::string& path, std::optional<double> time)
    {
        const CgnsNodePtr root = openCgnsTree(path);
        const std::vector<CgnsNodePtr> bases = root->children("CGNSBase_t");
        times_ = timesOf(bases);
        std::size_t step = 0;
        for (std::size_t i = 0; time && i < times_.size(); ++i)
            if (times_[i] <= *time) step = i;
        bool flat = true;
        for (const CgnsNodePtr& base : bases) {
            const std::vector<std::int64_t> dimensions = base->wholes();
            flat = flat && dimensions.size() > 1 && dimensions[1] == 2;
            for (const CgnsNodePtr& zone : base->children("Zone_t")) {
                zones_.push_back(std::make_unique<CgnsZone>(base, zone, step));
                addParts(*zones_.back(), bases.size() > 1 ? base->name() + "/" : "");
            }
        }
        if (zones_.empty()) throw InputError(path, "it has no zones", "a CGNS file with a grid");
        chooseUsual();
        addArrays(flat);
    }

    PartMesh read(std::size_t number, const std::vector<std::size_t>& wanted) override
    {
        const Place& place = places_[number];
        const CgnsZone& zone = *place.zone;
        const bool onCells = std::ranges::any_of(wanted, [&](std::size_t array) { return !arrays_[array].onPoints; });
        PartMesh mesh;
        CellFaces faces;
        if (place.boundary) {
            faces = zone.facesOf(*place.boundary, onCells);
            mesh.cells.push_back(faces.faces.asPolygons());
        } else if (place.section) {
            mesh.cells.push_back(zone.facesOf(*place.section));
            if (onCells) faces = zone.facesOf(asBoundary(*place.section), true);
        } else {
            mesh.cells = zone.cells();
        }
        mesh.points = zone.points();
        for (const std::size_t array : wanted) mesh.values.push_back(values(place, faces, array));
        return mesh;
    }

private:
    struct Place {
        const CgnsZone* zone;
        const CgnsBoundary* boundary = nullptr;
        const CgnsSection* section = nullptr;
    };

    void addParts(const CgnsZone& zone, const std::string& base)
    {
        if (zone.dimension() < 2) return;
        const bool volume = zone.dimension() == 3;
        parts_.push_back({base + zone.name(), volume ? "volume" : "faces", zone.families(), zone.dimension()});
        places_.push_back({&zone});
        if (!volume) return;
        std::set<std::string> names;
        for (const CgnsBoundary& boundary : zone.boundaries()) {
            if (zone.structured() && !boundary.range) continue;
            std::vector<std::string> groups = boundary.groups;
            if (std::ranges::find(groups, boundary.type) == groups.end()) groups.push_back(boundary.type);
            names.insert(boundary.node->name());
            parts_.push_back({base + zone.name() + "/" + boundary.node->name(), boundary.type, groups, 2, true, true});
            places_.push_back({&zone, &boundary});
        }
        const bool bounded = !names.empty();
        for (const CgnsSection& section : zone.sections()) {
            if (section.dimension != 2 || section.count() == 0 || !names.insert(section.node->name()).second) continue;
            parts_.push_back({base + zone.name() + "/" + section.node->name(), "faces", {}, 2, !bounded, true});
            places_.push_back({&zone, nullptr, &section});
        }
    }

    /// Where there are walls, only they are drawn.
    void chooseUsual()
    {
        const auto isWall = [](const PartInfo& part) { return part.type.starts_with("BCWall"); };  // BCWallViscous …
        if (std::ranges::none_of(parts_, isWall)) return;
        for (PartInfo& part : parts_)
            if (part.derived) part.usual = isWall(part);
    }

    void addArrays(bool flat)
    {
        for (const bool onPoints : {true, false}) {
            std::vector<std::string> names;
            std::vector<NumberType> types;
            const auto add = [&](const CgnsField& field) {
                if (field.onPoints != onPoints || std::ranges::find(names, field.name) != names.end()) return;
                names.push_back(field.name);
                types.push_back(*field.node->type());
            };
            for (const auto& zone : zones_) {
                for (const CgnsField& field : zone->fields()) add(field);
                for (const CgnsRegion& region : zone->regions())
                    for (const CgnsField& field : region.fields) add(field);
            }
            for (const NamedComponents& each : joinComponents(names, flat)) {
                arrays_.push_back({each.name, onPoints, each.of.size() > 1 ? 3 : 1, types[each.of.front()]});
                std::vector<std::string>& of = of_.emplace_back();
                for (const std::size_t component : each.of) of.push_back(names[component]);
            }
        }
    }

    /// Null where the part has none of the components.
    PartValues values(const Place& place, const CellFaces& faces, std::size_t array) const
    {
        std::vector<std::vector<float>> components;
        for (const std::string& name : of_[array])
            components.push_back(component(place, faces, name, arrays_[array].onPoints));
        return joinedValues(components, of_[array],
                            [&](const auto& found, const auto& expected) { place.zone->fail(found, expected); });
    }

    std::vector<float> component(const Place& place, const CellFaces& faces, const std::string& name,
                                 bool onPoints) const
    {
        const CgnsZone& zone = *place.zone;
        const auto find = [&](const std::vector<CgnsField>& fields) {
            return std::ranges::find_if(
                fields, [&](const CgnsField& field) { return field.name == name && field.onPoints == onPoints; });
        };
        const auto own = find(zone.fields());
        std::vector<float> values;
        if (own != zone.fields().end()) values = zone.read(*own);
        if (onPoints || (!place.boundary && !place.section)) return values;
        std::vector<float> onFaces;
        if (!values.empty())
            for (const std::int64_t cell : faces.cells)
                onFaces.push_back(std::size_t(cell) < values.size() ? values[std::size_t(cell)] : kMissing);
        for (const CgnsRegion& region : zone.regions())
            if (const auto field = find(region.fields); field != region.fields.end())
                takeRegion(place, region, zone.readList(*field), faces, onFaces);
        return onFaces;
    }

    /// Values on the faces themselves go before values in the cells behind them.
    static void takeRegion(const Place& place, const CgnsRegion& region, const std::vector<float>& values,
                           const CellFaces& faces, std::vector<float>& onFaces)
    {
        if (!region.place) {
            if (!place.boundary || place.boundary->node->name() != region.boundary) return;
            if (values.size() != faces.cells.size())
                place.boundary->node->fail(fmt::format("there are {} values on its faces", values.size()),
                                           fmt::format("{}", faces.cells.size()));
            onFaces = values;
            return;
        }
        const CgnsBoundary own = place.boundary ? *place.boundary : asBoundary(*place.section);
        if (own.byPoints) return;
        const std::int64_t last = place.zone->lastElement();
        const auto at = place.zone->numbersOf(*region.place, last), wanted = place.zone->numbersOf(own, last);
        if (at.size() != values.size())
            region.place->node->fail(fmt::format("it has {} values", values.size()), fmt::format("{}", at.size()));
        std::unordered_map<std::int64_t, float> byNumber;
        for (std::size_t i = 0; i < at.size(); ++i) byNumber.emplace(at[i], values[i]);
        onFaces.resize(faces.cells.size(), kMissing);
        for (std::size_t i = 0; i < wanted.size() && i < onFaces.size(); ++i)
            if (const auto found = byNumber.find(wanted[i]); found != byNumber.end()) onFaces[i] = found->second;
    }

    static CgnsBoundary asBoundary(const CgnsSection& section)
    {
        return {section.node, "", {}, false, "FaceCenter", true, {section.first, section.last}};
    }

    std::vector<std::unique_ptr<CgnsZone>> zones_;
    std::vector<Place> places_;                 // Of each part.
    std::vector<std::vector<std::string>> of_;  // Of each array: the names of the fields that it is made of.
};

}  // namespace

std::unique_ptr<PartSource> openCgnsFile(const std::string& path, std::optional<double> time)
{
    return std::make_unique<CgnsParts>(path, time);
}

}  // namespace aeolic
