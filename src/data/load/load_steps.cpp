#include "data/load/load_steps.h"

#include <algorithm>
#include <utility>

#include "aeolic/error.h"
#include "base/nearest_name.h"
#include "data/builtin/flows.h"
#include "data/field_copies.h"
#include "data/field_tiles.h"
#include "data/named_file.h"
#include "data/reading/file_questions.h"
#include "data/vtk/grid/grid_file.h"
#include "description/scene_surfaces.h"

namespace aeolic {
namespace {

/// Throws InputError where surfaces and field do not go together.
void checkSources(const SceneSources& sources, const SceneDescription& description, const Data& memory,
                  const FieldPart& part)
{
    const std::string& field = description.field.spec;
    if (memory.surface && sources.surfaces.size() > 1)
        throw InputError("surfaces", "found together with a surface in memory", "one or the other");
    if (part.split() && field.empty())
        throw InputError("--bricks", "there is nothing to split: no field, and a surface that is not in pieces",
                         "off or auto");
    const bool isFile = !field.empty() && !isBuiltinFlow(field);
    for (const auto& [item, spec, track] : sources.surfaces) {
        if (spec.isCut() && !isFile)
            throw InputError("surface '" + spec.text + "'",
                             field.empty() ? "there is no field to cut it out of"
                                           : "the built-in field spans the surface and cannot be cut itself",
                             "a field from a file (--field FILE)");
        if (spec.kind == SurfaceSpec::Kind::builtin && field.empty() && item.streaks)
            throw InputError("surface '" + spec.text + "'", "it has no vectors of its own",
                             "a field to sample on it (--field)");
        if (item.vectors && item.streaks && spec.kind != SurfaceSpec::Kind::file)
            throw InputError("surface '" + spec.text + "'", "it has no array '" + *item.vectors + "' of its own",
                             "vectors of the field, which are those of all surfaces");
    }
}

/// What the surface is asked for, as far as the description tells.
SurfaceAsk askOf(const SurfaceTrack& surface, const SceneDescription& description)
{
    const auto& [item, spec, track] = surface;
    const std::string& field = description.field.spec;
    const bool hasField = !field.empty();
    SurfaceAsk ask;
    ask.colorBy = parseColorBy(colorByOf(item, description));
    ask.ownVectors = item.streaks && (item.vectors || !hasField);
    ask.fieldVectors = item.streaks && !ask.ownVectors;
    if (ask.colorBy.name.empty()) return ask;
    // A file that has its vectors itself is not asked for the field's arrays unless somebody says so.
    const bool ofItself = spec.kind == SurfaceSpec::Kind::file && !ask.fieldVectors && !ask.colorBy.of;
    ask.colorsFromField = hasField && !ofItself && ask.colorBy.mayBeOfField();
    ask.colorsFromSurface = ask.colorBy.mayBeOfSurface();
    if (isBuiltinFlow(field)) {  // Its one array is known beforehand.
        const ArrayRef array = parseArray(ask.colorBy.name);
        ask.colorsFromField = ask.colorsFromField && array.name == field.substr(0, field.find(':')) &&
                              !array.onPoints && array.part != ArrayPart::whole;
        ask.colorsFromSurface = ask.colorsFromSurface && !ask.colorsFromField;
    }
    return ask;
}

}  // namespace

StepReader::StepReader(const SceneDescription& d, const Data& m, const FieldPart& p, const FieldPart& s)
    : description(d), memory(m), part(p), pieces(s), fieldVectors(parseFieldVectors(d.field.vectors)), sources(d)
{
    checkSources(sources, description, memory, part);
    if (fieldVectors.shear && description.field.offset == 0.0)
        throw InputError("--offset", "found 0 with --vectors " + description.field.vectors, "auto or another length");
    for (const SurfaceTrack& surface : sources.surfaces) asks.push_back(askOf(surface, description));
    const std::string colors = fieldColors();
    for (const SurfaceAsk& ask : asks)
        if (ask.colorsFromField && ask.colorBy.name != colors)
            throw InputError("surfaces",
                             "found the field's arrays '" + colors + "' and '" + ask.colorBy.name + "' to colour by",
                             "one array of the field for all surfaces, or surface:NAME");
    requireReversible();
    chooseFirstSteps();
    const Track& first = sources.surfaces.front().track;
    if (pieces.split() && !memory.surface) shares = pieceBytesOf(first.file(first.firstKey()).path);
}

/// Times may differ in their arrays: the array that is drawn is looked for at the first time that has it.
void StepReader::chooseFirstSteps()
{
    const auto choose = [](Track& track, const std::vector<std::string>& arrays) {
        if (track.times.size() < 2 || track.anyMoment || !namedKindHas(track.series.steps.front().path, kNamesFiles))
            return;
        const std::vector<double> times = timesOfCase(track.series.steps.front().path, arrays);
        const auto first = times.empty() ? track.times.end() : std::ranges::find(track.times, times.front());
        if (first != track.times.end()) track.firstStep = std::size_t(first - track.times.begin());
    };
    std::vector<std::string> ofField{fieldVectors.name, fieldColors()};
    for (std::size_t i = 0; i < asks.size(); ++i) {
        SurfaceTrack& surface = sources.surfaces[i];
        const SurfaceAsk& ask = asks[i];
        ofField.push_back(surface.spec.array);
        choose(surface.track,
               {ask.ownVectors ? ownVectors(surface.item).name : "", ask.colorsFromSurface ? ask.colorBy.name : ""});
    }
    choose(sources.field, ofField);
}

/// The array of the field that surfaces are coloured by; empty: none.
std::string StepReader::fieldColors() const
{
    for (const SurfaceAsk& ask : asks)
        if (ask.colorsFromField) return ask.colorBy.name;
    return "";
}

void StepReader::failColorBy(std::size_t index, const std::string& fieldArrays) const
{
    const auto& [item, spec, track] = sources.surfaces[index];
    const SurfaceAsk& ask = asks[index];
    const std::string typed = colorByOf(item, description);
    const bool asksField = !description.field.spec.empty() && (ask.colorsFromField || ask.fieldVectors);
    const bool fromFile = asksField && !isBuiltinFlow(description.field.spec);
    const bool ownArrays = spec.kind == SurfaceSpec::Kind::file;
    std::string expected = "one of: " + (asksField ? fieldArrays : ask.arrays);
    if (asksField && ownArrays) expected += "; on the surface: " + ask.arrays;
    std::vector<std::string> names;
    const auto add = [&](const std::string& listing, std::string_view prefix) {
        const std::string before(ask.colorBy.of ? prefix : "");
        for (const std::string& name : colorableNames(arraysListed(listing))) names.push_back(before + name);
    };
    if (asksField) add(fieldArrays, ColorBy::kFieldPrefix);
    add(ask.arrays, ColorBy::kSurfacePrefix);
    throw InputError(fromFile ? description.field.spec : spec.text, "no array '" + typed + "' to colour by",
                     expected + didYouMean(typed, names));
}

void StepReader::decideColors(const FieldStep& first)
{
    for (SurfaceAsk& ask : asks) {
        ask.colorsFromField = ask.colorsFromField && first.hasScalar;
        ask.colorsFromSurface = ask.colorsFromSurface && !ask.colorsFromField;
    }
}

/// Slices and isosurfaces pass through cells, where there is flow. A boundary may be a wall without slip.
bool StepReader::looksUpCells(const SurfaceSpec& spec) const
{
    return !description.field.resampleSpacing && (!spec.isCut() || spec.kind == SurfaceSpec::Kind::boundary);
}

FieldStep StepReader::field(double key, const ProgressReport& progress) const
{
    return sources.field.anyMoment ? builtinField(key) : fieldFile(sources.field.file(key), progress);
}

FieldStep StepReader::builtinField(double time) const
{
    FieldStep step;
    step.vectors = makeBuiltinFlow(description.field.spec, boundsWorld, part, time);
    const ArrayPart asked = parseArray(fieldColors()).part;
    if (const auto component = componentOf(asked)) step.scalar = componentOf(*step.vectors, *component);
    if (description.field.precision == FieldPrecision::float16) step.vectors = halfField(step.vectors, step.tallies);
    step.vectors = inTiles(step.vectors);
    step.arrays = step.vectors->name + ":mag";
    step.offered = {{step.vectors->name, 3}};
    step.hasScalar = !fieldColors().empty();
    if (asked == ArrayPart::length || needsNormal(asked)) step.ofVectors = asked;
    step.vectorsName = step.vectors->name;
    step.scalarName = labelOf(step.vectorsName, asked);
    return step;
}

FieldStep StepReader::fieldFile(const StepFile& file, const ProgressReport& progress) const
{
    GridRequest request;
    request.vectors = fieldVectors.name;
    request.colorBy = colorsAreShear() ? fieldVectors.name + ":mag" : fieldColors();
    request.halves = description.field.precision == FieldPrecision::float16;
    request.timeInFile = file.timeInFile;
    request.ranksOnHost = ranksOnHost;
    request.parts = file.parts;
    request.otherFiles = file.others;
    for (const SurfaceTrack& surface : sources.surfaces) {
        request.lookUp = request.lookUp || looksUpCells(surface.spec);
        request.cutsOut = request.cutsOut || surface.spec.isCut();
        if (!surface.spec.array.empty()) request.contours.push_back(surface.spec.array);
    }
    if (memory.grid) {
        GridFile grid(*memory.grid, file.path, request);
        return fieldStep(grid, file.path, progress);
    }
    if (memory.volume) {
        GridFile grid(*memory.volume, file.path, request);
        return fieldStep(grid, file.path, progress);
    }
    FieldStep step;
    if (const auto bytesOfPieces = piecesOf(file); !bytesOfPieces.empty()) {
        const PieceRun run = runOf(fieldReaders, bytesOfPieces);
        step.inPieces = true;
        step.firstPiece = run.begin;
        step.pieces = GridFile::readPieces(file.path, request, run, progress);
        OneRank alone;
        step.name = file.path;
        if (!fieldReaders.split()) return unitePieces(step, alone);
    } else if (!fieldReaders.split() || readsForHost) {
        GridFile grid(file.path, request, part, progress);
        step = fieldStep(grid, file.path, progress);
    }
    step.complete = !fieldReaders.split();
    return step;
}

void StepReader::complete(FieldStep& step, Agreement& agreement) const
{
    if (step.complete) return;
    if (step.inPieces)
        step = unitePieces(step, agreement);
    else
        shareStep(step, agreement);
}

/// Throws where the field has not what surfaces are to be coloured by. Whether those from files have it is seen later.
void StepReader::requireColors(const FieldStep& step) const
{
    if (step.hasScalar) return;
    for (std::size_t i = 0; i < asks.size(); ++i) {
        const bool surfaceFollows = !firstIsRead && sources.surfaces[i].spec.kind == SurfaceSpec::Kind::file;
        if (asks[i].colorsFromField && !surfaceFollows) failColorBy(i, step.arrays);
    }
}

void StepReader::nameShear(FieldFacts& facts) const
{
    if (!fieldVectors.shear) return;
    if (needsNormal(facts.ofVectors) && !colorsAreShear())
        throw InputError(
            facts.name,
            "'" + facts.scalarName + "' to colour by, but streaks that follow '" + description.field.vectors + "'",
            "'" + labelOf(description.field.vectors, facts.ofVectors) + "', of the vectors that the streaks follow");
    facts.vectorsName = description.field.vectors;
    if (!colorsAreShear()) return;
    facts.scalarName = labelOf(facts.vectorsName, shearColors());
    if (needsNormal(shearColors())) facts.ofVectors = shearColors();
}

void StepReader::requireNoShear(std::size_t index) const
{
    if (fieldVectors.shear && asks[index].fieldVectors)
        throw InputError("--vectors", "found '" + description.field.vectors + "' on a cut through cells",
                         "a surface along a wall: one from a file, or boundary");
}

/// With the surfaces that are cut out of it.
FieldStep StepReader::fieldStep(GridFile& grid, const std::string& path, const ProgressReport& progress) const
{
    FieldStep step;
    static_cast<FieldFacts&>(step) = grid.facts();
    nameShear(step);
    requireColors(step);

    const bool ownCells = !grid.uniform() && !description.field.resampleSpacing;
    bool inCells = false, sampled = false;
    step.cuts.resize(asks.size());
    for (std::size_t i = 0; i < asks.size(); ++i) {
        const SurfaceSpec& spec = sources.surfaces[i].spec;
        const SurfaceAsk& ask = asks[i];
        const bool isLookedUp = ownCells && looksUpCells(spec) && (!spec.isCut() || grid.hasCells());
        const bool isCarried = spec.isCut() && ownCells && !isLookedUp;
        if (isCarried) requireNoShear(i);
        const bool keepsShells = isLookedUp && spec.isCut() && !fieldVectors.shear;
        const bool carries = isCarried || keepsShells;
        if (spec.isCut())
            step.cuts[i] =
                grid.cut(spec, {carries && ask.fieldVectors, carries && ask.colorsFromField, keepsShells}, progress);
        inCells = inCells || (isLookedUp && (ask.fieldVectors || ask.colorsFromField));
        sampled = sampled || !(isLookedUp || isCarried);
    }
    if (inCells) {
        step.readCells = grid.takeCells();
        OneRank alone;
        if (!fieldReaders.split())
            step.cells = dealtVolume({std::exchange(step.readCells, nullptr)}, true, path, alone);
    } else if (sampled) {
        if (!grid.uniform()) grid.resample(description.field.resampleSpacing, progress);
        if (auto scalar = grid.takeScalar()) step.scalar = std::make_shared<const GridField>(std::move(*scalar));
        step.vectors = std::make_shared<const GridField>(grid.takeVectors());
        if (!grid.vectorsAreBorrowed()) step.vectors = inTiles(step.vectors);
    }
    step.tallies = grid.tallies();
    return step;
}

}  // namespace aeolic
