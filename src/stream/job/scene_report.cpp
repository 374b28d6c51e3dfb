#include "stream/job/scene_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>

#include "aeolic/error.h"
#include "data/builtin/flows.h"
#include "data/load/scene_sources.h"
#include "data/load/series/time_series.h"
#include "data/reading/file_questions.h"
#include "data/scene.h"
#include "data/surface_range.h"
#include "description/camera.h"
#include "description/color_by.h"
#include "description/colormap.h"
#include "description/scene_json.h"
#include "description/scene_surfaces.h"
#include "description/vectors_text.h"
#include "engine/renderer_internals.h"
#include "engine/scene_view.h"

namespace aeolic::stream {
namespace {

Json numbers(const glm::dvec3& v)
{
    return Json::array({v.x, v.y, v.z});
}

void addNew(Json& list, const std::string& name)
{
    if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
}

// A field is read once more for its ranges only if nobody feels it.
constexpr std::uintmax_t kLargestToSummarize = std::uintmax_t{256} << 20;

/// What a field's file tells beside its values. Empty where it is not known.
struct FileFacts {
    std::map<std::string, std::array<double, 2>> ranges;  ///< Of arrays, by their names.
    Bounds boundsWorld;
};

FileFacts factsIn(const std::string& file)
{
    FileFacts facts;
    std::error_code unreadable;
    const auto bytes = std::filesystem::file_size(file, unreadable);
    if (unreadable || bytes > kLargestToSummarize) return facts;
    const FileSummary summary = summarizeFile(file);
    facts.boundsWorld = summary.boundsWorld;
    for (const ArraySummary& array : summary.arrays)
        if (array.range) facts.ranges[array.name] = *array.range;
    return facts;
}

FileFacts factsOf(const std::string& file)
{
    static std::mutex mutex;  // A program may show several scenes, each on a thread of its own.
    static std::map<std::string, FileFacts> known;
    const std::lock_guard lock(mutex);
    const auto [entry, isNew] = known.try_emplace(file);
    if (!isNew) return entry->second;
    try {
        entry->second = factsIn(file);
    } catch (const InputError&) {  // The step that is shown may be another one, which is whole.
    }
    return entry->second;
}

/// The name of an array's values; of vectors that of their lengths, NAME:mag.
std::string valuesName(const ArrayChoice& array)
{
    return array.components == 1 ? array.name : array.name + ":mag";
}

/// Name (or NAME:mag) and range of what isosurfaces can be cut at.
Json isosurfaceChoices(const FileFacts& file, const ArrayChoices& arrays)
{
    Json choices = Json::array();
    for (const ArrayChoice& array : arrays) {
        Json choice{{"array", valuesName(array)}};
        if (const auto range = file.ranges.find(array.name); range != file.ranges.end())
            choice["range"] = range->second;
        choices.push_back(choice);
    }
    return choices;
}

/// Some surface has arrays of its own.
bool ownsArrays(const SceneDescription& description)
{
    const std::vector<SurfaceItem> items = surfacesOf(description);
    return std::any_of(items.begin(), items.end(), [](const SurfaceItem& item) {
        return parseSurfaceSpec(item.spec).kind == SurfaceSpec::Kind::file;
    });
}

/// What a viewer may choose from.
Json choices(const Renderer& renderer)
{
    const Scene& scene = RendererInternals::scene(renderer);
    const SceneDescription& description = renderer.description();
    const bool fieldFile = !description.field.spec.empty() && !isBuiltinFlow(description.field.spec);
    Json vectors = Json::array(), colorBy = Json::array(), isosurface = Json::array();
    const ArrayChoices& vectorArrays = description.field.spec.empty() ? scene.surfaceArrays : scene.fieldArrays;
    const std::string shown = parseSurfaceVectors(scene.vectorsName).name;
    for (const ArrayChoice& array : vectorArrays) {
        if (array.components != 3) continue;
        addNew(vectors, array.name);
        if (description.field.spec.empty() && array.name == shown) addNew(vectors, reversedName(shown));
    }
    if (!description.field.vectors.empty()) addNew(vectors, description.field.vectors);  // wallShear(NAME), too.
    const bool ofField = !description.field.spec.empty();                                // What the streaks follow.
    const auto addParts = [&](const std::string& prefix, const ArrayChoice& array, bool withNormal) {
        addNew(colorBy, prefix + valuesName(array));
        if (array.components != 3) return;
        for (const ArrayPart part : {ArrayPart::x, ArrayPart::y, ArrayPart::z})
            addNew(colorBy, prefix + array.name + std::string(suffixOf(part)));
        if (!withNormal || array.name != shown) return;
        for (const ArrayPart part : {ArrayPart::normal, ArrayPart::tangential})
            addNew(colorBy, prefix + array.name + std::string(suffixOf(part)));
    };
    for (const ArrayChoice& array : scene.fieldArrays) addParts("", array, ofField);
    const Json known = colorBy;
    for (const ArrayChoice& array : scene.surfaceArrays) {
        const bool both = std::find(known.begin(), known.end(), Json(valuesName(array))) != known.end();
        const bool own = ownsArrays(description);
        if (!both || own) addParts(both ? std::string(ColorBy::kSurfacePrefix) : "", array, !ofField);
    }
    Json surfaces = Json::array({"original"});
    Bounds box;  // Of the field: cuts can be anywhere in it.
    if (fieldFile) {
        const FileFacts file = factsOf(scene.fieldFile);
        for (const char* cut : {"slice", "isosurface", "boundary"}) surfaces.push_back(cut);
        isosurface = isosurfaceChoices(file, scene.fieldArrays);
        box = file.boundsWorld;
    }
    if (scene.field && !scene.bricked()) box = boundsOf(*scene.field);
    Json result{{"surfaces", surfaces},         {"vectors", vectors},       {"colorBy", colorBy},
                {"colorMaps", colorMapNames()}, {"isosurface", isosurface}, {"times", renderer.info().times}};
    if (!box.empty()) result["bounds"] = Json::array({numbers(box.lo), numbers(box.hi)});
    return result;
}

/// The options that a View may hold, with their ranges. All viewers share the array to colour by, so it is left out. A
/// colour map's file of the scene is one of the names that a viewer may choose.
Json viewOptions(const SceneDescription& description)
{
    Json options = optionsDocument({"camera", "lic", "shading"});
    options["shading"].erase("colorBy");
    const std::string& map = description.shading.colormap;
    if (isColorMapFile(map)) addNew(options["shading"]["colormap"]["names"], map);
    return options;
}

std::string hexText(const Color& color)
{
    return fmt::format("{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

/// Nine colours of a colour map out of a file, from the low end to the high one, RRGGBB: the page knows the others.
Json colorStops(const ColorMap& map)
{
    Json stops = Json::array();
    for (int i = 0; i < 9; ++i) stops.push_back(hexText(map.colors[std::size_t((i * 255 + 4) / 8)]));
    return stops;
}

/// The colours that the map's file has for values outside of the range, as the options that would set them.
Json colorsOutside(const ColorMap& map)
{
    Json colors = Json::object();
    if (map.nan) colors["nanColor"] = hexText(*map.nan);
    if (map.below) colors["belowColor"] = hexText(*map.below);
    if (map.above) colors["aboveColor"] = hexText(*map.above);
    return colors;
}

}  // namespace

Json placeReport(const PickedPlace& place)
{
    const auto orNull = [](const auto& some) { return some ? Json(*some) : Json(); };
    return {{"position", place.position},     {"depth", place.depth},
            {"normal", place.normal},         {"triangle", place.triangle},
            {"surface", place.surface},       {"vectorName", place.vectorName},
            {"vector", orNull(place.vector)}, {"tangential", orNull(place.tangential)},
            {"scalarName", place.scalarName}, {"scalar", orNull(place.scalar)}};
}

SceneDescription sceneShown(const Renderer& renderer)
{
    SceneDescription scene = renderer.description();
    const double moment = renderer.info().time;
    if (scene.time.range && moment != (*scene.time.range)[0]) scene.time = {moment, std::nullopt};
    return scene;
}

Json sceneReport(const Renderer& renderer)
{
    const Scene& scene = RendererInternals::scene(renderer);
    const SceneInfo& info = renderer.info();
    // Those of a picture follow them, and come with it.
    const std::vector<std::string> ofScene(info.warnings.begin(),
                                           info.warnings.begin() + std::ptrdiff_t(info.dataWarnings));
    const SceneDescription& description = renderer.description();
    const SurfaceReach fit = scene.fit();
    const Camera camera =
        makeCamera(sceneView(description.camera, scene, 1, 1), scene.boundsWorld, scene.fitRadius, 1, 1);
    CameraOptions fitted;
    fitted.fov = std::max(description.camera.fov, 1.0);
    const Camera whole = makeCamera(fitted, fit.boundsWorld, fit.radius, 1, 1);
    Json report{{"scene", Json::parse(sceneToJson(sceneShown(renderer)))},
                {"bounds", Json::array({numbers(fit.boundsWorld.lo), numbers(fit.boundsWorld.hi)})},
                {"view",
                 {{"position", numbers(camera.positionWorld)},
                  {"focal", numbers(camera.positionWorld + camera.focalDistance * camera.forward)},
                  {"up", numbers(camera.up)},
                  {"fov", camera.fovDeg}}},
                {"distance", whole.focalDistance},
                {"radius", fit.radius},
                {"options", viewOptions(description)},
                {"colorRange", nullptr},
                {"colorName", scene.scalarName},
                {"choices", choices(renderer)},
                {"time", info.time},
                {"warnings", ofScene},
                {"backend", info.backend},
                {"device", info.device},
                {"ranks", info.ranks},
                {"threads", info.threadsOfRank},
                {"triangles", info.triangles},
                {"loadMs", info.loadMs}};
    if (scene.hasScalar) report["colorRange"] = scene.rangeFor(description.shading);
    if (const std::string& map = description.shading.colormap; isColorMapFile(map)) {
        report["choices"]["colorStops"] = {{map, colorStops(RendererInternals::colorMap(renderer))}};
        report["choices"]["colorsOutside"] = {{map, colorsOutside(RendererInternals::colorMap(renderer))}};
    }
    report["longestVector"] = scene.maxVector;
    return report;
}

}  // namespace aeolic::stream
