#include "data/load/join_scenes.h"

#include <fmt/format.h>

#include <algorithm>

#include "aeolic/error.h"
#include "data/mesh/join_meshes.h"
#include "data/mesh/mesh_tools.h"
#include "description/surface_spec.h"

namespace aeolic {
namespace {

void addNew(ArrayChoices& all, const ArrayChoices& more)
{
    for (const ArrayChoice& array : more) {
        const auto same = [&](const ArrayChoice& a) {
            return a.name == array.name && a.components == array.components;
        };
        if (std::none_of(all.begin(), all.end(), same)) all.push_back(array);
    }
}

/// The place among the scene's colours of those that the surface has.
int colorsOf(const SurfacePart& part, std::vector<SceneColors>& all)
{
    const SurfaceItem& item = part.source().item;
    if (!part.scene.hasScalar) return SceneSurface::kPlain;
    SceneColors colors;
    colors.name = part.scene.scalarName;
    colors.shownRange = item.colorRange;
    colors.colorMap = item.colorMap;
    colors.legend = item.legend;
    const auto same = [&](const SceneColors& c) {
        return c.name == colors.name && c.shownRange == colors.shownRange && c.colorMap == colors.colorMap &&
               c.legend == colors.legend;
    };
    const auto known = std::find_if(all.begin(), all.end(), same);
    if (known != all.end()) return int(known - all.begin());
    all.push_back(std::move(colors));
    return int(all.size()) - 1;
}

/// What of the field is sampled at every pixel, the same for all surfaces that need it. Others carry their values.
void takeField(const SurfacePart& part, Scene& joined)
{
    if (!part.scene.field) return;
    joined.field = part.scene.field;
    if (!part.samplesScalar()) return;
    joined.scalarField = part.scene.scalarField;
    joined.colorByFieldMagnitude = part.scene.colorByFieldMagnitude;
}

/// Which surfaces carry what others are sampled for.
void markOwnValues(const SurfaceParts& parts, Scene& joined)
{
    for (const auto& part : parts) {
        SceneSurface& surface = joined.surfaces[part->index()];
        surface.ownVectors = joined.field && surface.streaks && !part->samplesVectors();
        surface.ownScalar = joined.scalarFromField() && part->scene.hasScalar && !part->samplesScalar();
    }
}

}  // namespace

Scene joinedScene(const SurfaceParts& parts, const SceneDescription& description)
{
    Scene joined;
    joined.frontFacesOnly = description.surface.faces == Faces::front;
    joined.surface.name = surfacesText(description);
    for (const auto& part : parts) {
        const SurfaceItem& item = part->source().item;
        const Scene& own = part->scene;
        joined.surfaces.push_back({item.spec, item.streaks, colorsOf(*part, joined.colors), item.shown});
        joined.boundsWorld.add(own.boundsWorld);
        addNew(joined.surfaceArrays, own.surfaceArrays);
        addNew(joined.fieldArrays, own.fieldArrays);
        takeField(*part, joined);
    }
    markOwnValues(parts, joined);
    if (joined.colors.size() > SceneColors::kMost)
        throw InputError("surfaces", fmt::format("found {} kinds of colours", joined.colors.size()),
                         fmt::format("at most {} of different array, colour map, range or legend", SceneColors::kMost));
    joined.hasScalar = !joined.colors.empty();
    joined.surface.originWorld = joined.boundsWorld.center();
    for (const auto& part : parts)
        joined.fitRadius = std::max(joined.fitRadius, radiusAbout(part->scene.surface, joined.boundsWorld.center()));
    joined.reach = {joined.boundsWorld, joined.fitRadius};
    return joined;
}

void uniteRanges(const SurfaceParts& parts, Scene& joined)
{
    for (SceneColors& colors : joined.colors) colors.rangeKnown = false;
    joined.maxVector = 0;
    for (const auto& part : parts) {
        const Scene& own = part->scene;
        const SceneSurface& surface = joined.surfaces[part->index()];
        if (surface.streaks) joined.maxVector = std::max(joined.maxVector, own.maxVector);
        if (surface.colors == SceneSurface::kPlain || !own.scalarRangeKnown) continue;
        SceneColors& colors = joined.colors[std::size_t(surface.colors)];
        if (!colors.rangeKnown) colors.range = own.scalarRange;
        colors.range = {std::min(colors.range[0], own.scalarRange[0]), std::max(colors.range[1], own.scalarRange[1])};
        colors.rangeKnown = true;
    }
    if (joined.colors.empty()) return;
    const SceneColors& first = joined.colors.front();
    joined.scalarName = first.name;
    joined.scalarRange = first.range;
    joined.scalarRangeKnown = first.rangeKnown;
}

void joinMeshes(const SurfaceParts& parts, const std::vector<bool>& visible, Scene& joined)
{
    std::vector<const SurfaceMesh*> meshes;
    for (const auto& part : parts) {
        const bool isShown = visible[part->index()];
        joined.surfaces[part->index()].shown = isShown;
        meshes.push_back(isShown ? &part->scene.surface : nullptr);
        if (part->scene.field) takeField(*part, joined);
    }
    std::string name = joined.surface.name;
    joined.surface = joinMeshes(meshes, joined.surface.originWorld);
    joined.surface.name = std::move(name);
    joined.allTriangles = joined.surface.triangles.size();
    if (joined.allTriangles == 0) return;  // Nothing is visible: it is as far as before.
    joined.reach = {joined.surface.bounds(), radiusAbout(joined.surface, joined.boundsWorld.center())};
}

}  // namespace aeolic
