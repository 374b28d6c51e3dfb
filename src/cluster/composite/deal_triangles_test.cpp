#include "cluster/composite/deal_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <mutex>
#include <stdexcept>

#include "cluster/composite/triangle_messages.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

constexpr std::int64_t kSamples = 11;

GridField fieldOf(const Communicator& communicator)
{
    GridField field;
    field.dims = {kSamples, kSamples, kSamples};
    field.originWorld = {100, 0, 0};
    field.brick = brickOf(field, {communicator.rank(), communicator.size()});
    return field;
}

/// A rank's piece: small triangles along the box's diagonal, and one point that none uses. Positions are told by place
/// among all, and so is everything else.
SurfaceMesh pieceOf(int rank, int triangles, double size)
{
    SurfaceMesh mesh;
    mesh.originWorld = {105, 5, 5};
    mesh.name = "torus.pvtp";
    const auto point = [&](double along, double more) {
        const auto at = float(along - 5);
        mesh.positions.push_back({at + float(more), at, at});
        mesh.normals.push_back({0, float(along), 1});
        mesh.pointScalars.push_back(float(along + more));
        return std::uint32_t(mesh.positions.size() - 1);
    };
    point(10.0 * rank, 0);
    for (int i = 0; i < triangles; ++i) {
        const double along = 0.1 + 9.8 * double(7 * rank + i) / 56;
        mesh.triangles.push_back({point(along, 0), point(along, size), point(along + size, 0)});
        mesh.cellVectors.push_back({float(rank), float(i), 0});
        const std::uint64_t strip = rank == 1 && i >= 3 ? std::uint64_t{1} << 63 : 0;
        mesh.order.push_back(strip | std::uint64_t(rank) << 40 | std::uint64_t(i));
    }
    return mesh;
}

struct Held {
    std::vector<int> ranks;
    std::array<glm::vec3, 3> corners;
};

/// Who holds which triangle, by its order; with all that belongs to it checked.
std::map<std::uint64_t, Held> deal(int ranks, double size, const std::vector<int>& triangles)
{
    std::map<std::uint64_t, Held> held;
    std::mutex mutex;
    std::size_t unused = 0;
    runRanks(ranks, [&](Communicator& communicator) {
        const int rank = communicator.rank();
        const SurfaceMesh mine =
            dealToBricks(communicator, pieceOf(rank, triangles[std::size_t(rank)], size), fieldOf(communicator));
        EXPECT_EQ(mine.originWorld, glm::dvec3(105, 5, 5));
        EXPECT_EQ(mine.name, "torus.pvtp");
        EXPECT_TRUE(std::is_sorted(mine.order.begin(), mine.order.end()));
        EXPECT_EQ(mine.normals.size(), mine.positions.size());
        EXPECT_EQ(mine.pointScalars.size(), mine.positions.size());
        EXPECT_EQ(mine.order.size(), mine.triangles.size());
        EXPECT_EQ(mine.cellVectors.size(), mine.triangles.size());
        std::vector<int> uses(mine.positions.size(), 0);
        const std::lock_guard lock(mutex);
        for (std::size_t i = 0; i < mine.triangles.size(); ++i) {
            const std::uint64_t order = mine.order[i] & ~(std::uint64_t{1} << 63);
            const auto from = int(order >> 40), place = int(order & 0xff);
            EXPECT_EQ(mine.cellVectors[i], glm::vec3(float(from), float(place), 0));
            const SurfaceMesh source = pieceOf(from, triangles[std::size_t(from)], size);
            Held& entry = held[order];
            entry.ranks.push_back(rank);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t at = mine.triangles[i][k], was = source.triangles[std::size_t(place)][k];
                ++uses[at];
                entry.corners[k] = mine.positions[at];
                EXPECT_EQ(mine.positions[at], source.positions[was]);
                EXPECT_EQ(mine.normals[at], source.normals[was]);
                EXPECT_EQ(mine.pointScalars[at], source.pointScalars[was]);
            }
        }
        unused += std::size_t(std::count(uses.begin(), uses.end(), 0));
    });
    EXPECT_EQ(unused, std::size_t(ranks)) << "a point that no triangle uses stays, once";
    return held;
}

bool reachesInto(const Brick& brick, const std::array<glm::vec3, 3>& corners, double margin)
{
    bool all = !brick.empty();
    for (int c = 0; c < 3; ++c) {
        double lo = 1e9, hi = -1e9;
        for (const glm::vec3& corner : corners)
            lo = std::min(lo, double(corner[c]) + 5), hi = std::max(hi, double(corner[c]) + 5);
        const auto a = std::size_t(c);
        all = all && hi + margin >= double(brick.cellLo[a]) && lo - margin < double(brick.cellHi[a]);
    }
    return all;
}

