#include "reader/openfoam/foam_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "aeolic/error.h"
#include "base/same_place.h"
#include "data/part_choice.h"
#include "reader/openfoam/foam_mesh.h"
#include "reader/openfoam/foam_stream.h"

namespace aeolic {
namespace {

/// One folder's share of a region's patches.
struct Share {
    FoamFaces faces;
    std::vector<std::vector<float>> values;  ///< [fields]
    std::vector<std::int64_t> order;  ///< [faces] Their places among all faces of the whole mesh; empty: not told.
};

Share readShare(const FoamCase& foam, const std::string& folder, const std::string& region, double time,
                const std::vector<FoamPart>& parts, const std::vector<FoamField>& fields, bool told)
{
    const std::string boundary = foamMeshFile(folder, region, time, "boundary");
    const std::vector<FoamPatch> all = readFoamBoundary(boundary);
    std::vector<FoamPatch> patches;
    for (const FoamPatch& patch : all)
        if (std::any_of(parts.begin(), parts.end(),
                        [&](const FoamPart& p) { return p.region == region && p.patch == patch.name; }))
            patches.push_back(patch);
    Share share;
    share.faces = readFoamFaces(folder, region, time, patches);
    for (const FoamPatch& patch : all)
        if (patch.firstFace + patch.faces > share.faces.inMesh)
            throw InputError(foamFileOf(boundary),
                             fmt::format("patch '{}' has {} faces from {} on, and the mesh has {} faces", patch.name,
                                         patch.faces, patch.firstFace, share.faces.inMesh),
                             "patches within the mesh");
    for (const FoamField& field : fields)
        share.values.push_back(readFoamValues(foam, folder, region, time, field, patches, share.faces));
    if (!told) return share;
    const std::string addressing = foamMeshFile(folder, region, time, "faceProcAddressing");
    share.order = readFoamLabels(addressing, share.faces.numbers);
    for (std::int64_t& place : share.order) {  // Counted from 1; negative where the face is turned round.
        if (place == 0 || place == std::numeric_limits<std::int64_t>::min())
            throw InputError(foamFileOf(addressing), fmt::format("a face has number {}", place), "1 and more");
        place = place < 0 ? -place : place;
    }
    return share;
}

/// Appends the shares of one region, face by face.
class Joiner {
public:
    Joiner(FoamSurface& surface, const std::vector<FoamField>& fields, bool merges)
        : surface_(surface), fields_(fields), merges_(merges)
    {
    }

    void add(const Share& share, std::vector<std::uint32_t>& ids, std::size_t face)
    {
        for (std::size_t k = share.faces.begins[face]; k < share.faces.begins[face + 1]; ++k) {
            std::uint32_t& id = ids[share.faces.corners[k]];
            if (id == kNone) id = idOf(share.faces.points[share.faces.corners[k]]);
            surface_.corners.push_back(id);
        }
        surface_.begins.push_back(surface_.corners.size());
        for (std::size_t f = 0; f < fields_.size(); ++f) {
            const auto width = std::size_t(fields_[f].components);
            const auto from = share.values[f].begin() + std::ptrdiff_t(face * width);
            auto& to = surface_.values[fields_[f].name];
            to.insert(to.end(), from, from + std::ptrdiff_t(width));
        }
    }

    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

private:
    std::uint32_t idOf(const glm::dvec3& point)
    {
        const auto next = std::uint32_t(surface_.points.size());
        if (merges_) {
            const auto [at, isNew] = places_.try_emplace(point, next);
            if (!isNew) return at->second;
        }
        surface_.points.push_back(point);
        return next;
    }

