#include "stream/requests.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aeolic/error.h"
#include "base/text.h"
#include "description/colormap.h"
#include "description/scene_json.h"
#include "description/validate.h"
#include "render/lic/lic_kernel.h"
#include "render/lic/phase_mix.h"

namespace aeolic::stream {
namespace {

constexpr int kDeepestNesting = 8;
constexpr std::size_t kLongestName = 64;
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

double farnessFrom(const Json& value)
{
    constexpr double most = 1e6;
    if (!value.is_number() || !(value.get<double>() > 0 && value.get<double>() <= most))
        throw ProtocolError(fmt::format("home is not a number above 0, up to {:g}", most));
    return value.get<double>();
}

std::string textFrom(const Json& value, const char* key)
{
    if (!value.is_string()) throw ProtocolError(std::string(key) + " is not text");
    return value.get<std::string>();
}

/// Lays the keys of `over` over those of the same groups in `scene`.
SceneDescription overlaid(const SceneDescription& scene, const Json& over, const char* source)
{
    Json document = sceneDocument(scene);
    for (const auto& [group, items] : over.items()) {
        if (!items.is_object())
            throw InputError(std::string(source) + ": " + group, "found another value", "an object");
        for (const auto& [key, value] : items.items()) document[group][key] = value;
    }
    return sceneFromDocument(document, source);
}

/// A viewer chooses among the colour maps that it was told of. Names of other files would be read by the job.
void refuseFiles(const SceneDescription& scene, const Json& options)
{
    if (!options.contains("shading") || !options["shading"].contains("colormap")) return;
    const Json& name = options["shading"]["colormap"];
    if (!name.is_string() || !isColorMapFile(name.get_ref<const std::string&>())) return;
    if (name.get_ref<const std::string&>() != scene.shading.colormap)
        throw InputError("view: shading.colormap", "found a file", "a built-in colour map, or the scene's own");
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
        if (!json.is_object()) throw ProtocolError("JSON that is not an object");
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
        if (codec && available(*codec) && std::ranges::count(hello.codecs, *codec) == 0) hello.codecs.push_back(*codec);
    }
    if (std::ranges::count(hello.codecs, Codec::png) == 0) throw ProtocolError("codecs lacks png");
    if (json.contains("direct")) hello.direct = switchFrom(json, "direct");
    if (json.contains("name")) hello.name = withoutControls(textFrom(json["name"], "name"));
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
    if (json.contains("home")) request.home = farnessFrom(json["home"]);
    request.options = Json::object();
    for (const auto& [key, value] : json.items()) {
        if (key == "view" || key == "moving" || key == "width" || key == "height" || key == "home") continue;
        if (key != "camera" && key != "lic" && key != "shading") throw ProtocolError("a view with an unknown key");
        if (!value.is_object()) throw ProtocolError("a view's " + key + " is not an object");
        request.options[key] = value;
    }
    return request;
}

PickRequest pickFrom(Json json, int largestSide)
{
    const std::uint32_t x = numberFrom(json, "x"), y = numberFrom(json, "y");
    json.erase("x");
    json.erase("y");
    PickRequest pick{viewFrom(json, largestSide)};
    const std::uint32_t width = numberFrom(json, "width"), height = numberFrom(json, "height");
    if (x >= width || y >= height) throw ProtocolError("a pixel outside of the view");
    pick.x = int(std::uint64_t(x) * std::uint64_t(pick.view.width) / width);
    pick.y = int(std::uint64_t(y) * std::uint64_t(pick.view.height) / height);
    return pick;
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

ViewRequest fromHome(ViewRequest view, const Json& ofScene)
{
    if (!view.home) return view;
    view.options.erase("camera");
    if (*view.home == 1 || !ofScene.is_object()) return view;
    Json camera = ofScene;
    for (std::size_t i = 0; i < 3; ++i) {
        const double focal = camera.at("focal").at(i).get<double>(), eye = camera.at("position").at(i).get<double>();
        camera["position"][i] = focal + (eye - focal) * *view.home;
    }
    view.options["camera"] = std::move(camera);
    return view;
}

std::uint64_t samplesOf(const SceneDescription& scene)
{
    const std::uint64_t pixels = std::uint64_t(scene.output.width) * std::uint64_t(scene.output.height);
    const std::uint64_t phases = scene.lic.flow == FlowMotion::loop ? phase_mix::runsOf(scene.lic).size() : 1;
    const auto steps = std::uint64_t(kernelSteps(scene.lic)) * phases;
    if (scene.lic.method == LicMethod::none) return pixels;
    const bool jumps = scene.lic.method == LicMethod::hierarchical;
    return pixels * 2 * (jumps ? std::min(steps, kMostLookUps * phases) : steps);
}

namespace {

std::vector<bool> shownFrom(const Json& json)
{
    if (!json.is_array() || json.size() > options::mostSurfaces) throw ProtocolError("shown is not a list of switches");
    std::vector<bool> shown;
    for (const Json& one : json) {
        if (!one.is_boolean()) throw ProtocolError("shown is not a list of switches");
        shown.push_back(one.get<bool>());
    }
    return shown;
}

/// A place among surfaces, from a key of a JSON object.
std::size_t placeFrom(const std::string& text)
{
    constexpr std::size_t mostDigits = 3;
    const auto place = wholeTextAs<std::size_t>(text);
    if (!place || text.size() > mostDigits) throw ProtocolError("cuts has a place that is not a number");
    return *place;
}

std::map<std::size_t, std::optional<std::string>> cutsFrom(const Json& json)
{
    if (!json.is_object() || json.size() > options::mostSurfaces)
        throw ProtocolError("cuts is not an object of surfaces");
    std::map<std::size_t, std::optional<std::string>> cuts;
    for (const auto& [place, spec] : json.items())
        cuts[placeFrom(place)] = spec.is_null() ? std::nullopt : std::optional(textFrom(spec, "cuts"));
    return cuts;
}

Json steerFrom(const Json& json)
{
    if (!json.is_object() || json.empty()) throw ProtocolError("steer is not an object of numbers");
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
        } else if (key == "places") {
            change.places = numberFrom(json, "places");
        } else if (key == "steer") {
            change.steer = steerFrom(value);
        } else if (key == "change") {
            change.number = numberFrom(json, "change");
        } else if (key == "moving") {
            change.moving = switchFrom(json, "moving");
        } else {
            throw ProtocolError("a change with an unknown key");
        }
    }
    return change;
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

std::string probeToJson(const ProbeRequest& probe)
{
    return Json{{"viewer", probe.viewer},
                {"view", probe.view},
                {"x", probe.x},
                {"y", probe.y},
                {"scene", sceneDocument(probe.scene)}}
        .dump();
}

ProbeRequest probeFrom(const Json& json)
{
    ProbeRequest probe;
    probe.viewer = numberFrom(json, "viewer");
    probe.view = numberFrom(json, "view");
    probe.x = int(numberFrom(json, "x"));
    probe.y = int(numberFrom(json, "y"));
    probe.scene = sceneFromDocument(field(json, "scene"), "");
    return probe;
}

}  // namespace aeolic::stream
