#include "data/cells/point_means.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace aeolic {
namespace {

PointMeans piece(const std::vector<glm::dvec3>& places, const std::vector<std::uint32_t>& cells,
                 const std::vector<float>& values)
{
    PointMeans means;
    means.placesWorld = places;
    for (std::uint32_t i = 0; i < places.size(); ++i) means.points.push_back(10 + i);
    means.cells = cells;
    means.dimensions.assign(places.size(), 3);
    means.width = std::uint32_t(values.size() / places.size());
    means.values = values;
    return means;
}

TEST(PointMeans, CountCellsOfAllPieces)
{
    std::vector<PointMeans> pieces{piece({{0, 0, 0}, {1, 0, 0}}, {3, 2}, {10, 1, 20, 2}), PointMeans{},
                                   piece({{1, 0, 0}, {2, 0, 0}}, {6, 1}, {60, 10, 7, 8}),
                                   piece({{-0.0, 0, 0}}, {1}, {50, 5})};
    uniteMeans(pieces);
    EXPECT_EQ(pieces[0].values, (std::vector<float>{20, 2, 50, 8}));  // (3·10 + 50)/4, (2·20 + 6·60)/8.
    EXPECT_EQ(pieces[2].values, (std::vector<float>{50, 8, 7, 8}));
    EXPECT_EQ(pieces[3].values, (std::vector<float>{20, 2}));
}

/// A piece whose only cells at a place are faces of the boundary takes what its neighbour's volume has there.
TEST(PointMeans, CountNoFacesBesideAVolume)
{
    PointMeans faces = piece({{0, 0, 0}}, {5}, {1});
    faces.dimensions = {2};
    for (const bool facesFirst : {true, false}) {
        std::vector<PointMeans> pieces{piece({{0, 0, 0}}, {1}, {10}), piece({{0, 0, 0}}, {3}, {20})};
        pieces.insert(facesFirst ? pieces.begin() : pieces.end(), faces);
        uniteMeans(pieces);
        for (const PointMeans& means : pieces) EXPECT_EQ(means.values, (std::vector<float>{17.5f}));
    }
}

TEST(PointMeans, StayWhereAPieceHasAPlaceTwice)
{
    std::vector<PointMeans> pieces{piece({{0, 0, 0}, {0, 0, 0}}, {1, 1}, {1, 2}), piece({{0, 0, 0}}, {1}, {9})};
    uniteMeans(pieces);
    EXPECT_EQ(pieces[0].values, (std::vector<float>{1, 2}));
    EXPECT_EQ(pieces[1].values, (std::vector<float>{9}));
}

/// A piece that has a place twice keeps its means, also where a piece before it has that place once.
TEST(PointMeans, StayWhereALaterPieceHasAPlaceTwice)
{
    std::vector<PointMeans> pieces{piece({{0, 0, 0}}, {1}, {9}), piece({{0, 0, 0}, {0, 0, 0}}, {1, 1}, {1, 2}),
                                   piece({{0, 0, 0}}, {1}, {5})};
    uniteMeans(pieces);
    EXPECT_EQ(pieces[0].values, (std::vector<float>{9}));
    EXPECT_EQ(pieces[1].values, (std::vector<float>{1, 2}));
    EXPECT_EQ(pieces[2].values, (std::vector<float>{5}));
}

TEST(PointMeans, AreMaskedWhereAnyPiecesAre)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<PointMeans> pieces{piece({{0, 0, 0}}, {1}, {nan}), piece({{0, 0, 0}}, {4}, {9})};
    uniteMeans(pieces);
    EXPECT_TRUE(std::isnan(pieces[0].values[0]) && std::isnan(pieces[1].values[0]));
}

TEST(PointMeans, TravelAsMessages)
{
    const PointMeans sent = piece({{0, 0.5, 0}, {1, 0, 0}}, {3, 2}, {10, 1, 20, 2});
    Bytes message = messageOf(sent);
    const PointMeans got = meansOf(message);
    EXPECT_EQ(got.placesWorld, sent.placesWorld);
    EXPECT_EQ(got.points, sent.points);
    EXPECT_EQ(got.cells, sent.cells);
    EXPECT_EQ(got.values, sent.values);
    EXPECT_EQ(got.width, 2u);
    message.pop_back();
    EXPECT_THROW(meansOf(message), std::runtime_error);
    std::vector<PointMeans> others{sent, piece({{1, 1, 1}}, {1}, {1})};
    EXPECT_THROW(uniteMeans(others), std::runtime_error);
}

}  // namespace
}  // namespace aeolic
