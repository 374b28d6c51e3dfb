#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "memory_scenes_testing.h"

/// Structured and rectilinear grids in the caller's memory draw what their hexahedra draw. What is blanked in them is
/// compared with files in tests/python/vtk_files_test.py.
namespace aeolic {
namespace {

using namespace testkit;

/// 5 x 4 x 3 points on three axes.
struct Samples {
    std::vector<double> x{0, 0.4, 1, 1.5, 2.2}, y{0, 0.7, 1.1, 2}, z{0, 0.5, 1.3};
    std::vector<double> points;
    std::vector<float> u, other;
    std::vector<std::int64_t> offsets{0}, corners;
    std::vector<std::uint8_t> types;

    Samples()
    {
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t i = 0; i < 5; ++i) {
                    points.insert(points.end(), {x[i], y[j], z[k]});
                    u.insert(u.end(), {float(1 + y[j]), float(x[i]), float(z[k])});
                    other.insert(other.end(), {1, -1, 0.5F});
                    if (i < 4 && j < 3 && k < 2) addCell(std::int64_t(20 * k + 5 * j + i));
                }
    }
    void addCell(std::int64_t first)
    {
        for (const std::int64_t step : {0, 1, 6, 5, 20, 21, 26, 25}) corners.push_back(first + step);
        offsets.push_back(std::int64_t(corners.size()));
        types.push_back(12);
    }
    Volume of() const
    {
        Volume volume;
        volume.pointArrays = {{"U", {u.data(), 60, 3}}};
        return volume;
    }
    Volume hexahedra() const
    {
        Volume volume = of();
        volume.points = {points.data(), 60, 3};
        volume.types = {types.data(), 24};
        volume.offsets = {offsets.data(), 25};
        volume.connectivity = {corners.data(), 8 * 24};
        return volume;
    }
    Volume structured() const
    {
        Volume volume = of();
        volume.points = {points.data(), 60, 3};
        volume.dims = {5, 4, 3};
        return volume;
    }
    Volume rectilinear() const
    {
        Volume volume = of();
        volume.axes = {ArrayView(x.data(), 5), ArrayView(y.data(), 4), ArrayView(z.data(), 3)};
        volume.dims = {5, 4, 3};
        return volume;
    }
};

class MemoryStructuredTest : public MemoryTest {
protected:
    MemoryStructuredTest() { scene_.surface.spec = "boundary"; }

    Samples samples_;
};

TEST_F(MemoryStructuredTest, DrawsWhatItsHexahedraDraw)
{
    for (const char* surface : {"boundary", "sphere"}) {
        scene_.surface.spec = surface;
        const Picture expected = ofMemory(scene_, dataOf(samples_.hexahedra()));
        EXPECT_EQ(ofMemory(scene_, dataOf(samples_.structured())).pixels, expected.pixels) << surface;
        EXPECT_EQ(ofMemory(scene_, dataOf(samples_.rectilinear())).pixels, expected.pixels) << surface;
    }
}

TEST_F(MemoryStructuredTest, ItsMemoryIsNotKept)
{
    for (const Volume& volume : {samples_.structured(), samples_.rectilinear()}) {
        Samples own;
        Volume mine = volume.isRectilinear() ? own.rectilinear() : own.structured();
        Renderer renderer(scene_, dataOf(mine));
        const Picture before = renderer.render({scene_.camera});
        for (std::vector<double>* values : {&own.points, &own.x, &own.y, &own.z})
            std::fill(values->begin(), values->end(), double(kNan));
        std::fill(own.u.begin(), own.u.end(), kNan);
        EXPECT_EQ(renderer.render({scene_.camera}).pixels, before.pixels);
        renderer.setData(dataOf(volume));
        EXPECT_EQ(renderer.render({scene_.camera}).pixels, before.pixels);
    }
}

TEST_F(MemoryStructuredTest, WhatDoesNotFitIsNamed)
{
    const auto complaintOf = [&](Volume volume, const auto& change) {
        change(volume);
        return complaint(dataOf(volume));
    };
    EXPECT_EQ(complaintOf(samples_.structured(),
                          [](Volume& v) {
                              v.dims = {5, 4, 4};
                          }),
              "volume in memory: 60 points; expected 80, which are 5 x 4 x 4");
    EXPECT_EQ(complaintOf(samples_.rectilinear(),
                          [](Volume& v) {
                              v.dims = {5, 3, 3};
                          }),
              "volume in memory: coordinates along y: 4 values; expected 3, for 5 x 3 x 3 points");
    EXPECT_EQ(complaintOf(samples_.structured(),
                          [](Volume& v) {
                              v.dims = {-5, -4, 3};
                          }),
              "volume in memory: -5 x -4 x 3 points; expected how many there are in x, y and z");
    EXPECT_EQ(complaintOf(samples_.hexahedra(),
                          [](Volume& v) {
                              v.dims = {5, 4, 3};
                          }),
              "volume in memory: dims together with cells; expected one or the other");
    EXPECT_EQ(complaintOf(samples_.structured(), [&](Volume& v) { v.axes = samples_.rectilinear().axes; }),
              "volume in memory: axes together with points; expected one or the other");
}

TEST_F(MemoryStructuredTest, ActiveVectorsAreDrawn)
{
    Volume volume = samples_.structured();
    volume.pointArrays.push_back({"other", {samples_.other.data(), 60, 3}});
    EXPECT_NE(complaint(dataOf(volume)).find("several arrays of vectors and none is active"), std::string::npos);
    const Picture expected = ofMemory(scene_, dataOf(samples_.structured()));
    volume.pointArrays.front().activeVectors = true;
    EXPECT_EQ(ofMemory(scene_, dataOf(volume)).pixels, expected.pixels);
    volume.pointArrays.front().activeVectors = false;
    volume.pointArrays.back().activeNormals = true;
    EXPECT_EQ(ofMemory(scene_, dataOf(volume)).pixels, expected.pixels) << "normals are no vectors";
    volume.pointArrays.back().values.components = 1;
    EXPECT_EQ(complaint(dataOf(volume)), "volume in memory: array 'other': 1 components; expected 3");
}

}  // namespace
}  // namespace aeolic
