#include "cluster/composite/whole_surface.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "cluster/composite/pixel_messages.h"
#include "cluster/composite/triangle_messages.h"
#include "data/mesh/triangle_order.h"

namespace aeolic {
namespace {

/// A point's vector on its way to the other ranks.
struct PointVector {
    std::uint64_t point = 0;
    std::array<double, 3> vector{};
};

/// The places of the triangles that stay, of those sorted by number. Where several ranks gave triangles of the same
/// number, those of the lowest rank stay.
std::vector<std::uint32_t> withoutRepeats(const SurfaceMesh& mesh, const std::vector<std::int32_t>& rank,
                                          const std::vector<std::uint32_t>& sorted)
{
    std::vector<std::uint32_t> kept;
    kept.reserve(sorted.size());
    for (const std::uint32_t place : sorted) {
        const bool isSameNumber = !kept.empty() && mesh.order[kept.back()] == mesh.order[place];
        if (!isSameNumber || rank[kept.back()] == rank[place]) kept.push_back(place);
    }
    return kept;
}

/// How many triangles of all pieces have lower numbers, each counted once.
std::uint64_t countBefore(Communicator& communicator, const SurfaceMesh& piece, std::uint64_t order)
{
    std::vector<std::vector<std::uint64_t>> toRank(std::size_t(communicator.size()));
    // Which rank counts a number: neighbours go to different ranks, and the same number to one.
    for (const std::uint64_t each : piece.order)
        if (each < order) toRank[each % toRank.size()].push_back(each);
    std::vector<Message> outgoing;
    outgoing.reserve(toRank.size());
    for (int rank = 0; rank < communicator.size(); ++rank)
        outgoing.push_back({rank, messageOf(std::exchange(toRank[std::size_t(rank)], {}))});
    std::vector<std::pair<std::uint64_t, int>> counted;  // Numbers, and whose they are.
    for (const Message& message : communicator.exchange(std::move(outgoing)))
        for (const std::uint64_t each : valuesOf<std::uint64_t>(message)) counted.emplace_back(each, message.rank);
    std::sort(counted.begin(), counted.end());
    std::int64_t count = 0;
    const std::pair<std::uint64_t, int>* first = nullptr;  // Of the same number.
    for (const auto& each : counted) {
        if (!first || first->first != each.first) first = &each;
        count += each.second == first->second;
    }
    return std::uint64_t(communicator.allReduce(count, Reduction::sum));
}

}  // namespace

GatheredTriangles gatherTriangles(Communicator& communicator, const SurfaceMesh& piece,
                                  const std::vector<std::uint32_t>& triangles)
{
    std::vector<Bytes> all = communicator.allGather(triangleMessage(piece, triangles, {}));
    GatheredTriangles found;
    SurfaceMesh& whole = found.mesh;
    whole.originWorld = piece.originWorld;
    whole.name = piece.name;
    for (int rank = 0; rank < communicator.size(); ++rank) {
        Message message{rank, std::move(all[std::size_t(rank)])};
        if (message.bytes.empty()) continue;
        const auto before = std::uint32_t(whole.triangles.size());
        takeTriangles(message, whole);
        found.rank.resize(whole.triangles.size(), rank);
        for (std::uint32_t i = before; i < whole.triangles.size(); ++i) found.ofRank.push_back(i - before);
    }
    const std::vector<std::uint32_t> kept = withoutRepeats(whole, found.rank, sortedByNumber(whole));
    takeTriangles(whole, kept);
    permute(found.rank, kept);
    permute(found.ofRank, kept);
    return found;
}

SurfaceMesh gatherSurface(Communicator& communicator, const SurfaceMesh& piece)
{
    std::vector<std::uint32_t> triangles(piece.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0u);
    return gatherTriangles(communicator, piece, triangles).mesh;
}

std::uint64_t placeInWhole(Communicator& communicator, const SurfaceMesh& piece, int rank, std::uint32_t which)
{
    const bool isMine = rank == communicator.rank();
    // What the owner gives, and zeros of all others.
    std::int64_t number = isMine ? std::int64_t(piece.order[which]) : 0;
    number = communicator.allReduce(number, Reduction::sum);
    std::int64_t amongParts = 0;
    for (std::uint32_t i = which; isMine && i > 0 && piece.order[i - 1] == piece.order[which]; --i) ++amongParts;
    return countBefore(communicator, piece, std::uint64_t(number)) +
           std::uint64_t(communicator.allReduce(amongParts, Reduction::sum));
}

std::vector<FieldVector> vectorsOfAll(Communicator& communicator, const GridField& field,
                                      const std::vector<glm::dvec3>& pointsWorld)
{
    std::vector<FieldVector> found = vectorsAt(field, pointsWorld);
    if (!field.brick) return found;
    std::vector<PointVector> mine;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i].inside && !std::exchange(found[i].elsewhere, false))
            mine.push_back({i, {found[i].vector.x, found[i].vector.y, found[i].vector.z}});
    const std::vector<Bytes> all = communicator.allGather(messageOf(mine));
    for (int rank = 0; rank < communicator.size(); ++rank)
        for (const PointVector& each : valuesOf<PointVector>({rank, all[std::size_t(rank)]})) {
            if (each.point >= found.size())
                throw std::runtime_error("rank " + std::to_string(rank) + " sent a point that nobody asked for");
            found[each.point].vector = {each.vector[0], each.vector[1], each.vector[2]};
        }
    return found;
}

}  // namespace aeolic
