#pragma once

/// The contents of the sample files (data/vtk/testing/sample_files.h) as arrays of this process.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "aeolic/data.h"
#include "data/vtk/testing/sample_files.h"

namespace aeolic::testkit {

/// What writeSheetFile() writes of n x n quads, from row `firstRow` of them to before row `endRow`.
struct MemorySheet {
    explicit MemorySheet(int n, double twist = 0, int firstRow = 0, int endRow = -1)
    {
        const int end = endRow < 0 ? n : endRow;
        for (int j = firstRow; j <= end; ++j)
            for (int i = 0; i <= n; ++i) {
                const double x = double(i) / n, y = double(j) / n;
                for (const double c : {x, y, 0.1 * x + twist * x * y}) points.push_back(float(c));
                for (const double c : {1.0, x, 0.1}) tau.push_back(float(c));
                q.push_back(float(x + y));
            }
        offsets.push_back(0);
        for (int j = firstRow; j < end; ++j)
            for (int i = 0; i < n; ++i) {
                const std::int64_t a = (j - firstRow) * (n + 1) + i;
                for (const std::int64_t corner : {a, a + 1, a + n + 2, a + n + 1}) corners.push_back(corner);
                offsets.push_back(std::int64_t(corners.size()));
                for (const float c : {2.0F, 0.0F, 0.2F}) cellTau.push_back(c);
                cellQ.push_back(double(j * n + i));
            }
    }

    Surface surface() const
    {
        const auto points3 = std::int64_t(points.size() / 3), cells = std::int64_t(offsets.size()) - 1;
        Surface s;
        s.points = ArrayView(points.data(), points3, 3);
        s.offsets = ArrayView(offsets.data(), cells + 1);
        s.connectivity = ArrayView(corners.data(), std::int64_t(corners.size()));
        s.pointArrays = {{"tau", ArrayView(tau.data(), points3, 3)}, {"q", ArrayView(q.data(), points3)}};
        s.cellArrays = {{"cellTau", ArrayView(cellTau.data(), cells, 3)}, {"cellQ", ArrayView(cellQ.data(), cells)}};
        return s;
    }

    std::vector<float> points, tau, q, cellTau;
    std::vector<double> cellQ;
    std::vector<std::int64_t> offsets, corners;
};

/// What writeGridFile() writes.
struct MemoryGrid {
    explicit MemoryGrid(const test::GridSample& s = {}) : sample(s)
    {
        for (int z = 0; z < s.dims[2]; ++z)
            for (int y = 0; y < s.dims[1]; ++y)
                for (int x = 0; x < s.dims[0]; ++x) {
                    const auto at = [&](std::size_t c, int i) { return s.origin[c] + i * s.spacing[c]; };
                    for (const double c : test::sampleVector(at(0, x), at(1, y), at(2, z)))
                        u.push_back(float(s.scale * c));
                    p.push_back(float(s.scale * test::sampleScalar(at(0, x), at(1, y), at(2, z))));
                }
    }

    Grid grid() const
    {
        Grid g;
        g.origin = sample.origin;
        g.spacing = sample.spacing;
        g.dims = {sample.dims[0], sample.dims[1], sample.dims[2]};
        const auto count = std::int64_t(p.size());
        g.pointArrays = {{"U", ArrayView(u.data(), count, 3)}, {"p", ArrayView(p.data(), count)}};
        return g;
    }

    test::GridSample sample;
    std::vector<float> u, p;
};

/// Cells of several kinds in a box, of a tetrahedron's to a polyhedron's, with U and p of the sample files on their
/// points, and cellU and cellP, at their centres, on themselves.
struct MemoryVolume {
    /// `stretch`: x is more by so much of its square, so that nothing is uniform.
    explicit MemoryVolume(double stretch = 0.1, double scale = 1);

    Volume volume() const;
    void write(const std::string& path) const;  ///< A .vtu of the same.

    std::vector<float> points, u, p, cellU;
    std::vector<double> cellP;
    std::vector<std::uint8_t> types;
    std::vector<std::int64_t> offsets{0}, corners, faces, faceLocations;

private:
    void addCell(std::uint8_t type, const std::vector<std::int64_t>& ids, double scale);
};

}  // namespace aeolic::testkit
