#include "aeolic/surface_spec.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <string_view>

#include "aeolic/error.h"
#include "base/text.h"
#include "description/builtin_names.h"
#include "description/option_rules.h"
#include "description/scene_surfaces.h"

namespace aeolic {

namespace {

constexpr std::string_view kSlice = "slice:", kIsosurface = "isosurface:", kBoundary = "boundary", kImage = "image";

/// Whether it reads as something that is cut out of the field.
bool isCutText(std::string_view text)
{
    return text.starts_with(kSlice) || text.starts_with(kIsosurface) || text == kBoundary || text == kImage;
}

[[noreturn]] void fail(const SurfaceSpec& spec, const std::string& found, const std::string& expected)
{
    throw InputError("surface '" + spec.text + "'", found, expected);
}

double parseFinite(std::string_view text, const SurfaceSpec& spec, const char* expected)
{
    const auto value = wholeTextAs<double>(text);
    if (!value || !std::isfinite(*value))
        fail(spec, text.empty() ? "a number is missing" : "found '" + std::string(text) + "'", expected);
    return *value;
}

Vec3 parsePoint(std::string_view text, const SurfaceSpec& spec, const char* expected)
{
    Vec3 point{};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t comma = text.find(',');
        if ((comma == std::string_view::npos) != (c == 2)) fail(spec, "found '" + std::string(text) + "'", expected);
        point[c] = parseFinite(text.substr(0, comma), spec, expected);
        text.remove_prefix(c == 2 ? text.size() : comma + 1);
    }
    return point;
}

void parseSlice(std::string_view text, SurfaceSpec& spec)
{
    const char* expected = "slice:OX,OY,OZ:NX,NY,NZ, a point of the plane and its normal";
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) fail(spec, "found one point only", expected);
    spec.origin = parsePoint(text.substr(0, colon), spec, expected);
    const Vec3 given = parsePoint(text.substr(colon + 1), spec, expected);
    const double largest = std::max({std::abs(given[0]), std::abs(given[1]), std::abs(given[2])});
    if (largest == 0) fail(spec, "the normal is 0,0,0", "a direction");
    // Scaled first: squares of 1e200 overflow.
    const glm::dvec3 unit = glm::normalize(glm::dvec3(given[0], given[1], given[2]) / largest);
    spec.normal = {unit.x, unit.y, unit.z};
}

void parseIsosurface(std::string_view text, SurfaceSpec& spec)
{
    const char* expected = "isosurface:ARRAY=VALUE or isosurface:ARRAY:mag=VALUE";
    const std::size_t equals = text.rfind('=');
    if (equals == std::string_view::npos || equals == 0) fail(spec, "no array or no value", expected);
    spec.array = text.substr(0, equals);
    spec.value = parseFinite(text.substr(equals + 1), spec, expected);
}

/// A number that is none stays in the text, for the surface's maker to refuse.
void parseBuiltin(std::string_view text, SurfaceSpec& spec)
{
    spec.name = nameInSpec(text);
    if (spec.name.size() < text.size()) spec.triangles = wholeTextAs<std::int64_t>(text.substr(spec.name.size() + 1));
}

/// The spec of a text that was made of what a program said. It has to say the same.
SurfaceSpec made(const std::string& text, SurfaceSpec::Kind kind, const std::string& name = {},
                 const std::vector<std::string>& parts = {})
{
    SurfaceSpec spec = parseSurfaceSpec(text);
    if (spec.kind != kind || (kind == SurfaceSpec::Kind::builtin && spec.name != name))
        fail(spec, "found '" + name + "'", fmt::format("one of {}", fmt::join(builtinSurfaceNames, ", ")));
    if (kind == SurfaceSpec::Kind::file && (spec.name != name || spec.parts != parts))
        fail(spec, "it reads as other parts or another file",
             "parts without commas and colons, of a file that is there");
    return spec;
}

}  // namespace

SurfaceSpec SurfaceSpec::builtin(const std::string& name, std::optional<std::int64_t> triangles)
{
    return made(triangles ? name + ":" + std::to_string(*triangles) : name, Kind::builtin, name);
}

SurfaceSpec SurfaceSpec::file(const std::string& path, const std::vector<std::string>& parts)
{
    std::string name = path;
    const auto isKnown = [&] { return isBuiltinSurface(name) || isCutText(name); };
    if (!path.empty() && isKnown()) name = "./" + path;  // A file may be called "teapot".
    return made(parts.empty() ? name : fmt::format("{}:{}", name, fmt::join(parts, ",")), Kind::file, name, parts);
}

SurfaceSpec SurfaceSpec::slice(const Vec3& origin, const Vec3& normal)
{
    return made(std::string(kSlice) + numbersText(origin) + ":" + numbersText(normal), Kind::slice);
}

SurfaceSpec SurfaceSpec::isosurface(const std::string& array, double value)
{
    return made(std::string(kIsosurface) + array + "=" + numberText(value), Kind::isosurface);
}

SurfaceSpec SurfaceSpec::boundary()
{
    return made(std::string(kBoundary), Kind::boundary);
}

SurfaceSpec SurfaceSpec::image()
{
    return made(std::string(kImage), Kind::image);
}

SurfaceSpec parseSurfaceSpec(const std::string& text)
{
    SurfaceSpec spec;
    spec.text = text;
    spec.name.clear();
    const std::string_view view = text;
    if (text.empty()) fail(spec, "nothing is named", "a file, a built-in surface or something cut out of the field");
    if (view.starts_with(kSlice)) {
        spec.kind = SurfaceSpec::Kind::slice;
        parseSlice(view.substr(kSlice.size()), spec);
    } else if (view.starts_with(kIsosurface)) {
        spec.kind = SurfaceSpec::Kind::isosurface;
        parseIsosurface(view.substr(kIsosurface.size()), spec);
    } else if (text == kBoundary) {
        spec.kind = SurfaceSpec::Kind::boundary;
    } else if (text == kImage) {
        spec.kind = SurfaceSpec::Kind::image;
    } else if (isBuiltinSurface(text)) {
        parseBuiltin(text, spec);
    } else {
        spec.kind = SurfaceSpec::Kind::file;
        FileAndParts split = splitParts(text);
        spec.name = std::move(split.file);
        spec.parts = std::move(split.parts);
    }
    return spec;
}

}  // namespace aeolic
