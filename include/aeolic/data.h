#pragma once

/// A scene's data in the caller's memory instead of in files. Nothing here owns memory: a view says where values are,
/// how many, of which type and how far apart.
///
/// How long the memory has to stay as it is: that of a Surface or a Volume while a Renderer is made, or while setData()
/// runs, and no longer, because the renderer keeps a copy in its own layout. That of a Grid's arrays until setData()
/// has given another grid, or until the renderer is gone, because the renderer samples them where they are (see Grid).
/// An `owner` in a view takes care of that.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace aeolic {

enum class ValueType { float32, float64, int32, uint32, int64, uint8 };

/// Tuples of numbers in memory, for instance points: the components of a tuple lie together, tuples at equal distances.
struct ArrayView {
    const void* data = nullptr;
    std::int64_t count = 0;  ///< Tuples.
    int components = 1;      ///< Of each tuple.
    ValueType type = ValueType::float32;
    std::int64_t strideBytes = 0;  ///< From one tuple to the next; 0: nothing is between them. Not negative.
    /// Is kept as long as the memory is needed. Null: the caller sees to that.
    std::shared_ptr<const void> owner;

    ArrayView() = default;
    template <class Value>
    ArrayView(const Value* values, std::int64_t tuples, int ofEach = 1, std::int64_t stride = 0)
        : data(values), count(tuples), components(ofEach), type(typeOf<Value>()), strideBytes(stride)
    {
    }

    template <class Value>
    static constexpr ValueType typeOf()
    {
        static_assert(std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>, "numbers of one of the ValueTypes");
        if (std::is_floating_point_v<Value>) return sizeof(Value) == 4 ? ValueType::float32 : ValueType::float64;
        if (sizeof(Value) == 1) return ValueType::uint8;
        if (sizeof(Value) == 8) return ValueType::int64;
        return std::is_signed_v<Value> ? ValueType::int32 : ValueType::uint32;
    }
};

/// An array as options name it (`vectors`, `colorBy`). Values that are not finite are masked, as in files.
struct NamedArray {
    std::string name;
    ArrayView values;
    bool activeVectors = false;  ///< Drawn where no option names others, on points rather than on cells. 3 components.
    bool activeNormals = false;  ///< Normals, of points or cells: not drawn unless an option names them. 3 components.
};

/// Triangles or polygons. What a file can hold a Surface can: vectors on points or on cells, a point array "Normals",
/// ghost flags in an array "vtkGhostType". Points that no cell uses are left out. Cells with a point that is not
/// finite are left out and counted. With several ranks each gives its own piece, perhaps an empty one; all pieces have
/// the same arrays. The surface is then that of all pieces, one after the other.
struct Surface {
    ArrayView points;     ///< [points][3], float or double, world units.
    ArrayView triangles;  ///< [triangles][3], indices from 0: int32, uint32 or int64. Or, instead of them, …
    ArrayView offsets, connectivity;  ///< … polygons: [polygons + 1] where in `connectivity` each begins, and the last
                                      ///< ends; the indices of their points. int32, uint32 or int64.
    std::vector<NamedArray> pointArrays, cellArrays;  ///< As many tuples as points, or as cells.
};

/// Samples on a uniform grid, x fastest: sample (x, y, z) is tuple (z * ny + y) * nx + x. With several ranks every rank
/// gives the same whole grid.
///
/// Vectors of three floats without gaps, all finite, that are kept as floats are sampled where they are, and so is a
/// scalar of floats to colour by. Doubles, other types, tuples with gaps, arrays with masked values, values on cells,
/// `FieldPrecision::float16` and resampling take a copy. The caller's memory is never written.
struct Grid {
    std::array<double, 3> origin{0, 0, 0};      ///< World position of sample (0, 0, 0).
    std::array<double, 3> spacing{1, 1, 1};     ///< World units between samples; positive.
    std::array<std::int64_t, 3> dims{0, 0, 0};  ///< Samples in x, y and z.
    std::vector<NamedArray> pointArrays;        ///< nx * ny * nz tuples each.
    std::vector<NamedArray> cellArrays;         ///< (nx - 1) * (ny - 1) * (nz - 1) tuples each.
};

/// Cells in space, as in a .vtu file: values are looked up in the cells as they are, and slices, isosurfaces and the
/// boundary are cut out of them. `types` are VTK's numbers: 10 tetrahedron, 11 voxel, 12 hexahedron, 13 wedge, 14
/// pyramid, 42 polyhedron, and all other linear and quadratic cells of VTK, whose curved sides count as straight ones.
/// Flat cells are left out, and so are cells with a corner that is not finite and those that "vtkGhostType" hides. With
/// several ranks every rank gives the same whole volume.
///
/// Or a structured grid, as in a .vts file: `dims` and as many points, x fastest. Or a rectilinear one, as in a .vtr
/// file: `dims` and `axes`. Both have neither types nor connectivity.
struct Volume {
    ArrayView points;                 ///< [points][3], float or double, world units.
    ArrayView types;                  ///< [cells], uint8, int32, uint32 or int64.
    ArrayView offsets, connectivity;  ///< [cells + 1] where in `connectivity` each begins, and the last ends; the
                                      ///< indices of their points. int32, uint32 or int64.
    /// Only for polyhedra, whole numbers: for each the number of its faces, and for each of these the number of its
    /// corners and the corners. [cells] where in `faces` each begins; other cells have -1.
    ArrayView faces, faceLocations;
    std::vector<NamedArray> pointArrays, cellArrays;  ///< As many tuples as points, or as cells.
    std::array<std::int64_t, 3> dims{0, 0, 0};        ///< Points in x, y and z of a structured or rectilinear grid.
    std::array<ArrayView, 3> axes;                    ///< [dims] each: coordinates along x, y and z, world units.

    bool isRectilinear() const { return axes[0].count != 0 || axes[1].count != 0 || axes[2].count != 0; }
    bool isStructured() const { return dims[0] != 0 || dims[1] != 0 || dims[2] != 0 || isRectilinear(); }
};

/// What of a scene is in memory. A surface here stands in the place of `SurfaceSource::spec`, a grid or a volume in
/// that of `FieldSource::spec`; slices, isosurfaces and boundaries can be cut out of either.
struct Data {
    std::optional<Surface> surface;
    std::optional<Grid> grid;
    std::optional<Volume> volume{};  ///< Or a grid.

    bool hasField() const { return grid.has_value() || volume.has_value(); }
};

}  // namespace aeolic
