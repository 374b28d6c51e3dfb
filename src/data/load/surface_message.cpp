#include "data/load/surface_message.h"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "aeolic/error.h"
#include "base/append.h"
#include "base/fnv.h"
#include "base/same_place.h"
#include "data/mesh/triangle_order.h"

namespace aeolic {
namespace {

/// Points come in the order in which triangles use them, whatever pieces they came from.
void sortPoints(SurfaceMesh& mesh, std::vector<std::uint32_t>& pointIds)
{
    constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> numbers(mesh.positions.size(), kNone), places;
    for (auto& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle) {
            std::uint32_t& number = numbers[corner];
            if (number == kNone) {
                number = std::uint32_t(places.size());
                places.push_back(corner);
            }
            corner = number;
        }
    permute(mesh.positions, places);
    permute(mesh.normals, places);
    permute(mesh.pointVectors, places);
    permute(mesh.pointScalars, places);
    permute(pointIds, places);
}

template <class Value>
void appendAt(std::vector<Value>& all, const std::vector<Value>& values, const std::vector<std::uint32_t>& which)
{
    if (values.empty()) return;
    for (const std::uint32_t i : which) all.push_back(values[i]);
}

/// Which points of pieces are appended, and what becomes of the others.
class PointJoiner {
public:
    explicit PointJoiner(bool welds) : welds_(welds) {}

    std::vector<std::uint32_t> places;  ///< [points of the piece] Their numbers among all.
    std::vector<std::uint32_t> added;   ///< Those of the piece's points that are new.

