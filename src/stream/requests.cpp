#include "stream/requests.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aeolic/error.h"
#include "description/colormap.h"
#include "description/scene_document.h"
#include "description/scene_json.h"
#include "description/surface_spec.h"
#include "description/validate.h"

namespace aeolic::stream {
namespace {

constexpr int kDeepestNesting = 8;
constexpr std::size_t kLongestName = 64;
constexpr std::size_t kLongestCut = 1024;   // Bytes. All requests to the job hold the surfaces.
constexpr std::size_t kMostAdded = 16;      // Surfaces that viewers add. Each is cut out of the field, and kept.
constexpr std::uint64_t kMostLookUps = 32;  // About what the longest plan of jumps takes each way.

/// A field of a JSON object, of the type asked for.
const Json& field(const Json& json, const char* key)
{
    const auto at = json.find(key);
    if (at == json.end()) throw ProtocolError(std::string(key) + " is missing");
    return *at;
}

std::uint32_t numberFrom(const Json& json, const char* key)
{
    const Json& value = field(json, key);
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > 0xFFFFFFFFu)
        throw ProtocolError(std::string(key) + " is not a number from 0 to 2^32 - 1");
    return value.get<std::uint32_t>();
}

bool switchFrom(const Json& json, const char* key)
{
    const Json& value = field(json, key);
    if (!value.is_boolean()) throw ProtocolError(std::string(key) + " is not true or false");
    return value.get<bool>();
}

std::string textFrom(const Json& value, const char* key)
{
    if (!value.is_string()) throw ProtocolError(std::string(key) + " is not text");
    return value.get<std::string>();
}

std::string printable(std::string text)
{
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    return text;
}

/// Lays the keys of `over` over those of the same groups in `scene`.
SceneDescription overlaid(const SceneDescription& scene, const Json& over, const char* source)
{
    Json document = sceneDocument(scene);
    for (const auto& [group, items] : over.items()) {
        if (!items.is_object()) throw InputError(std::string(source) + ": " + group, "found no object", "an object");
        for (const auto& [key, value] : items.items()) document[group][key] = value;
    }
    return sceneFromDocument(document, source);
}

/// A viewer chooses among the colour maps that it was told of. Names of other files would be read by the job.
void refuseFiles(const SceneDescription& scene, const Json& options)
{
    if (!options.contains("shading") || !options["shading"].contains("colorMap")) return;
    const Json& name = options["shading"]["colorMap"];
    if (!name.is_string() || !isColorMapFile(name.get_ref<const std::string&>())) return;
    if (name.get_ref<const std::string&>() != scene.shading.colorMap)
        throw InputError("view: shading.colorMap", "found a file", "a built-in colour map, or the scene's own");
}

}  // namespace

Json parseJson(ByteView payload)
{
    int depth = 0;
    const auto refuseDepth = [&](int, Json::parse_event_t event, Json&) {
        using Event = Json::parse_event_t;
        if (event == Event::object_start || event == Event::array_start) {
            if (++depth > kDeepestNesting) throw ProtocolError("JSON nested too deeply");
        } else if (event == Event::object_end || event == Event::array_end) {
            --depth;
        }
        return true;
    };
    try {
        Json json = Json::parse(payload.begin(), payload.end(), refuseDepth);
        if (!json.is_object()) throw ProtocolError("JSON that is no object");
        return json;
    } catch (const Json::exception&) {
        throw ProtocolError("not JSON");
    }
}

Hello helloFrom(const Json& json)
{
    Hello hello;
    const Json& codecs = field(json, "codecs");
    if (!codecs.is_array()) throw ProtocolError("codecs is not a list");
    for (const Json& name : codecs) {
        const auto codec = codecFromName(textFrom(name, "codecs"));
        if (codec && available(*codec) &&
            std::find(hello.codecs.begin(), hello.codecs.end(), *codec) == hello.codecs.end())
            hello.codecs.push_back(*codec);
    }
    if (std::find(hello.codecs.begin(), hello.codecs.end(), Codec::png) == hello.codecs.end())
        throw ProtocolError("codecs lacks png");
    if (json.contains("direct")) hello.direct = switchFrom(json, "direct");
    if (json.contains("name")) hello.name = printable(textFrom(json["name"], "name"));
    if (hello.name.size() > kLongestName) throw ProtocolError("name is longer than 64 bytes");
    return hello;
}

ViewRequest viewFrom(const Json& json, int largestSide)
{
    ViewRequest request;
    request.view = numberFrom(json, "view");
    request.moving = switchFrom(json, "moving");
    const double width = numberFrom(json, "width"), height = numberFrom(json, "height");
    if (width < 1 || height < 1) throw ProtocolError("a view without pixels");
    const double shrink = std::min(1.0, largestSide / std::max(width, height));
    request.width = std::max(1, int(width * shrink));
    request.height = std::max(1, int(height * shrink));
    request.options = Json::object();
    for (const auto& [key, value] : json.items()) {
        if (key == "view" || key == "moving" || key == "width" || key == "height") continue;
        if (key != "camera" && key != "lic" && key != "shading") throw ProtocolError("a view with an unknown key");
        if (!value.is_object()) throw ProtocolError("a view's " + key + " is no object");
        request.options[key] = value;
    }
    return request;
}

