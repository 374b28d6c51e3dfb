#include "reader/cgns/cgns_parts.h"

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

/// One array of the source: which of the file's fields it is made of, by their names.
struct Joined {
    bool onPoints;
    std::vector<std::string> of;
};

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

    const std::vector<PartArray>& arrays() const override { return arrays_; }
    std::vector<double> times() const override { return times_; }
    const std::vector<PartInfo>& parts() override { return parts_; }

    PartMesh read(std::size_t number, const std::vector<std::size_t>& wanted) override
    {
        const Place& place = places_[number];
        const CgnsZone& zone = *place.zone;
        const bool onCells =
            std::any_of(wanted.begin(), wanted.end(), [&](std::size_t array) { return !joined_[array].onPoints; });
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
        for (const std::size_t array : wanted) mesh.values.push_back(values(place, faces, joined_[array]));
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
            if (std::find(groups.begin(), groups.end(), boundary.type) == groups.end()) groups.push_back(boundary.type);
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
        const auto isWall = [&](const PartInfo& part) { return isCgnsWall(part.type); };
        if (std::none_of(parts_.begin(), parts_.end(), isWall)) return;
        for (PartInfo& part : parts_)
            if (part.derived) part.usual = isWall(part);
    }

    void addArrays(bool flat)
    {
        for (const bool onPoints : {true, false}) {
            std::vector<std::string> names;
            std::vector<NumberType> types;
            const auto add = [&](const CgnsField& field) {
                if (field.onPoints != onPoints || std::find(names.begin(), names.end(), field.name) != names.end())
                    return;
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
                Joined joined{onPoints, {}};
                for (const std::size_t component : each.of) joined.of.push_back(names[component]);
                joined_.push_back(std::move(joined));
            }
        }
    }

    /// Null where the part has none of the components.
    PartValues values(const Place& place, const CellFaces& faces, const Joined& joined) const
    {
        std::vector<std::vector<float>> components;
        bool any = false;
        for (const std::string& name : joined.of) {
            components.push_back(component(place, faces, name, joined.onPoints));
            any = any || !components.back().empty();
        }
        if (!any) return nullptr;
        const std::size_t width = components.size() > 1 ? 3 : 1;
        std::size_t count = 0;
        for (const auto& each : components) count = std::max(count, each.size());
        for (std::size_t c = 0; c < components.size(); ++c)
            if (!components[c].empty() && components[c].size() != count)
                place.zone->fail(fmt::format("'{}' has {} values", joined.of[c], components[c].size()),
                                 fmt::format("{}", count));
        auto values = std::make_shared<std::vector<float>>(count * width, components.size() == 2 ? 0.0F : kMissing);
        for (std::size_t c = 0; c < components.size(); ++c)
            for (std::size_t i = 0; i < count; ++i)
                (*values)[i * width + c] = i < components[c].size() ? components[c][i] : kMissing;
        return values;
    }

    std::vector<float> component(const Place& place, const CellFaces& faces, const std::string& name,
                                 bool onPoints) const
    {
        const CgnsZone& zone = *place.zone;
        const auto find = [&](const std::vector<CgnsField>& fields) {
            return std::find_if(fields.begin(), fields.end(), [&](const CgnsField& field) {
                return field.name == name && field.onPoints == onPoints;
            });
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

    std::vector<double> times_;
    std::vector<std::unique_ptr<CgnsZone>> zones_;
    std::vector<PartInfo> parts_;
    std::vector<Place> places_;  // Of each part.
    std::vector<PartArray> arrays_;
    std::vector<Joined> joined_;  // Of each array.
};

}  // namespace

std::unique_ptr<PartSource> openCgnsFile(const std::string& path, std::optional<double> time)
{
    return std::make_unique<CgnsParts>(path, time);
}

}  // namespace aeolic