    /// `before`: how many points there are.
    void join(const std::vector<glm::dvec3>& pointsWorld, std::size_t before)
    {
        places.clear();
        added.clear();
        for (std::uint32_t i = 0; i < pointsWorld.size(); ++i) {
            const auto at = welds_ ? known_.find(pointsWorld[i]) : known_.end();
            const bool isNew = at == known_.end();
            places.push_back(isNew ? std::uint32_t(before + added.size()) : at->second);
            if (isNew) added.push_back(i);
        }
        if (!welds_) return;
        for (const std::uint32_t i : added) known_.try_emplace(pointsWorld[i], places[i]);
    }

private:
    const bool welds_;
    std::unordered_map<glm::dvec3, std::uint32_t, SamePlace> known_;  // Of the pieces before: each may have it twice.
};

/// Values of one piece cannot stand for points or triangles of another. A piece without any says nothing.
void requireSameArrays(const LoadedSurface& all, const LoadedSurface& piece)
{
    const SurfaceMesh &mesh = all.mesh, &more = piece.mesh;
    const auto differ = [](const auto& a, const auto& b) { return a.empty() != b.empty(); };
    const bool havePoints = !all.pointsWorld.empty() && !piece.pointsWorld.empty();
    const bool haveTriangles = !mesh.triangles.empty() && !more.triangles.empty();
    if ((havePoints &&
         (differ(mesh.pointVectors, more.pointVectors) || differ(mesh.pointScalars, more.pointScalars))) ||
        (haveTriangles && (differ(mesh.cellVectors, more.cellVectors) || differ(mesh.cellScalars, more.cellScalars))) ||
        (havePoints && all.scalarLabel != piece.scalarLabel))
        throw InputError(piece.where, "it has other arrays to draw than the parts before",
                         "the same in all parts of a surface, on points or on cells");
}

/// One more than the greatest of the ids from `first` on.
std::uint32_t endOf(const std::vector<std::uint32_t>& ids, std::size_t first = 0)
{
    return ids.size() == first ? 0 : 1 + *std::max_element(ids.begin() + std::ptrdiff_t(first), ids.end());
}

/// Appends a piece that is not placed yet, but for those of its points that are there already. Its points' ids begin at
/// `firstId`. The cost is that of the piece, however many came before.
void appendPiece(LoadedSurface& all, const LoadedSurface& piece, const PointJoiner& points, std::uint32_t firstId)
{
    SurfaceMesh& mesh = all.mesh;
    const SurfaceMesh& more = piece.mesh;
    const bool normals = hasNormals(all) && hasNormals(piece);
    for (const std::uint32_t point : points.added)
        all.pointIds.push_back(firstId + (piece.pointIds.empty() ? point : piece.pointIds[point]));
    appendAt(all.pointsWorld, piece.pointsWorld, points.added);
    appendAt(mesh.normals, more.normals, points.added);
    if (!normals) mesh.normals = {};
    appendAt(mesh.pointVectors, more.pointVectors, points.added);
    appendAt(mesh.pointScalars, more.pointScalars, points.added);
    appendAll(mesh.cellVectors, more.cellVectors);
    appendAll(mesh.cellScalars, more.cellScalars);
    appendAll(mesh.order, more.order);
    for (const auto& [a, b, c] : more.triangles)
        mesh.triangles.push_back({points.places[a], points.places[b], points.places[c]});
}

}  // namespace

void addTally(std::vector<Tally>& all, const Tally& tally)
{
    const auto same = std::ranges::find_if(all, [&](const Tally& t) { return t.sameThing(tally); });
    if (same == all.end()) return all.push_back(tally);
    same->found += tally.found;
    same->also += tally.also;
    same->all += tally.all;
    same->longest = std::max(same->longest, tally.longest);
}

template <PerhapsConst<LoadedSurface> Surface, class Visit>
void withMembers(Surface& surface, const Visit& visit)
{
    auto& mesh = surface.mesh;
    visit(mesh.originWorld, mesh.positions, mesh.normals, mesh.triangles, mesh.pointVectors, mesh.cellVectors,
          mesh.pointScalars, mesh.cellScalars, mesh.order, mesh.name);
    visit(surface.topology, surface.pointIds, surface.piece, surface.placed, surface.pointsWorld, surface.where,
          surface.cutOut, surface.cutRange, surface.scalarLabel, surface.ofVectors, surface.vectorsName, surface.arrays,
          surface.timeSteps, surface.warnings, surface.offered, surface.tallies);
}

Bytes messageOf(const LoadedSurface& surface)
{
    return byteMessage(surface);
}

LoadedSurface surfaceOf(std::span<const std::byte> message)
{
    ByteReader reader(message);
    LoadedSurface surface;
    reader.read(surface);
    if (!reader.atEnd()) throw std::runtime_error("a message with a surface is malformed");
    return surface;
}

LoadedSurface appendPieces(std::vector<LoadedSurface> pieces, bool welds)
{
    PointJoiner points(welds);
    LoadedSurface all = std::move(pieces.front());
    Fnv topology{all.topology};
    points.join(all.pointsWorld, 0);
    std::uint32_t nextId = endOf(all.pointIds);
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        LoadedSurface& piece = pieces[i];
        points.join(piece.pointsWorld, all.pointsWorld.size());
        topology.mix(piece.topology);
        requireSameArrays(all, piece);
        const std::size_t before = all.pointIds.size();
        appendPiece(all, piece, points, nextId);
        nextId = std::max(nextId, endOf(all.pointIds, before));
        for (const Tally& tally : piece.tallies) addTally(all.tallies, tally);
        for (const std::string& warning : piece.warnings)
            if (std::ranges::find(all.warnings, warning) == all.warnings.end()) all.warnings.push_back(warning);
        if (all.mesh.name.empty()) all.mesh.name = piece.mesh.name;
        if (all.scalarLabel.empty()) {
            all.scalarLabel = piece.scalarLabel;
            all.ofVectors = piece.ofVectors;
        }
        if (all.vectorsName.empty()) all.vectorsName = piece.vectorsName;
        if (all.arrays.empty()) all.arrays = piece.arrays;
        if (all.offered.empty()) all.offered = piece.offered;
        piece = {};
    }
    if (pieces.size() > 1) all.topology = knownTopology(topology.value);
    return all;
}

LoadedSurface joinPieces(std::vector<LoadedSurface> pieces, bool welds)
{
    LoadedSurface all = appendPieces(std::move(pieces), welds);
    placePiece(all, factsOf(all));
    sortTriangles(all.mesh);
    all.mesh.order = {};
    sortPoints(all.mesh, all.pointIds);
    all.where = all.mesh.name;
    all.piece = false;
    return all;
}

LoadedSurface shareSurface(LoadedSurface mine, Agreement& agreement)
{
    const Pieces lies = mine.lies;
    Bytes message;
    agreement.together([&] {
        if (lies != Pieces::none || agreement.part().rank == 0) message = messageOf(mine);
        mine = {};
    });
    std::vector<Bytes> messages;
    if (lies == Pieces::none)
        messages.push_back(agreement.ofFirst(std::move(message)));
    else
        messages = agreement.gatherAll(std::move(message));
    agreement.together([&] {
        std::vector<LoadedSurface> pieces;
        for (Bytes& some : messages) {
            pieces.push_back(surfaceOf(some));
            some = {};
        }
        mine = lies == Pieces::none ? std::move(pieces.front()) : joinPieces(std::move(pieces), lies == Pieces::joined);
        if (mine.mesh.triangles.empty())
            throw InputError(mine.where, "no polygons in any of its pieces", "a surface of at least one triangle");
    });
    return mine;
}

}  // namespace aeolic
