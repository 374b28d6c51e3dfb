#include "data/loaded_surface.h"

#include <fmt/format.h>

#include <bit>

#include "aeolic/error.h"
#include "base/fnv.h"
#include "data/mesh/mesh_tools.h"

namespace aeolic {

std::uint64_t withPlaces(std::uint64_t topology, const SurfaceMesh& mesh)
{
    Fnv hash{topology};
    for (int c = 0; c < 3; ++c) hash.mix(std::bit_cast<std::uint64_t>(mesh.originWorld[c]));
    for (const glm::vec3& p : mesh.positions)
        for (int c = 0; c < 3; ++c) hash.mix(std::bit_cast<std::uint32_t>(p[c]));
    return knownTopology(hash.value);
}

std::uint64_t withNumbers(std::uint64_t topology, std::span<const std::uint64_t> numbers)
{
    Fnv hash{topology};
    for (const std::uint64_t number : numbers) hash.mix(number);
    return knownTopology(hash.value);
}

PieceFacts factsOf(const LoadedSurface& piece)
{
    PieceFacts facts;
    for (const glm::dvec3& p : piece.pointsWorld) facts.pointsWorld.add(p);
    facts.normals = hasNormals(piece);
    return facts;
}

bool hasNormals(const LoadedSurface& piece)
{
    return piece.pointsWorld.empty() || !piece.mesh.normals.empty();
}

void placePiece(LoadedSurface& piece, const PieceFacts& ofAll)
{
    SurfaceMesh& mesh = piece.mesh;
    if (!ofAll.pointsWorld.empty()) mesh.originWorld = ofAll.pointsWorld.center();
    if (!ofAll.normals) mesh.normals = {};
    mesh.positions.clear();
    for (const glm::dvec3& p : piece.pointsWorld) mesh.positions.emplace_back(p - mesh.originWorld);
    piece.pointsWorld = {};
    piece.placed = true;
}

void finishSurface(LoadedSurface& surface, double featureAngleDeg)
{
    SurfaceMesh& mesh = surface.mesh;
    const bool hasNormals = !mesh.normals.empty();
    const std::size_t all = mesh.triangles.size(), dropped = dropDegenerateTriangles(mesh);
    if (mesh.triangles.empty() && !surface.piece)
        throw InputError(surface.where, fmt::format("none of its {} triangles has an area", all),
                         "at least one triangle with an area");
    if (!surface.cutOut)
        surface.tallies.push_back({Tally::Of::areas, surface.mesh.name, std::int64_t(dropped), 0, std::int64_t(all)});
    if (!hasNormals) computeSmoothNormals(mesh, featureAngleDeg);
}

}  // namespace aeolic
