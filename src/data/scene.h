#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"
#include "data/array_choice.h"
#include "data/surface_mesh.h"
#include "data/tally.h"
#include "data/vector_field.h"

namespace aeolic {

/// Everything a frame reads that is not the camera or an option: loaded once, then immutable.
struct Scene {
    SurfaceMesh surface;
    std::shared_ptr<const GridField> field;  ///< Null: the surface carries its own vectors.
    std::shared_ptr<const GridField>
        scalarField;                     ///< The scalar to colour by where it lives on the field's grid, else null.
    bool colorByFieldMagnitude = false;  ///< Colour by the sampled vector's length: no scalar is stored.
    bool hasScalar = false;              ///< Something to colour by exists.
    std::array<double, 2> scalarRange{0, 1};  ///< Of that something, over the surface; finite, lo <= hi.
    bool scalarRangeKnown = false;            ///< Some value was finite; else the range stays as above.
    std::string scalarName;                   ///< For the scalar bar, e.g. "p" or "|U|".
    double maxVector = 0;                     ///< Largest vector length: what `--normalize off` scales by.
    Bounds boundsWorld;    ///< Of the surface. This, the ranges above and the radius are those of the
                           ///< first moment where the scene changes in time, so that nothing jumps.
    double fitRadius = 0;  ///< The farthest its points are from the bounds' centre.
    bool bricked() const { return field && field->brick; }  ///< This rank holds but a part of the field.
    bool inPieces = false;           ///< This rank holds but a piece of the surface, perhaps an empty one, and of a
                                     ///< field that is split what its piece needs.
    std::uint64_t allTriangles = 0;  ///< Of all pieces.
    /// What is coloured by is sampled where the vectors are.
    bool scalarFromField() const { return colorByFieldMagnitude || scalarField; }

    ArrayChoices surfaceArrays;  ///< What the surface's file has …
    ArrayChoices fieldArrays;    ///< … and the field's; of a built-in flow its own name.

    std::vector<Tally> tallies;  ///< What is left out or changed: of this rank's part, until finishScene() warns of it.
    std::vector<std::string> warnings;  ///< One line each: masked values, skipped triangles, no overlap …
};

/// What of a scene another moment has changed.
struct SceneChange {
    bool surface = false;    ///< Points, normals, or the surface's own arrays.
    bool triangles = false;  ///< Their connections or the number of points too.
    bool field = false;      ///< `field` and `scalarField`: their samples, perhaps in the same memory.
    bool any() const { return surface || field; }
};

/// The moment a description begins with; `times`: those there are.
double startOf(const SceneDescription& description, const std::vector<double>& times);

/// The moment of frame `index` of `frames` over a range in time: a share of the way that is 0 and 1 at its ends,
/// exactly.
double momentOfFrame(const std::array<double, 2>& range, int index, int frames);

/// Reads or builds what `description` names, at its moment. Reports progress (0 to 1, with what is being done) if
/// asked. Throws InputError with one line for anything wrong in the user's files or options.
using Progress = void (*)(const char* what, double fraction, void* context);
Scene loadScene(const SceneDescription& description, Progress progress = nullptr, void* context = nullptr);

/// The same, holding only `part` of the field where that is split: its brick (data/bricks.h), and of an isosurface the
/// piece in its cells. Largest vector, scalar range, bounds, radius and tallies are then of that part, and
/// finishScene() is left to be called once those of all parts are known.
Scene loadPart(const SceneDescription& description, const FieldPart& part, Progress progress = nullptr,
               void* context = nullptr);

/// Warns of what only the whole scene tells: what was left out of it, that nothing flows, that nothing can be coloured.
void finishScene(Scene& scene);

/// Bytes that the whole field takes in memory, from its file's header; 0 where the surface carries its own vectors and
/// where it cannot be told before reading. Throws InputError like loadScene().
std::uint64_t fieldBytesOf(const SceneDescription& description);

/// Bytes of the files that a surface is read from where it can be split into pieces: of a .pvtp of several, or of the
/// steps of such that are in memory together; else 0. Throws InputError like loadScene().
std::uint64_t pieceFileBytesOf(const SceneDescription& description);

}  // namespace aeolic
