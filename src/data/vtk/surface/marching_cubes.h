#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "data/vector_field.h"

namespace aeolic {

/// What one layer of cells adds to an isosurface: the points on edges from its lower samples, and its triangles. These
/// count points from the first of the layer; those of the next layer follow.
struct CubeLayer {
    std::vector<glm::vec3> positions, normals;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint64_t> order;  ///< SurfaceMesh::order
};

/// How large an isosurface is.
struct IsosurfaceSize {
    std::uint64_t points = 0, triangles = 0;
    /// What extracting it takes: layers and the mesh that is made of them lie in memory together.
    std::uint64_t bytes() const
    {
        return 2 * (points * 2 * sizeof(glm::vec3) +
                    triangles * (sizeof(std::array<std::uint32_t, 3>) + sizeof(std::uint64_t)));
    }
};

/// Marching cubes over the layers of a grid's cells across z: what isosurface() is made of. Local.
class MarchingCubes {
public:
    /// `scalar` must outlive it. Positions are relative to `originWorld`.
    MarchingCubes(const GridField& scalar, const Brick& cells, double value, const glm::dvec3& originWorld);

    /// Layers [begin, end) of the cells, counted from their first. Any number of ranges at once.
    void extract(std::size_t begin, std::size_t end, std::vector<CubeLayer>& layers) const;

    /// How much extract() would find in these layers, and close() above the last one. Takes no memory for it.
    IsosurfaceSize count(std::size_t begin, std::size_t end) const;

    /// The points on the uppermost samples, which are below no layer.
    void close(CubeLayer& layer) const;

private:
    using Index = std::array<std::int64_t, 3>;  // A sample's place.

    /// A plane of samples: which of them are above the value, and the numbers of the points on the edges that begin
    /// there.
    struct Plane {
        std::vector<std::uint8_t> side;                  // [samples]
        std::array<std::vector<std::uint32_t>, 3> edge;  // [samples] per axis, where the edge crosses.
    };

    /// A point of the surface: on the edge that begins at a sample of the lower or upper plane.
    struct EdgePoint {
        bool above;
        std::size_t axis, sample;
    };

    double at(const Index& sample) const;
    std::size_t inPlane(std::int64_t x, std::int64_t y) const { return std::size_t(y * width_ + x); }
    Index global(std::int64_t x, std::int64_t y, std::int64_t z) const;
    template <class Visit>
    void forFlatEdges(const Plane& plane, const Visit& visit) const;
    template <class Visit>
    void forTriangles(std::int64_t k, const Plane& lower, const Plane& upper, const Visit& visit) const;
    void classify(std::int64_t k, Plane& plane) const;
    glm::dvec3 gradient(const Index& sample) const;
    void addPoint(const Index& from, int axis, CubeLayer& layer) const;
    void addFlatPoints(std::int64_t k, const Plane& plane, CubeLayer& layer) const;
    void addPoints(std::int64_t k, Plane& lower, const Plane& upper, CubeLayer& layer) const;
    void addTriangles(std::int64_t k, const Plane& lower, const Plane& upper, CubeLayer& layer) const;

    const GridField& scalar_;
    const Brick cells_;
    const double value_;
    const glm::dvec3 toLocal_;
    const GridIndex first_, held_;
    const std::int64_t width_, height_;  // Samples of a plane.
};

}  // namespace aeolic
