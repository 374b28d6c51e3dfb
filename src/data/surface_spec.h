#pragma once

#include <glm/glm.hpp>

#include <string>

namespace aeolic {

/// `SurfaceSource::spec`, taken apart.
struct SurfaceSpec {
    enum class Kind { builtin, file, slice, isosurface, boundary };

    Kind kind = Kind::builtin;
    std::string text;            ///< As the user wrote it: the file's name, the built-in's, for messages.
    glm::dvec3 originWorld{0};   ///< Of a slice: a point of the plane.
    glm::dvec3 normal{0, 0, 1};  ///< Of a slice: unit length.
    std::string array;           ///< Of an isosurface: NAME or NAME:mag.
    double value = 0;            ///< Of an isosurface.

    /// Whether it is cut out of the field's own data set.
    bool isCut() const { return kind != Kind::builtin && kind != Kind::file; }
};

/// Throws InputError for a malformed slice or isosurface, or an empty text. What is not known by name is a file.
SurfaceSpec parseSurfaceSpec(const std::string& spec);

}  // namespace aeolic
