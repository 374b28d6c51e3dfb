#include "reader/parts/open_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "aeolic/error.h"
#include "base/text.h"
#include "data/vector_names.h"
#include "reader/exodus/exodus_blocks.h"

namespace aeolic {
namespace {

/// What variables of one kind are called: "vals_elem_var3eb2".
struct Kind {
    const char *names, *values, *ofBlock;
};
constexpr Kind kNodal{"name_nod_var", "vals_nod_var", ""}, kElement{"name_elem_var", "vals_elem_var", "eb"},
    kSideSet{"name_sset_var", "vals_sset_var", "ss"};

bool movesPoints(const std::string& name)
{
    return lowerCase(name.substr(0, 4)) == "disp";
}

class ExodusParts : public PartSource {
public:
    ExodusParts(const std::string& path, std::optional<double> time) : file_(std::make_unique<const NetcdfFile>(path))
    {
        const auto dimensions = file_->dimension("num_dim");
        if (!dimensions || !file_->dimension("num_el_blk"))
            file_->fail("it is a netCDF file, but not one of Exodus", "an Exodus II file");
        if (*dimensions < 2 || *dimensions > 3) file_->fail(fmt::format("it has {} dimensions", *dimensions), "2 or 3");
        dimensions_ = *dimensions;
        readTimes();
        for (std::size_t i = 0; time && i < times_.size(); ++i)
            if (times_[i] <= *time) step_ = i;
        blocks_ = readExodusBlocks(*file_);
        sets_ = readExodusSideSets(*file_);
        for (const Kind* kind : {&kNodal, &kElement, &kSideSet})
            if (file_->has(kind->names)) names_[kind] = file_->texts(kind->names);
        addParts();
        if (times_.empty()) return;  // All values belong to a time.
        addArrays(true, names_[&kNodal]);
        std::vector<std::string> onCells = names_[&kElement];
        for (const std::string& name : names_[&kSideSet])
            if (std::ranges::find(onCells, name) == onCells.end()) onCells.push_back(name);
        addArrays(false, onCells);
    }

    PartMesh read(std::size_t number, const std::vector<std::size_t>& wanted) override
    {
        PartMesh mesh;
        mesh.shared = true;
        mesh.points = points();
        const Place& place = places_[number];
        ExodusSides sides;
        if (place.set) {
            sides = readExodusSides(*file_, *place.set, blocks_, mesh.points->size());
            mesh.cells.push_back(sides.faces.asPolygons());
        } else {
            mesh.cells.push_back(readExodusCells(*file_, *place.block, mesh.points->size()));
        }
        for (const std::size_t array : wanted) mesh.values.push_back(values(place, sides, array));
        return mesh;
    }

private:
    struct Place {
        const ExodusBlock* block = nullptr;
        const ExodusSideSet* set = nullptr;
    };

    void readTimes()
    {
        if (!file_->has("time_whole")) return;
        times_ = file_->read<double>("time_whole");
        for (std::size_t i = 0; i < times_.size(); ++i)
            if (!std::isfinite(times_[i]) || (i > 0 && times_[i] <= times_[i - 1]))
                file_->fail(fmt::format("its time {} is {}", i, times_[i]), "times that are finite and increase");
    }

    void addParts()
    {
        bool faces = false;
        for (const ExodusBlock& block : blocks_) {
            if (!block.shape) continue;
            const bool volume = fillsSpace(*block.shape);
            faces = faces || !volume;
            parts_.push_back({block.name, block.type, block.groups, volume ? 3 : 2});
            places_.push_back({&block});
        }
        if (dimensions_ == 2) return;  // There sides are lines.
        for (const ExodusSideSet& set : sets_) {
            parts_.push_back({set.name, "side set", set.groups, 2, !faces, true});
            places_.push_back({nullptr, &set});
        }
    }

    void addArrays(bool onPoints, const std::vector<std::string>& names)
    {
        for (const NamedComponents& each : joinComponents(names, dimensions_ == 2)) {
            std::vector<std::string> components;
            for (const std::size_t component : each.of) components.push_back(names[component]);
            arrays_.push_back({each.name, onPoints, each.of.size() > 1 ? 3 : 1, typeOf(onPoints, components.front())});
            components_.push_back(std::move(components));
        }
    }

    NumberType typeOf(bool onPoints, const std::string& name) const
    {
        std::vector<std::string> variables{onPoints ? variableOf(kNodal, name, 0) : ""};
        if (onPoints && !file_->has(variables[0])) variables[0] = kNodal.values;
        for (const ExodusBlock& block : blocks_) variables.push_back(variableOf(kElement, name, block.number));
        for (const ExodusSideSet& set : sets_) variables.push_back(variableOf(kSideSet, name, set.number));
        for (const std::string& variable : variables)
            if (!variable.empty() && file_->has(variable))
                if (const auto type = file_->type(variable)) return *type;
        return NumberType::float64;
    }

    /// Empty where the kind has no such name.
    std::string variableOf(const Kind& kind, const std::string& name, std::size_t number) const
    {
        const auto known = names_.find(&kind);
        if (known == names_.end()) return "";
        const auto at = std::ranges::find(known->second, name);
        if (at == known->second.end()) return "";
        const auto index = std::to_string(at - known->second.begin() + 1);
        return number == 0 ? kind.values + index : kind.values + index + kind.ofBlock + std::to_string(number);
    }

    /// One step of a variable; empty where the file has none.
    std::vector<float> readStep(const std::string& variable) const
    {
        if (variable.empty() || !file_->has(variable)) return {};
        const auto shape = file_->shape(variable);
        if (shape.size() != 2)
            file_->fail(fmt::format("'{}' has {} numbers", variable, fmt::join(shape, " x ")), "some for each step");
        if (shape[0] <= step_) return {};  // In netCDF-4 steps that were not written are not there.
        return file_->read<float>(variable, {{step_, 0}, {1, shape[1]}});
    }

