#pragma once

#include <glm/glm.hpp>

#include <string>
#include <vector>

#include "aeolic/scene_description.h"

namespace aeolic {

/// The parts of a `SurfaceSource::spec`.
struct SurfaceSpec {
    enum class Kind { builtin, file, slice, isosurface, boundary, image };

    Kind kind = Kind::builtin;
    std::string text;            ///< The whole spec as the user wrote it, for messages.
    glm::dvec3 originWorld{0};   ///< For a slice: a point of the plane.
    glm::dvec3 normal{0, 0, 1};  ///< For a slice: the plane's normal, of unit length.
    std::string array;           ///< For an isosurface: NAME or NAME:mag.
    double value = 0;            ///< For an isosurface: the value on it.

    /// Whether it is cut out of the field's own data set.
    bool isCut() const { return kind != Kind::builtin && kind != Kind::file; }
};

/// Throws InputError for a malformed slice or isosurface, or an empty text. What is not known by name is a file.
SurfaceSpec parseSurfaceSpec(const std::string& spec);

/// The surfaces of a picture: those that the scene lists, or its only one.
std::vector<SurfaceItem> surfacesOf(const SceneDescription& scene);

/// What a surface of the scene is coloured by, as the user wrote it; empty: nothing.
inline const std::string& colorByOf(const SurfaceItem& item, const SceneDescription& scene)
{
    return item.colorBy ? *item.colorBy : scene.shading.colorBy;
}

/// What messages call a scene's surfaces: the specs, with commas between them.
std::string surfacesText(const SceneDescription& scene);

}  // namespace aeolic