SceneDescription withView(const SceneDescription& scene, const ViewRequest& view, int width, int height)
{
    if (view.options.contains("shading") && view.options["shading"].contains("colorBy"))
        throw InputError("view: shading.colorBy", "found in a view", "a Change: it is the scene's");
    refuseFiles(scene, view.options);
    SceneDescription drawn = scene;
    // A camera replaces the scene's as a whole. Otherwise an absolute camera of the scene would win over a view's
    // angles.
    if (view.options.contains("camera")) drawn.camera = CameraOptions{};
    drawn = overlaid(drawn, view.options, "view");
    drawn.output.width = width;
    drawn.output.height = height;
    return drawn;
}

std::uint64_t samplesOf(const SceneDescription& scene)
{
    const std::uint64_t pixels = std::uint64_t(scene.output.width) * std::uint64_t(scene.output.height);
    const auto steps = std::uint64_t(scene.lic.steps);
    switch (scene.lic.method) {
        case LicMethod::none:
            return pixels;
        case LicMethod::direct:
            return pixels * 2 * steps;
        case LicMethod::hierarchical:
            return pixels * 2 * std::min(steps, kMostLookUps);
    }
    return pixels;
}

namespace {

std::vector<bool> shownFrom(const Json& json)
{
    if (!json.is_array() || json.size() > options::mostSurfaces) throw ProtocolError("shown is no list of switches");
    std::vector<bool> shown;
    for (const Json& one : json) {
        if (!one.is_boolean()) throw ProtocolError("shown is no list of switches");
        shown.push_back(one.get<bool>());
    }
    return shown;
}

/// A place among surfaces, from a key of a JSON object.
std::size_t placeFrom(const std::string& text)
{
    constexpr std::size_t mostDigits = 3;
    const bool isNumber = std::all_of(text.begin(), text.end(), [](unsigned char c) { return c >= '0' && c <= '9'; });
    if (text.empty() || text.size() > mostDigits || !isNumber)
        throw ProtocolError("cuts has a place that is no number");
    return std::stoul(text);
}

std::map<std::size_t, std::optional<std::string>> cutsFrom(const Json& json)
{
    if (!json.is_object() || json.size() > options::mostSurfaces) throw ProtocolError("cuts is no object of surfaces");
    std::map<std::size_t, std::optional<std::string>> cuts;
    for (const auto& [place, spec] : json.items())
        cuts[placeFrom(place)] = spec.is_null() ? std::nullopt : std::optional(textFrom(spec, "cuts"));
    return cuts;
}

Json steerFrom(const Json& json)
{
    if (!json.is_object() || json.empty()) throw ProtocolError("steer is no object of numbers");
    for (const auto& [name, value] : json.items())
        if (name.size() > kLongestName || !value.is_number() || !std::isfinite(value.get<double>()))
            throw ProtocolError("steer has something else than names and numbers");
    return json;
}

}  // namespace

ChangeRequest changeFrom(const Json& json)
{
    ChangeRequest change;
    for (const auto& [key, value] : json.items()) {
        if (key == "surface") {
            change.surface = textFrom(value, "surface");
        } else if (key == "vectors") {
            change.vectors = textFrom(value, "vectors");
        } else if (key == "colorBy") {
            change.colorBy = textFrom(value, "colorBy");
        } else if (key == "time") {
            if (!value.is_number() || !std::isfinite(value.get<double>())) throw ProtocolError("time is not a number");
            change.time = value.get<double>();
        } else if (key == "shown") {
            change.shown = shownFrom(value);
        } else if (key == "cuts") {
            change.cuts = cutsFrom(value);
        } else if (key == "steer") {
            change.steer = steerFrom(value);
        } else {
            throw ProtocolError("a change with an unknown key");
        }
    }
    return change;
}

