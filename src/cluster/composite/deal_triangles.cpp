#include "cluster/composite/deal_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cluster/composite/triangle_messages.h"
#include "data/mesh/triangle_order.h"

namespace aeolic {
namespace {

// A pixel may lie this far outside its triangle: rounding, of the view too, is far less.
constexpr double kMarginCells = 1;

using Indices = std::vector<std::uint32_t>;

/// Finds the ranks that need a triangle.
class Owners {
public:
    Owners(const GridField& field, int ranks) : field_(field), tree_(field.dims, ranks) {}

    /// Calls visit(rank) for each of them.
    template <class Visit>
    void forEach(const SurfaceMesh& mesh, std::size_t triangle, const Visit& visit) const
    {
        Bounds box;
        for (const std::uint32_t corner : mesh.triangles[triangle]) box.add(mesh.positions[corner]);
        const GridIndex lo = cellOf(mesh.originWorld + box.lo, -kMarginCells),
                        hi = cellOf(mesh.originWorld + box.hi, kMarginCells);
        const int first = tree_.ownerOf(lo);
        if (tree_.brick(first).owns(hi)) return visit(first);
        for (int rank = 0; rank < tree_.ranks(); ++rank)
            if (meets(tree_.brick(rank), lo, hi)) visit(rank);
    }

    int first(const SurfaceMesh& mesh, std::size_t triangle) const
    {
        int lowest = tree_.ranks();
        forEach(mesh, triangle, [&](int rank) { lowest = std::min(lowest, rank); });
        return lowest;
    }

private:
    GridIndex cellOf(const glm::dvec3& world, double more) const
    {
        GridIndex cell{};
        for (int c = 0; c < 3; ++c) {
            const double grid = (world[c] - field_.originWorld[c]) / field_.spacingWorld[c] + more;
            const auto last = double(field_.dims[std::size_t(c)] - 2);
            cell[std::size_t(c)] = std::int64_t(std::clamp(std::floor(grid), 0.0, last));
        }
        return cell;
    }
    static bool meets(const Brick& brick, const GridIndex& lo, const GridIndex& hi)
    {
        bool all = !brick.empty();
        for (std::size_t c = 0; c < 3; ++c) all = all && lo[c] < brick.cellHi[c] && hi[c] >= brick.cellLo[c];
        return all;
    }

    const GridField& field_;
    BrickTree tree_;
};

Indices unusedPoints(const SurfaceMesh& mesh)
{
    std::vector<char> used(mesh.positions.size(), 0);
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) used[corner] = 1;
    Indices unused;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (!used[i]) unused.push_back(std::uint32_t(i));
    return unused;
}

}  // namespace

SurfaceMesh dealToBricks(Communicator& communicator, SurfaceMesh piece, const GridField& field,
                         const GridField* dealtBy)
{
    const Owners owners(field, communicator.size());
    const Owners before(dealtBy ? *dealtBy : field, communicator.size());
    std::vector<Indices> trianglesOf(std::size_t(communicator.size()));
    for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
        if (dealtBy && before.first(piece, i) != communicator.rank())
            continue;  // Others have it too, and one sends it.
        owners.forEach(piece, i, [&](int rank) { trianglesOf[std::size_t(rank)].push_back(std::uint32_t(i)); });
    }
    std::vector<Message> outgoing;
    outgoing.reserve(trianglesOf.size());
    for (int rank = 0; rank < communicator.size(); ++rank)
        outgoing.push_back({rank, triangleMessage(piece, trianglesOf[std::size_t(rank)],
                                                  rank == communicator.rank() ? unusedPoints(piece) : Indices())});
    SurfaceMesh mine;
    mine.originWorld = piece.originWorld;
    mine.name = piece.name;
    piece = {};  // Its memory is needed for the triangles to come.
    trianglesOf.clear();
    std::vector<Message> incoming = communicator.exchange(std::move(outgoing));
    for (Message& message : incoming) {
        takeTriangles(message, mine);
        message.bytes = {};
    }
    sortTriangles(mine);  // Strips come behind the polygons of all pieces, whichever rank read them.
    return mine;
}

}  // namespace aeolic
