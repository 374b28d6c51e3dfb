#include "description/surface_spec.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "aeolic/error.h"
#include "description/builtin_names.h"

namespace aeolic {

namespace {

[[noreturn]] void fail(const SurfaceSpec& spec, const std::string& found, const std::string& expected)
{
    throw InputError("surface '" + spec.text + "'", found, expected);
}

double parseFinite(std::string_view text, const SurfaceSpec& spec, const char* expected)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        fail(spec, text.empty() ? "a number is missing" : "found '" + std::string(text) + "'", expected);
    return value;
}

glm::dvec3 parsePoint(std::string_view text, const SurfaceSpec& spec, const char* expected)
{
    glm::dvec3 point;
    for (int c = 0; c < 3; ++c) {
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
    spec.originWorld = parsePoint(text.substr(0, colon), spec, expected);
    spec.normal = parsePoint(text.substr(colon + 1), spec, expected);
    const double largest = std::max({std::abs(spec.normal.x), std::abs(spec.normal.y), std::abs(spec.normal.z)});
    if (largest == 0) fail(spec, "the normal is 0,0,0", "a direction");
    spec.normal = glm::normalize(spec.normal / largest);  // Scaled first: squares of 1e200 overflow.
}

void parseIsosurface(std::string_view text, SurfaceSpec& spec)
{
    const char* expected = "isosurface:ARRAY=VALUE or isosurface:ARRAY:mag=VALUE";
    const std::size_t equals = text.rfind('=');
    if (equals == std::string_view::npos || equals == 0) fail(spec, "no array or no value", expected);
    spec.array = text.substr(0, equals);
    spec.value = parseFinite(text.substr(equals + 1), spec, expected);
}

}  // namespace

SurfaceSpec parseSurfaceSpec(const std::string& text)
{
    SurfaceSpec spec;
    spec.text = text;
    const std::string_view view = text;
    if (text.empty()) fail(spec, "nothing is named", "a file, a built-in surface or something cut out of the field");
    if (view.starts_with("slice:")) {
        spec.kind = SurfaceSpec::Kind::slice;
        parseSlice(view.substr(6), spec);
    } else if (view.starts_with("isosurface:")) {
        spec.kind = SurfaceSpec::Kind::isosurface;
        parseIsosurface(view.substr(11), spec);
    } else if (text == "boundary") {
        spec.kind = SurfaceSpec::Kind::boundary;
    } else if (text == "image") {
        spec.kind = SurfaceSpec::Kind::image;
    } else {
        spec.kind = isBuiltinSurface(text) ? SurfaceSpec::Kind::builtin : SurfaceSpec::Kind::file;
    }
    return spec;
}

std::vector<SurfaceItem> surfacesOf(const SceneDescription& scene)
{
    if (!scene.surfaces.empty()) return scene.surfaces;
    SurfaceItem only;
    only.spec = scene.surface.spec;
    return {only};
}

std::string surfacesText(const SceneDescription& scene)
{
    std::string text;
    for (const SurfaceItem& item : surfacesOf(scene)) text += (text.empty() ? "" : ", ") + item.spec;
    return text;
}

}  // namespace aeolic
