#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "data/array_choice.h"
#include "data/surface_mesh.h"
#include "data/tally.h"
#include "data/vector_field.h"
#include "description/camera.h"

namespace aeolic {

/// Everything a frame reads that is not the camera or an option. Whoever loads it may move it to another moment between
/// frames (data/load/loaded_scene.h).
struct Scene {
    SurfaceMesh surface;
    std::shared_ptr<const GridField> field;        ///< Null: the surface carries its own vectors.
    std::shared_ptr<const GridField> scalarField;  ///< The scalar to colour by where it lives on the field's grid.
    bool colorByFieldMagnitude = false;            ///< Colour by the sampled vector's length: no scalar is stored.
    bool hasScalar = false;                        ///< There is something to colour by.
    std::array<double, 2> scalarRange{0, 1};       ///< Its values on the surface; finite, lo <= hi.
    bool scalarRangeKnown = false;                 ///< Some value was finite; else the range stays as above.
    std::string scalarName;                        ///< For the scalar bar, e.g. "p" or "|U|".
    double maxVector = 0;                          ///< Largest vector length: what `--normalize off` scales by.
    /// The surface's bounds. Where the scene changes in time, this, `fitRadius` and the ranges above belong to its
    /// first moment, so that nothing jumps.
    Bounds boundsWorld;
    double fitRadius = 0;         ///< The farthest its points are from the bounds' centre.
    SurfaceReach reach;           ///< Where the whole surface is at this moment.
    bool frontFacesOnly = false;  ///< Faces turned away from the viewer are not drawn.
    bool isImage = false;         ///< A plane that is looked at straight on, unless the camera says otherwise.
    bool inPieces = false;  ///< This rank holds a piece of the surface, perhaps an empty one, and of a field that is
                            ///< split what its piece needs.
    std::uint64_t allTriangles = 0;  ///< How many all pieces have together.

    /// This rank holds a part of the field.
    bool bricked() const { return field && field->brick; }
    /// What is coloured by is sampled where the vectors are.
    bool scalarFromField() const { return colorByFieldMagnitude || scalarField; }

    ArrayChoices surfaceArrays;  ///< What the surface's file has.
    ArrayChoices fieldArrays;    ///< What the field's file has; for a built-in flow its own name.

    std::vector<Tally> tallies;  ///< What is left out or changed in this rank's part, until finishScene() warns of it.
    std::vector<std::string> warnings;  ///< One line each: masked values, skipped triangles, no overlap …
};

/// What another moment has changed in a scene.
struct SceneChange {
    bool surface = false;    ///< Points, normals, or the surface's own arrays.
    bool triangles = false;  ///< Their connections or the number of points too.
    bool field = false;      ///< `field` and `scalarField`: their samples, perhaps in the same memory.
    bool any() const { return surface || field; }
};

}  // namespace aeolic
