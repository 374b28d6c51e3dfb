#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"

namespace aeolic {

/// What a surface is, in parts: typed, where `SurfaceSource::spec`, `SurfaceItem::spec` and `--surface` are a text. The
/// functions below make one for each kind, and `text` is what a description takes:
///
///     scene.surface.spec = aeolic::SurfaceSpec::slice({0, 0, 0.5}, {0, 0, 1}).text;
///
/// parseSurfaceSpec() makes one of a text. What `kind` does not need is empty.
struct SurfaceSpec {
    enum class Kind { builtin, file, slice, isosurface, boundary, image };

    /// One of Aeolic's own: teapot, sphere, torus, plane or wave, perhaps with a number of triangles that it is to have
    /// at least, which its maker judges.
    static SurfaceSpec builtin(const std::string& name, std::optional<std::int64_t> triangles = std::nullopt);
    /// A file or a series of files in time. `parts`: names, groups or patterns with *, without commas and colons, of a
    /// file that has parts; none: all of them, of an OpenFOAM case all walls.
    static SurfaceSpec file(const std::string& path, const std::vector<std::string>& parts = {});
    /// The plane through `origin`, world coordinates, cut out of the field's data set. `normal`: of any length but 0.
    static SurfaceSpec slice(const Vec3& origin, const Vec3& normal);
    /// Where the field's data set has `value` in its scalar array `array`, or, as "NAME:mag", vectors of that length.
    static SurfaceSpec isosurface(const std::string& array, double value);
    static SurfaceSpec boundary();  ///< The outside of the field's data set.
    static SurfaceSpec image();     ///< A field of one layer as it is, each sample a pixel or more.

    Kind kind = Kind::builtin;
    std::string text = "teapot";            ///< The whole, as `spec` takes it. As it was typed where it was parsed.
    std::string name = "teapot";            ///< Of a built-in; of a file its path, without the parts.
    std::optional<std::int64_t> triangles;  ///< Of a built-in. Not set: as many as it has by itself.
    std::vector<std::string> parts;         ///< Of a file.
    Vec3 origin{0, 0, 0};                   ///< Of a slice: a point of the plane, world coordinates.
    Vec3 normal{0, 0, 1};                   ///< Of a slice: of unit length.
    std::string array;                      ///< Of an isosurface: NAME or NAME:mag.
    double value = 0;                       ///< Of an isosurface: the value on it, in the array's unit.

    /// Whether it is cut out of the field's own data set.
    bool isCut() const { return kind != Kind::builtin && kind != Kind::file; }
};

/// The parts of a text. What is not known by name is a file. A colon belongs to a file's name where such a file is
/// there: the file system is asked. Throws InputError for a malformed slice or isosurface, for a file with a colon that
/// no part follows, and for an empty text. The functions that make a spec throw the same for what no text could say,
/// such as numbers that are not finite, an unknown built-in, or a part with a comma.
SurfaceSpec parseSurfaceSpec(const std::string& text);

}  // namespace aeolic
