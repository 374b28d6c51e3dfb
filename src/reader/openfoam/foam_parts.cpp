#include "reader/openfoam/foam_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "aeolic/error.h"
#include "reader/openfoam/foam_surface.h"
#include "reader/openfoam/foam_volume.h"

namespace aeolic {
namespace {

std::vector<PartInfo> partsOf(const std::vector<FoamPart>& patches)
{
    const auto isWall = [](const FoamPart& patch) { return patch.type == "wall"; };
    const bool walls = std::ranges::any_of(patches, isWall);
    std::vector<PartInfo> parts;
    for (const FoamPart& patch : patches) {
        PartInfo part{patch.name(), patch.type, patch.groups, 2};
        part.usual = !walls || isWall(patch);
        part.derived = true;
        parts.push_back(std::move(part));
    }
    return parts;
}

/// The items of a list that stand at the places `numbers`.
template <class Item>
std::vector<Item> numbered(const std::vector<Item>& all, const std::vector<std::size_t>& numbers)
{
    std::vector<Item> some;
    some.reserve(numbers.size());
    for (const std::size_t number : numbers) some.push_back(all[number]);
    return some;
}

class FoamParts : public PartSource {
public:
    FoamParts(const std::string& path, FileUse use, std::optional<double> time) : foam_(findFoamCase(path))
    {
        times_ = foam_.times;
        time_ = time.value_or(foam_.firstTime());
        run_ = {0, int(foam_.folders.size())};
        if (!times_.empty()) fields_ = foamFields(foam_, {time_});
        for (const FoamField& field : fields_) arrays_.push_back({field.name, false, field.components});
        if (use == FileUse::field) {
            for (const std::string& region : foam_.regions)
                parts_.push_back(region.empty() ? PartInfo{"internalMesh", "volume", {}}
                                                : PartInfo{region + "/internalMesh", "volume", {region}});
        } else {
            patches_ = foamPatches(foam_, time_);
            parts_ = partsOf(patches_);
        }
    }

    PartMesh read(std::size_t part, const std::vector<std::size_t>& wanted) override
    {
        return *readTogether({part}, wanted);
    }

    std::optional<PartMesh> readTogether(const std::vector<std::size_t>& parts,
                                         const std::vector<std::size_t>& wanted) override
    {
        const std::vector<FoamField> fields = numbered(fields_, wanted);
        if (patches_.empty())
            return readFoamVolume(foam_, numbered(foam_.regions, parts), time_, fields, run_, polyhedra_);
        const std::vector<FoamPart> patches = numbered(patches_, parts);
        if (std::ranges::all_of(patches, [](const FoamPart& patch) { return patch.faces == 0; }))
            throw InputError(foam_.name, fmt::format("patch '{}' has no faces", patches.front().name()),
                             "a patch with faces");
        PartMesh mesh = readFoamPatches(foam_, patches, time_, fields, run_);
        if (!inPieces_) mesh.places.clear();
        return mesh;
    }

    std::string usualVectors(const std::vector<std::size_t>& parts) const override
    {
        std::vector<FoamField> fields;  // Of the regions of these parts.
        const auto has = [&](const FoamField& field) {
            return foam_.regions.size() == 1 || std::ranges::any_of(parts, [&](std::size_t part) {
                       const std::string& region = patches_.empty() ? foam_.regions[part] : patches_[part].region;
                       return foamHasField(foam_, region, time_, field);
                   });
        };
        std::ranges::copy_if(fields_, std::back_inserter(fields), has);
        const bool walls = !patches_.empty() &&
                           std::ranges::all_of(parts, [&](std::size_t part) { return patches_[part].type == "wall"; });
        return usualFoamVectors(fields, walls);
    }

    void requireAtTime(const std::vector<std::string>& arrays) override
    {
        for (const std::string& array : arrays) requireFoamFieldAt(foam_, time_, array);
    }

    void keepPieces(const PieceRun& run) override
    {
        run_ = run;
        inPieces_ = true;
    }

    void keepPolyhedra() override { polyhedra_ = true; }

private:
    FoamCase foam_;
    double time_ = 0;
    PieceRun run_;
    bool inPieces_ = false, polyhedra_ = false;
    std::vector<FoamField> fields_;
    std::vector<FoamPart> patches_;  // None of a field.
};

}  // namespace

std::unique_ptr<PartSource> openFoamCase(const std::string& path, FileUse use, std::optional<double> time)
{
    return std::make_unique<FoamParts>(path, use, time);
}

std::vector<std::uint64_t> foamPieces(const std::string& path, FileUse use, const std::vector<std::string>& parts)
{
    const FoamCase foam = findFoamCase(path);
    std::vector<std::uint64_t> pieces(foam.folders.size(), 1);
    if (use == FileUse::field || !foam.decomposed() || foam.regions.size() == 1) return pieces;
    const std::vector<FoamPart> patches = foamPatches(foam, foam.firstTime());
    const std::vector<std::size_t> chosen = chosenParts(partsOf(patches), parts, use, path);
    const bool oneRegion = std::ranges::all_of(
        chosen, [&](std::size_t part) { return patches[part].region == patches[chosen.front()].region; });
    return oneRegion ? pieces : std::vector<std::uint64_t>{1};
}

}  // namespace aeolic