TEST(DealToBricks, EveryTriangleGoesWhereItReaches)
{
    for (const int ranks : {1, 2, 3, 5, 8})
        for (const double size : {0.05, 4.0}) {
            const auto held = deal(ranks, size, std::vector<int>(std::size_t(ranks), 7));
            EXPECT_EQ(held.size(), std::size_t(7 * ranks)) << "none is lost";
            const BrickTree tree({kSamples, kSamples, kSamples}, ranks);
            for (const auto& [order, triangle] : held)
                for (int r = 0; r < ranks; ++r) {
                    const bool has = std::count(triangle.ranks.begin(), triangle.ranks.end(), r) == 1;
                    if (reachesInto(tree.brick(r), triangle.corners, 0)) {
                        EXPECT_TRUE(has) << order << " on rank " << r;
                    }
                    if (!reachesInto(tree.brick(r), triangle.corners, 2.001)) {
                        EXPECT_FALSE(has) << order << " on rank " << r;
                    }
                }
        }
}

TEST(DealToBricks, RanksWithNothingAndMoreRanksThanCells)
{
    EXPECT_EQ(deal(4, 0.1, {0, 7, 0, 5}).size(), 12u);
    EXPECT_EQ(deal(3, 0.1, {0, 0, 0}).size(), 0u);
}

/// A second dealing gives what a first one gives: no triangle twice, though several ranks hold some.
TEST(DealToBricks, AgainByOtherBricks)
{
    runRanks(5, [](Communicator& communicator) {
        const GridField first = fieldOf(communicator);
        GridField second = first;
        second.dims = {21, 5, 9};
        second.spacingWorld = {0.5, 2.5, 1.25};
        second.brick = brickOf(second, {communicator.rank(), communicator.size()});
        const SurfaceMesh piece = pieceOf(communicator.rank(), 7, 3.0);
        const SurfaceMesh twice = dealToBricks(communicator, dealToBricks(communicator, piece, first), second, &first);
        const SurfaceMesh once = dealToBricks(communicator, piece, second);
        EXPECT_EQ(twice.order, once.order);
        ASSERT_EQ(twice.triangles.size(), once.triangles.size());
        for (std::size_t i = 0; i < once.triangles.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(twice.positions[twice.triangles[i][k]], once.positions[once.triangles[i][k]]);
        const auto points = [&](const SurfaceMesh& mesh) {
            return communicator.allReduce(std::int64_t(mesh.positions.size()), Reduction::sum);
        };
        EXPECT_LE(points(twice), 3 * communicator.allReduce(std::int64_t(twice.triangles.size()), Reduction::sum) + 5)
            << "five that no triangle uses, and none more";
    });
}

/// Beyond the field the nearest cells' owners hold them.
TEST(DealToBricks, WhatIsOutsideTheFieldIsHeldByTheNearest)
{
    runRanks(2, [&](Communicator& communicator) {
        SurfaceMesh far;
        if (communicator.rank() == 0) {
            far.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
            far.normals.assign(3, {0, 0, 1});
            far.triangles = {{0, 1, 2}};
            far.order = {5};
        }
        far.originWorld = {-400, 900, 1e7};
        const SurfaceMesh mine = dealToBricks(communicator, far, fieldOf(communicator));
        EXPECT_EQ(mine.triangles.size(), std::size_t(communicator.rank() == 1)) << "the upper half in z";
    });
}

TEST(TriangleMessages, DamagedOnesAreErrorsThatNameTheSender)
{
    const SurfaceMesh piece = pieceOf(0, 7, 0.1);
    const Bytes whole = triangleMessage(piece, {0, 1, 2, 6}, {});
    const auto complaint = [](Bytes bytes) {
        SurfaceMesh mesh;
        try {
            takeTriangles({3, std::move(bytes)}, mesh);
        } catch (const std::runtime_error& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(complaint(whole), "");
    EXPECT_EQ(triangleMessage(piece, {}, {}).size(), 0u);
    for (const std::size_t size : {std::size_t{4}, std::size_t{20}, whole.size() - 1})
        EXPECT_NE(complaint(Bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size))).find("rank 3"),
                  std::string::npos)
            << size;
    Bytes longer = whole;
    longer.push_back({});
    EXPECT_NE(complaint(longer), "");
    Bytes wrong = whole;
    const std::uint32_t far = 1000;
    std::memcpy(wrong.data() + 8, &far, sizeof far);
    EXPECT_EQ(complaint(wrong), "rank 3's triangles refer to points that have not come");
}

TEST(DealToBricks, OtherArraysAreAnError)
{
    EXPECT_THROW(runRanks(2,
                          [](Communicator& communicator) {
                              SurfaceMesh mesh = pieceOf(communicator.rank(), 3, 0.1);
                              if (communicator.rank() == 1) mesh.pointScalars.clear();
                              dealToBricks(communicator, mesh, fieldOf(communicator));
                          }),
                 std::runtime_error);
}

}  // namespace
}  // namespace aeolic