    std::vector<float> nodalValues(const std::string& name) const
    {
        const std::string variable = variableOf(kNodal, name, 0);
        if (variable.empty() || file_->has(variable) || !file_->has(kNodal.values)) return readStep(variable);
        // An older form: one variable for all.
        const auto shape = file_->shape(kNodal.values);
        const auto index = std::stoull(variable.substr(std::string(kNodal.values).size())) - 1;
        if (shape.size() != 3 || shape[0] <= step_ || shape[1] <= index)
            file_->fail(fmt::format("'{}' has {} numbers", kNodal.values, fmt::join(shape, " x ")),
                        "steps of each name's values");
        return file_->read<float>(kNodal.values, {{step_, index, 0}, {1, 1, shape[2]}});
    }

    std::vector<double> axis(const std::string& name, std::uint64_t number) const
    {
        if (file_->has(name) || !file_->has("coord")) return file_->read<double>(name);
        // An older form: one variable for all.
        const auto shape = file_->shape("coord");
        if (shape.size() != 2)
            file_->fail(fmt::format("'coord' has {} dimensions", shape.size()), "2, of axes and nodes");
        return file_->read<double>("coord", {{number, 0}, {1, shape[1]}});
    }

    PartPoints points()
    {
        if (points_) return points_;
        const std::uint64_t count = file_->dimension("num_nodes").value_or(0);
        std::vector<std::vector<double>> axes;
        for (std::uint64_t c = 0; c < dimensions_; ++c) {
            const std::string name = std::string("coord") + "xyz"[c];
            axes.push_back(axis(name, c));
            if (axes.back().size() != count)
                file_->fail(fmt::format("'{}' has {} numbers", name, axes.back().size()),
                            fmt::format("{}, one for each node", count));
        }
        auto points = std::make_shared<std::vector<glm::dvec3>>(count);
        for (std::size_t i = 0; i < count; ++i)
            (*points)[i] = {axes[0][i], axes[1][i], dimensions_ > 2 ? axes[2][i] : 0};
        for (std::size_t k = 0; k < arrays_.size(); ++k) {
            if (!arrays_[k].onPoints || arrays_[k].components != 3 || !movesPoints(arrays_[k].name)) continue;
            const PartValues moved = values({}, {}, k);
            if (!moved || moved->size() != 3 * count)
                file_->fail(fmt::format("'{}' has {} values", arrays_[k].name, moved ? moved->size() / 3 : 0),
                            fmt::format("{}", count));
            for (std::size_t i = 0; i < count; ++i)
                (*points)[i] += glm::dvec3((*moved)[3 * i], (*moved)[3 * i + 1], (*moved)[3 * i + 2]);
            break;
        }
        points_ = std::move(points);
        return points_;
    }

    /// Values on the file's points are read once for all parts.
    PartValues values(const Place& place, const ExodusSides& sides, std::size_t array)
    {
        const bool onPoints = arrays_[array].onPoints;
        if (onPoints && nodal_.contains(array)) return nodal_[array];
        std::vector<std::vector<float>> components;
        for (const std::string& name : components_[array])
            components.push_back(onPoints    ? nodalValues(name)
                                 : place.set ? sideValues(name, *place.set, sides)
                                             : readStep(variableOf(kElement, name, place.block->number)));
        PartValues values = joinedValues(components, components_[array], [&](const auto& found, const auto& expected) {
            file_->fail(found, expected);
        });
        if (onPoints && values) nodal_[array] = values;
        return values;
    }

    /// The values on the sides themselves, else the values in the elements behind them.
    std::vector<float> sideValues(const std::string& name, const ExodusSideSet& set, const ExodusSides& sides) const
    {
        std::vector<float> found;
        const std::string own = variableOf(kSideSet, name, set.number);
        if (!own.empty() && file_->has(own)) {
            const std::vector<float> all = readStep(own);
            for (const std::size_t place : sides.places) {
                if (place >= all.size())
                    file_->fail(fmt::format("'{}' has {} values", own, all.size()), "one for each side");
                found.push_back(all[place]);
            }
            return found;
        }
        std::map<std::size_t, std::vector<float>> ofBlocks;
        bool any = false;
        for (std::size_t i = 0; i < sides.blocks.size(); ++i) {
            const std::size_t block = sides.blocks[i];
            if (!ofBlocks.contains(block))
                ofBlocks[block] = readStep(variableOf(kElement, name, blocks_[block].number));
            const std::vector<float>& all = ofBlocks[block];
            any = any || !all.empty();
            found.push_back(sides.cells[i] < all.size() ? all[sides.cells[i]] : kMissing);
        }
        return any ? found : std::vector<float>();
    }

    std::unique_ptr<const NetcdfFile> file_;
    std::uint64_t dimensions_ = 3;
    std::size_t step_ = 0;
    std::vector<ExodusBlock> blocks_;
    std::vector<ExodusSideSet> sets_;
    std::map<const Kind*, std::vector<std::string>> names_;
    std::vector<Place> places_;                         // Of each part.
    std::vector<std::vector<std::string>> components_;  // Of each array: the names of the variables that it is made of.
    PartPoints points_;
    std::map<std::size_t, PartValues> nodal_;
};

}  // namespace

std::unique_ptr<PartSource> openExodusFile(const std::string& path, std::optional<double> time)
{
    return std::make_unique<ExodusParts>(path, time);
}

}  // namespace aeolic
