#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"
#include "aeolic/surface_spec.h"

namespace aeolic {

/// A place or a direction of the public interface, to reckon with.
inline glm::dvec3 vectorOf(const Vec3& v)
{
    return {v[0], v[1], v[2]};
}

/// A file, and which of its parts are wanted.
struct FileAndParts {
    std::string file;
    std::vector<std::string> parts;  ///< Names, groups and patterns with *; empty: the usual ones.
};

/// "CASE:PART,PART" in two. A colon belongs to the file's name where such a file is there, or nothing stands before it.
/// Behind a file that is there colons belong to the names of parts.
FileAndParts splitParts(const std::string& spec);

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
