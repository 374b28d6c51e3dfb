#include "reader/openfoam/foam_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "aeolic/error.h"
#include "reader/openfoam/foam_mesh.h"
#include "reader/openfoam/foam_points.h"

namespace aeolic {
namespace {

/// One folder's share of a region's patches.
struct Share {
    FoamFaces faces;
    std::vector<std::vector<float>> values;  ///< [fields]
    std::vector<std::int64_t> order;  ///< [faces] Their places among all faces of the whole mesh; empty: not told.
};

Share readShare(const FoamCase& foam, const FoamPath& folder, const std::string& region, double time,
                const std::vector<FoamPart>& parts, const std::vector<FoamField>& fields, bool told)
{
    const FoamPath boundary = foamMeshFile(folder, region, time, "boundary");
    const std::vector<FoamPatch> all = readFoamBoundary(boundary);
    std::vector<FoamPatch> patches;
    for (const FoamPatch& patch : all)
        if (std::ranges::any_of(parts, [&](const FoamPart& p) { return p.region == region && p.patch == patch.name; }))
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
        share.values.push_back(
            foamHasField(foam, region, time, field)
                ? readFoamValues(folder, region, time, field, patches, share.faces)
                : std::vector<float>(share.faces.faces.count() * std::size_t(field.components), kMissing));
    if (!told) return share;
    const FoamPath addressing = foamMeshFile(folder, region, time, "faceProcAddressing");
    share.order = readFoamLabels(addressing, share.faces.numbers);
    for (std::int64_t& place : share.order) {  // Counted from 1; negative where the face is turned round.
        if (place == 0 || place == std::numeric_limits<std::int64_t>::min())
            throw InputError(foamFileOf(addressing), fmt::format("a face has number {}", place), "1 and more");
        place = place < 0 ? -place : place;
    }
    return share;
}

/// One of the region's faces.
struct PlacedFace {
    std::uint64_t place;
    std::size_t share, face;
};

/// `first`: which of all folders the first share's is.
std::vector<PlacedFace> facesInOrder(const std::vector<Share>& shares, std::size_t first)
{
    std::vector<PlacedFace> all;
    for (std::size_t s = 0; s < shares.size(); ++s)
        for (std::size_t f = 0; f < shares[s].faces.faces.count(); ++f)
            all.push_back({shares[s].order.empty() ? first + s : std::uint64_t(shares[s].order[f]), s, f});
    std::ranges::stable_sort(all, [](const PlacedFace& a, const PlacedFace& b) { return a.place < b.place; });
    return all;
}

/// Whether every processor says where its faces stand in the whole mesh.
bool tellsOrder(const FoamCase& foam, const std::string& region, double time)
{
    return foam.decomposed() && std::ranges::all_of(foam.folders, [&](const FoamPath& folder) {
               return !foamFileOf(foamMeshFile(folder, region, time, "faceProcAddressing")).empty();
           });
}

}  // namespace

std::vector<FoamPart> foamPatches(const FoamCase& foam, double time)
{
    std::vector<FoamPart> parts;
    for (const std::string& region : foam.regions)
        for (const FoamPath& folder : foam.folders)
            for (const FoamPatch& patch : readFoamBoundary(foamMeshFile(folder, region, time, "boundary"))) {
                if (patch.type.starts_with("processor")) continue;
                const auto same = std::ranges::find_if(
                    parts, [&](const FoamPart& p) { return p.region == region && p.patch == patch.name; });
                if (same == parts.end())
                    parts.push_back({region, patch.name, patch.type, patch.groups, patch.faces});
                else
                    same->faces += patch.faces;
            }
    return parts;
}

PartMesh readFoamPatches(const FoamCase& foam, const std::vector<FoamPart>& parts, double time,
                         const std::vector<FoamField>& fields, const PieceRun& run)
{
    FoamPoints points(foam.decomposed());
    PartCells polygons{CellShape::polygon, 0, {}, {}, {}};
    std::vector<std::vector<float>> values(fields.size());
    PartMesh mesh;
    for (const std::string& region : foam.regions) {
        if (std::ranges::none_of(parts, [&](const FoamPart& p) { return p.region == region; })) continue;
        const bool told = tellsOrder(foam, region, time);
        std::vector<Share> shares;
        std::vector<std::vector<std::int64_t>> ids;  // [shares][points] Their numbers among all; -1: none yet.
        for (int folder = run.begin; folder < run.end; ++folder) {
            shares.push_back(readShare(foam, foam.folders[std::size_t(folder)], region, time, parts, fields, told));
            ids.emplace_back(shares.back().faces.points.size(), -1);
        }
        points.forgetPlaces();  // Where two regions meet, their points are not one.
        for (const PlacedFace& face : facesInOrder(shares, std::size_t(run.begin))) {
            const Share& share = shares[face.share];
            const auto corners = share.faces.faces.face(face.face);
            for (const std::uint32_t corner : corners) {
                std::int64_t& id = ids[face.share][corner];
                if (id < 0) id = points.add(share.faces.points[corner]);
                polygons.corners.push_back(id);
            }
            polygons.sizes.push_back(std::int64_t(corners.size()));
            ++polygons.count;
            mesh.places.push_back(face.place);
            for (std::size_t f = 0; f < fields.size(); ++f) {
                const auto width = std::ptrdiff_t(fields[f].components);
                const auto first = share.values[f].begin() + std::ptrdiff_t(face.face) * width;
                values[f].insert(values[f].end(), first, first + width);
            }
        }
    }
    mesh.points = std::make_shared<const std::vector<glm::dvec3>>(std::move(points.all));
    mesh.cells.push_back(std::move(polygons));
    for (auto& each : values) mesh.values.push_back(std::make_shared<const std::vector<float>>(std::move(each)));
    return mesh;
}

}  // namespace aeolic
