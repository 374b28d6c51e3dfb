#include <fmt/format.h>

#include <algorithm>

#include "aeolic/error.h"
#include "base/text.h"
#include "description/option_table.h"
#include "description/scene_json.h"
#include "description/scene_surfaces.h"
#include "description/validate.h"
#include "stream/requests.h"

namespace aeolic::stream {
void merge(ChangeRequest& older, ChangeRequest newer)
{
    const auto take = [](auto& wish, auto& other) {
        if (other) wish = std::move(other);
    };
    if (newer.surface) {  // Wishes about other surfaces are over.
        older.shown.reset();
        older.cuts.clear();
    }
    take(older.surface, newer.surface);
    for (auto& [place, cut] : newer.cuts) older.cuts.insert_or_assign(place, std::move(cut));
    take(older.vectors, newer.vectors);
    take(older.colorBy, newer.colorBy);
    take(older.time, newer.time);
    take(older.shown, newer.shown);
    take(older.places, newer.places);
    if (!newer.steer.is_null()) older.steer.update(newer.steer);
    older.number = newer.number;
    older.moving = newer.moving;
}

namespace {

constexpr std::size_t kLongestShown = 64;  // Bytes of a text in a message.
constexpr std::size_t kLongestCut = 1024;  // Bytes. All requests to the job hold the surfaces.
constexpr std::size_t kMostAdded = 16;     // Surfaces that viewers add. Each is cut out of the field, and kept.

void requireCut(const std::string& spec)
{
    if (spec.size() > kLongestCut)
        throw InputError("surface", fmt::format("found {} bytes", spec.size()), fmt::format("at most {}", kLongestCut));
    if (!parseSurfaceSpec(spec).isCut())
        throw InputError("surface", "found '" + withoutControls(spec).substr(0, kLongestShown) + "'",
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

/// Moves surfaces that are cut out of the field, adds some, or takes away those that were added.
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

/// A switch for each of several surfaces.
void switchSurfaces(SceneDescription& scene, const std::vector<bool>& shown)
{
    if (shown.size() != scene.surfaces.size())
        throw InputError("shown", "found " + std::to_string(shown.size()) + " switches",
                         std::to_string(scene.surfaces.size()) + ", one for each of several surfaces");
    for (std::size_t i = 0; i < shown.size(); ++i) scene.surfaces[i].shown = shown[i];
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
    // Switches that were asked for before something was added or taken away are those of the surfaces before.
    const bool areBefore = change.shown && change.shown->size() == changed.surfaces.size();
    if (areBefore) switchSurfaces(changed, *change.shown);
    if (!change.cuts.empty()) applyCuts(changed, original, change.cuts);
    if (change.shown && !areBefore) switchSurfaces(changed, *change.shown);
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

}  // namespace aeolic::stream
