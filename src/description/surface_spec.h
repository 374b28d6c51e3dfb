#pragma once

#include <glm/glm.hpp>

#include <string>

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

}  // namespace aeolic
