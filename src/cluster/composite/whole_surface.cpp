#include "cluster/composite/whole_surface.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "cluster/composite/triangle_messages.h"
#include "data/mesh/triangle_order.h"

namespace aeolic {
namespace {

/// A point's vector on its way to the other ranks.
struct PointVector {
    std::uint64_t point = 0;
    std::array<double, 3> vector{};
};

/// Which rank counts the triangles of a number. Neighbours go to different ranks, and the same number to one.
std::size_t counterOf(std::uint64_t order, int ranks)
{
    return std::size_t(order % std::uint64_t(ranks));
}

/// The values of a message of nothing else.
template <class Value>
std::vector<Value> valuesOf(const Message& message)
{
    if (message.bytes.size() % sizeof(Value) != 0)
        throw std::runtime_error("rank " + std::to_string(message.rank) + " sent a part of a value");
    std::vector<Value> values(message.bytes.size() / sizeof(Value));
    if (!values.empty()) std::memcpy(values.data(), message.bytes.data(), message.bytes.size());
    return values;
}

template <class Value>
Bytes bytesOf(const std::vector<Value>& values)
{
    const auto* const begin = reinterpret_cast<const std::byte*>(values.data());
    return Bytes(begin, begin + values.size() * sizeof(Value));
}

}  // namespace

SurfaceMesh gatherTriangles(Communicator& communicator, const SurfaceMesh& piece,
                            const std::vector<std::uint32_t>& triangles)
{
    std::vector<Bytes> all = communicator.allGather(triangleMessage(piece, triangles, {}));
    SurfaceMesh whole;
    whole.originWorld = piece.originWorld;
    whole.name = piece.name;
    for (int rank = 0; rank < communicator.size(); ++rank) {
        Message message{rank, std::move(all[std::size_t(rank)])};
        if (!message.bytes.empty()) takeTriangles(message, whole);
    }
    sortTriangles(whole);
    dropRepeatedTriangles(whole);
    return whole;
}

SurfaceMesh gatherSurface(Communicator& communicator, const SurfaceMesh& piece)
{
    std::vector<std::uint32_t> triangles(piece.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0u);
    return gatherTriangles(communicator, piece, triangles);
}

std::uint64_t trianglesBefore(Communicator& communicator, const SurfaceMesh& piece, std::uint64_t order)
{
    std::vector<std::vector<std::uint64_t>> toRank(std::size_t(communicator.size()));
    for (const std::uint64_t each : piece.order)
        if (each < order) toRank[counterOf(each, communicator.size())].push_back(each);
    std::vector<Message> outgoing;
    for (int rank = 0; rank < communicator.size(); ++rank)
        outgoing.push_back({rank, bytesOf(std::exchange(toRank[std::size_t(rank)], {}))});
    std::vector<std::uint64_t> counted;
    for (const Message& message : communicator.exchange(std::move(outgoing))) {
        const auto more = valuesOf<std::uint64_t>(message);
        counted.insert(counted.end(), more.begin(), more.end());
    }
    std::sort(counted.begin(), counted.end());
    const auto different = std::unique(counted.begin(), counted.end()) - counted.begin();
    return std::uint64_t(communicator.allReduce(std::int64_t(different), Reduction::sum));
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
    const std::vector<Bytes> all = communicator.allGather(bytesOf(mine));
    for (int rank = 0; rank < communicator.size(); ++rank)
        for (const PointVector& each : valuesOf<PointVector>({rank, all[std::size_t(rank)]})) {
            if (each.point >= found.size())
                throw std::runtime_error("rank " + std::to_string(rank) + " sent a point that nobody asked for");
            found[each.point].vector = {each.vector[0], each.vector[1], each.vector[2]};
        }
    return found;
}

}  // namespace aeolic
