#include "data/load/join_scenes.h"

#include <fmt/format.h>

#include <algorithm>

#include "aeolic/error.h"
#include "data/mesh/join_meshes.h"
#include "data/mesh/mesh_tools.h"
#include "description/scene_surfaces.h"

namespace aeolic {
namespace {

void addNew(ArrayChoices& all, const ArrayChoices& more)
{
    for (const ArrayChoice& array : more)
        if (std::ranges::find(all, array) == all.end()) all.push_back(array);
}

/// The place among the scene's colours of those that the surface has.
int colorsOf(const SurfacePart& part, std::vector<SceneColors>& all)
{
    const SurfaceItem& item = part.source().item;
    if (!part.scene.hasScalar) return SceneSurface::kPlain;
    SceneColors colors;
    colors.name = part.scene.scalarName;
    colors.shownRange = item.colorRange;
    colors.colorMap = item.colormap;
    colors.legend = item.legend;
    const auto same = [&](const SceneColors& c) {
        return c.name == colors.name && c.shownRange == colors.shownRange && c.colorMap == colors.colorMap &&
               c.legend == colors.legend;
    };
    const auto known = std::ranges::find_if(all, same);
    if (known != all.end()) return int(known - all.begin());
    all.push_back(std::move(colors));
    return int(all.size()) - 1;
}

/// What of the field is sampled at every pixel, the same for all surfaces that need it. Others carry their values.
void takeField(const SurfacePart& part, Scene& joined)
{
    if (!part.scene.field) return;
    joined.field = part.scene.field;
    if (part.samplesScalar()) joined.scalarField = part.scene.scalarField;
}

/// What of the vectors is coloured by is the same for all surfaces: each pixel has its vector alone.
void takePartOfVectors(const SurfacePart& part, Scene& joined)
{
    const ArrayPart of = part.scene.ofVectors;
    if (!part.scene.hasScalar || of == ArrayPart::whole) return;
    if (joined.ofVectors != ArrayPart::whole && joined.ofVectors != of)
        throw InputError("surfaces",
                         "found '" + std::string(suffixOf(joined.ofVectors)) + "' and '" + std::string(suffixOf(of)) +
                             "' to colour by",
                         "the same part of the vectors for all surfaces");
    joined.ofVectors = of;
}

/// The vectors' name, where all streaks follow arrays of one name.
std::string vectorsNameOf(const SurfaceParts& parts)
{
    std::optional<std::string> name;
    for (const auto& part : parts) {
        if (!part->source().item.streaks) continue;
        if (name && *name != part->scene.vectorsName) return "";
        name = part->scene.vectorsName;
    }
    return name.value_or("");
}

/// Which surfaces carry what others are sampled for.
void markOwnValues(const SurfaceParts& parts, Scene& joined)
{
    for (const auto& part : parts) {
        SceneSurface& surface = joined.surfaces[part->index()];
        const bool byNormal = needsNormal(part->scene.ofVectors);
        const bool sampled = joined.field || needsNormal(joined.ofVectors);  // Not all carry what is drawn.
        surface.ownVectors = sampled && surface.streaks && !part->samplesVectors();
        surface.ownScalar = (joined.scalarFromField() || needsNormal(joined.ofVectors)) && part->scene.hasScalar &&
                            !part->samplesScalar() && !byNormal;
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
        SceneSurface surface{item.spec, item.streaks, colorsOf(*part, joined.colors), item.shown};
        surface.fit = {own.boundsWorld, own.fitRadius};
        joined.surfaces.push_back(surface);
        joined.boundsWorld.add(own.boundsWorld);
        addNew(joined.surfaceArrays, own.surfaceArrays);
        addNew(joined.fieldArrays, own.fieldArrays);
        takeField(*part, joined);
        takePartOfVectors(*part, joined);
    }
    if (needsNormal(joined.ofVectors) && joined.scalarField)
        throw InputError("surfaces",
                         "found '" + joined.scalarField->name + "' of the field and '" +
                             std::string(suffixOf(joined.ofVectors)) + "' of vectors to colour by",
                         "one of them for all surfaces, or arrays of the surfaces' own");
    joined.vectorsName = vectorsNameOf(parts);
    for (const auto& part : parts)
        if (part->source().item.streaks && !joined.againstFlow) joined.againstFlow = part->scene.againstFlow;
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

void uniteRanges(const std::vector<SceneRanges>& ranges, Scene& joined)
{
    const auto isShown = [](const SceneSurface& surface) { return surface.shown; };
    /// Those that count: of those that are meant the ones that are shown, or, where none is, all of them.
    const auto counted = [&](const auto& isMeant) {
        std::vector<const SceneRanges*> shown, all;
        for (std::size_t i = 0; i < joined.surfaces.size(); ++i) {
            if (!isMeant(joined.surfaces[i])) continue;
            all.push_back(&ranges[i]);
            if (joined.surfaces[i].shown) shown.push_back(&ranges[i]);
        }
        return shown.empty() ? all : shown;
    };
    joined.maxVector = joined.maxTangential = 0;
    for (const SceneRanges* own : counted([](const SceneSurface& surface) { return surface.streaks; })) {
        joined.maxVector = std::max(joined.maxVector, own->maxVector);
        joined.maxTangential = std::max(joined.maxTangential, own->maxTangential);
    }
    const SceneColors* told = nullptr;
    for (std::size_t c = 0; c < joined.colors.size(); ++c) {
        SceneColors& colors = joined.colors[c];
        const auto has = [&](const SceneSurface& surface) { return surface.colors == int(c); };
        colors.rangeKnown = false;
        for (const SceneRanges* own : counted(has)) {
            if (!own->scalarRangeKnown) continue;
            if (!colors.rangeKnown) {
                colors.range = own->scalarRange;
                colors.robustRange = own->robustRange;
            }
            colors.range = {std::min(colors.range[0], own->scalarRange[0]),
                            std::max(colors.range[1], own->scalarRange[1])};
            colors.robustRange = {std::min(colors.robustRange[0], own->robustRange[0]),
                                  std::max(colors.robustRange[1], own->robustRange[1])};
            colors.rangeKnown = true;
        }
        const auto isSeen = [&](const SceneSurface& surface) { return isShown(surface) && has(surface); };
        if (!told && std::ranges::any_of(joined.surfaces, isSeen)) told = &colors;
    }
    if (joined.colors.empty()) return;
    const SceneColors& first = told ? *told : joined.colors.front();
    joined.scalarName = first.name;
    joined.scalarRange = first.range;
    joined.robustRange = first.robustRange;
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