    FoamSurface& surface_;
    const std::vector<FoamField>& fields_;
    const bool merges_;
    std::unordered_map<glm::dvec3, std::uint32_t, SamePlace> places_;
};

/// `first`: which of all folders the first share's is. `merges`: points at the same place are one.
void join(const std::vector<Share>& shares, const std::vector<FoamField>& fields, std::size_t first, bool merges,
          FoamSurface& surface)
{
    struct Face {
        std::uint64_t place;
        std::size_t share, face;
    };
    std::vector<Face> all;
    for (std::size_t s = 0; s < shares.size(); ++s)
        for (std::size_t f = 0; f < shares[s].faces.count(); ++f)
            all.push_back({shares[s].order.empty() ? first + s : std::uint64_t(shares[s].order[f]), s, f});
    std::stable_sort(all.begin(), all.end(), [](const Face& a, const Face& b) { return a.place < b.place; });
    std::vector<std::vector<std::uint32_t>> ids;
    for (const Share& share : shares) ids.emplace_back(share.faces.points.size(), Joiner::kNone);
    Joiner joiner(surface, fields, merges);
    for (const Face& face : all) {
        joiner.add(shares[face.share], ids[face.share], face.face);
        surface.places.push_back(face.place);
    }
}

/// Whether every processor says where its faces stand in the whole mesh.
bool tellsOrder(const FoamCase& foam, const std::string& region, double time)
{
    return foam.decomposed() && std::all_of(foam.folders.begin(), foam.folders.end(), [&](const std::string& folder) {
               return !foamFileOf(foamMeshFile(folder, region, time, "faceProcAddressing")).empty();
           });
}

}  // namespace

std::vector<FoamPart> foamParts(const FoamCase& foam, double time)
{
    std::vector<FoamPart> parts;
    for (const std::string& region : foam.regions)
        for (const std::string& folder : foam.folders)
            for (const FoamPatch& patch : readFoamBoundary(foamMeshFile(folder, region, time, "boundary"))) {
                if (patch.type.starts_with("processor")) continue;
                const auto same = std::find_if(parts.begin(), parts.end(), [&](const FoamPart& p) {
                    return p.region == region && p.patch == patch.name;
                });
                if (same == parts.end())
                    parts.push_back({region, patch.name, patch.type, patch.groups, patch.faces});
                else
                    same->faces += patch.faces;
            }
    return parts;
}

std::vector<FoamPart> chooseFoamParts(const FoamCase& foam, const std::vector<FoamPart>& parts,
                                      const std::vector<std::string>& wanted)
{
    std::vector<PartName> names;
    std::string listed;
    for (const FoamPart& part : parts) {
        names.push_back({part.name(), part.groups});
        listed += (listed.empty() ? "" : ", ") + part.name();
    }
    std::vector<FoamPart> chosen;
    if (wanted.empty()) {
        std::copy_if(parts.begin(), parts.end(), std::back_inserter(chosen),
                     [](const FoamPart& part) { return part.type == "wall"; });
        if (chosen.empty())
            throw InputError(
                foam.name, "no patch is a wall",
                listed.empty() ? "a mesh with patches" : fmt::format("{}:PART with one of {}", foam.name, listed));
    } else {
        for (const std::size_t i : chooseParts(names, wanted, foam.name)) chosen.push_back(parts[i]);
    }
    if (std::all_of(chosen.begin(), chosen.end(), [](const FoamPart& part) { return part.faces == 0; }))
        throw InputError(foam.name, fmt::format("patch '{}' has no faces", chosen.front().name()),
                         "a patch with faces");
    return chosen;
}

FoamSurface readFoamSurface(const FoamCase& foam, const std::vector<FoamPart>& parts, double time,
                            const std::vector<FoamField>& fields, const PieceRun& run)
{
    FoamSurface surface;
    for (const FoamField& field : fields) surface.values[field.name];
    for (const std::string& region : foam.regions) {
        if (std::none_of(parts.begin(), parts.end(), [&](const FoamPart& p) { return p.region == region; })) continue;
        const bool told = tellsOrder(foam, region, time);
        std::vector<Share> shares;
        for (int folder = run.begin; folder < run.end; ++folder)
            shares.push_back(readShare(foam, foam.folders[std::size_t(folder)], region, time, parts, fields, told));
        join(shares, fields, std::size_t(run.begin), foam.decomposed(), surface);
    }
    return surface;
}

}  // namespace aeolic
