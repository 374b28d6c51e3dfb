#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "data/array_choice.h"
#include "data/mesh/surface_mesh.h"
#include "data/tally.h"
#include "data/vector_field.h"
#include "description/camera.h"
#include "description/color_by.h"

namespace aeolic {

/// One of several surfaces in a scene.
struct SceneSurface {
    static constexpr int kPlain = -1;

    std::string name;     ///< As the user wrote it.
    bool streaks = true;  ///< false: no streaks show on it, and no trace enters it.
    int colors = kPlain;  ///< Which of the scene's colours it has; kPlain: it is a plain surface.
    bool shown = true;    ///< Its triangles are in the mesh.
    /// Its vectors, its scalar are values of its own points, though other surfaces are sampled in the scene's field.
    bool ownVectors = false, ownScalar = false;
    /// Where the whole of it is at the first moment; the radius is about its own bounds' centre.
    SurfaceReach fit = {};
};

/// What some of several surfaces are coloured by. What is empty is as the shading options say.
struct SceneColors {
    static constexpr std::size_t kMost = 7;  ///< In a scene.

    std::string name;                         ///< The array's, for the legend.
    std::array<double, 2> range{0, 1};        ///< Its values on these surfaces; finite, lo <= hi.
    std::array<double, 2> robustRange{0, 1};  ///< As Scene::robustRange, around those of the surfaces.
    bool rangeKnown = false;                  ///< Some value was finite; otherwise both ranges are 0 to 1.

    const std::array<double, 2>& rangeFor(const ShadingOptions& shading) const
    {
        return shading.colorRangeOf == RangeOf::robust ? robustRange : range;
    }
    std::optional<std::array<double, 2>> shownRange;
    std::optional<std::string> colorMap, legend;
};

/// What is measured of a scene.
struct SceneRanges {
    std::array<double, 2> scalarRange{0, 1};  ///< The values to colour by on the surface; finite, lo <= hi.
    /// From the 2nd to the 98th percentile of these values by area; scalarRange where that has no width.
    std::array<double, 2> robustRange{0, 1};
    bool scalarRangeKnown = false;  ///< Some value was finite; else the ranges stay as above.
    double maxVector = 0;           ///< Largest vector length: what `--normalize off` scales by.
    double maxTangential = 0;       ///< Largest part of them along the surface; 0: not known, or nothing lies in it.
};

/// Everything a frame reads that is not the camera or an option. Whoever loads it may move it to another moment between
/// frames (data/load/loaded_scene.h).
struct Scene : SceneRanges {
    SurfaceMesh surface;
    std::shared_ptr<const GridField> field;        ///< Null: the surface carries its own vectors.
    std::shared_ptr<const GridField> scalarField;  ///< The scalar to colour by where it lives on the field's grid.
    /// Coloured by this part of the vectors at each pixel: no scalar is stored. Of `field` their length, of any vectors
    /// what needs the normal. The whole: coloured by a scalar.
    ArrayPart ofVectors = ArrayPart::whole;
    bool hasScalar = false;  ///< There is something to colour by.
    std::string scalarName;  ///< For the scalar bar, e.g. "p" or "|U|".
    /// The first moment, where nothing flows then and something does later.
    std::optional<double> restsAt;
    std::string vectorsName;  ///< The array's that streaks follow; empty: they follow several.
    /// A surface's own vectors are known to point against the flow that made them.
    struct AgainstFlow {
        std::string surface, array;
    };
    std::optional<AgainstFlow> againstFlow;
    /// The surface's bounds. Where the scene changes in time, this, `fitRadius` and the ranges above belong to its
    /// first moment, so that nothing jumps.
    Bounds boundsWorld;
    double fitRadius = 0;         ///< The farthest its points are from the bounds' centre.
    SurfaceReach reach;           ///< Where the whole surface is at this moment.
    bool frontFacesOnly = false;  ///< Faces turned away from the viewer are not drawn.
    bool isImage = false;         ///< A plane that is looked at straight on, unless the camera says otherwise.
    std::optional<glm::dvec3> planeNormal;  ///< Of a slice alone: how the plane lies that it is cut along.
    bool inPieces = false;  ///< This rank holds a piece of the surface, perhaps an empty one, and of a field that is
                            ///< split what its piece needs.
    std::uint64_t allTriangles = 0;  ///< How many all pieces have together.

    /// What the colours go by where no range was given.
    const std::array<double, 2>& rangeFor(const ShadingOptions& shading) const
    {
        return shading.colorRangeOf == RangeOf::robust ? robustRange : scalarRange;
    }
    /// The vectors along the surface at which streaks show in full. Where nothing lies in it but rounding, all
    /// vectors'.
    double fullStreaks() const { return maxTangential > 1e-6 * maxVector ? maxTangential : maxVector; }
    /// This rank holds a part of the field.
    bool bricked() const { return field && field->brick; }
    /// What a camera is fitted to: the surfaces that are shown, at the first moment. Where none is, all of them.
    SurfaceReach fit() const;
    /// What is coloured by is sampled where the vectors are.
    bool scalarFromField() const { return (field && ofVectors != ArrayPart::whole) || scalarField; }
    /// Some surfaces carry what others are sampled for.
    bool mixed() const
    {
        return std::any_of(surfaces.begin(), surfaces.end(),
                           [](const SceneSurface& s) { return s.ownVectors || s.ownScalar; });
    }

    /// Several surfaces: SurfaceMesh::surfaceOf counts these. Empty: only one, with streaks and the colours above.
    std::vector<SceneSurface> surfaces;
    std::vector<SceneColors> colors;  ///< What they are coloured by. The first is what the names above tell.

    ArrayChoices surfaceArrays;  ///< What the surface's file has.
    ArrayChoices fieldArrays;    ///< What the field's file has; for a built-in flow its own name.
    std::string fieldFile;       ///< That has the field's first step, from any folder; empty: it is built in
                                 ///< or in memory.

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