namespace {

void requireCut(const std::string& spec)
{
    if (spec.size() > kLongestCut)
        throw InputError("surface", fmt::format("found {} bytes", spec.size()), fmt::format("at most {}", kLongestCut));
    if (!parseSurfaceSpec(spec).isCut())
        throw InputError("surface", "found '" + printable(spec).substr(0, kLongestName) + "'",
                         "original, slice:…, isosurface:… or boundary");
}

/// The scene draws `items` in the place of its surfaces. One that was the only one stays outside of a list.
void setSurfaces(SceneDescription& scene, std::vector<SurfaceItem> items, const SceneDescription& original)
{
    if (items.size() == 1 && original.surfaces.empty()) {
        scene.surface.spec = items.front().spec;
        items.clear();
    }
    scene.surfaces = std::move(items);
}

/// The surfaces that the server was started with, and `surface` in the place of the only one, or beside several. Those
/// that were hidden stay so.
void showSurface(SceneDescription& scene, const SceneDescription& original, const std::string& surface)
{
    const std::vector<SurfaceItem> before = scene.surfaces;
    scene.surface = original.surface;
    scene.surfaces = original.surfaces;
    for (std::size_t i = 0; i < std::min(before.size(), scene.surfaces.size()); ++i)
        scene.surfaces[i].shown = before[i].shown;
    if (surface == "original") return;
    requireCut(surface);
    if (scene.surfaces.empty()) {
        scene.surface.spec = surface;
    } else {
        scene.surfaces.emplace_back();
        scene.surfaces.back().spec = surface;
    }
}

/// Moves what is cut out of the field, adds to it, or takes away what was added.
void applyCuts(SceneDescription& scene, const SceneDescription& original,
               const std::map<std::size_t, std::optional<std::string>>& cuts)
{
    std::vector<SurfaceItem> items = surfacesOf(scene);
    const std::size_t given = surfacesOf(original).size();
    for (const auto& [place, spec] : cuts) {
        if (!spec) continue;
        requireCut(*spec);
        if (place > items.size() || place >= given + kMostAdded)
            throw InputError("cuts", fmt::format("found a surface {}", place),
                             fmt::format("one of the {} that there are, or the next one; at most {} more than the "
                                         "server was started with",
                                         items.size(), kMostAdded));
        if (place == items.size())
            items.emplace_back();
        else if (!parseSurfaceSpec(items[place].spec).isCut())
            throw InputError("cuts", fmt::format("found surface {}, which is not cut out of the field", place),
                             "one that is");
        items[place].spec = *spec;
    }
    for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut) {
        if (cut->second) continue;
        if (cut->first < given || cut->first >= items.size())
            throw InputError("cuts", fmt::format("found nothing for surface {}", cut->first),
                             "that only for one that was added");
        items.erase(items.begin() + std::ptrdiff_t(cut->first));
    }
    setSurfaces(scene, std::move(items), original);
}

}  // namespace

std::string surfaceName(const SceneDescription& scene, const SceneDescription& original)
{
    return surfacesText(scene) == surfacesText(original) ? "original" : surfacesOf(scene).back().spec;
}

SceneDescription withChange(const SceneDescription& scene, const SceneDescription& original,
                            const ChangeRequest& change)
{
    SceneDescription changed = scene;
    if (change.surface) showSurface(changed, original, *change.surface);
    if (!change.cuts.empty()) applyCuts(changed, original, change.cuts);
    if (change.shown) {
        if (change.shown->size() != changed.surfaces.size())
            throw InputError("shown", "found " + std::to_string(change.shown->size()) + " switches",
                             std::to_string(changed.surfaces.size()) + ", one for each of several surfaces");
        for (std::size_t i = 0; i < changed.surfaces.size(); ++i) changed.surfaces[i].shown = (*change.shown)[i];
    }
    if (change.vectors) changed.field.vectors = *change.vectors;
    if (change.time) changed.time = {*change.time, std::nullopt};
    if (change.colorBy) {
        changed.shading.colorBy = *change.colorBy;
        changed.shading.colorRange.reset();  // The range belonged to another array.
    }
    validate(changed, [](const Option& option) { return "change: " + jsonName(option); });
    return changed;
}

bool differInWhatIsShown(const SceneDescription& a, const SceneDescription& b)
{
    SceneDescription same = a;
    same.time = b.time;
    if (same.surfaces.size() != b.surfaces.size()) return false;
    for (std::size_t i = 0; i < b.surfaces.size(); ++i) same.surfaces[i].shown = b.surfaces[i].shown;
    return sceneToJson(same) == sceneToJson(b);
}

std::string drawToJson(const DrawRequest& draw)
{
    return Json{{"frame", draw.frame},
                {"viewer", draw.viewer},
                {"view", draw.view},
                {"askedWidth", draw.askedWidth},
                {"codec", std::string(codecName(draw.codec))},
                {"quality", draw.quality},
                {"direct", draw.direct},
                {"scene", sceneDocument(draw.scene)}}
        .dump();
}

DrawRequest drawFrom(const Json& json)
{
    DrawRequest draw;
    draw.frame = numberFrom(json, "frame");
    draw.viewer = numberFrom(json, "viewer");
    draw.view = numberFrom(json, "view");
    draw.askedWidth = numberFrom(json, "askedWidth");
    const auto codec = codecFromName(textFrom(field(json, "codec"), "codec"));
    if (!codec) throw ProtocolError("an unknown codec");
    draw.codec = *codec;
    draw.quality = int(numberFrom(json, "quality"));
    draw.direct = switchFrom(json, "direct");
    draw.scene = sceneFromDocument(field(json, "scene"), "");
    return draw;
}

}  // namespace aeolic::stream
