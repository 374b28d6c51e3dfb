#include "data/load/load_steps.h"

#include "aeolic/error.h"
#include "base/half.h"
#include "base/memory.h"
#include "base/nearest_name.h"
#include "data/builtin/flows.h"
#include "data/builtin/surfaces.h"
#include "data/cells/cell_sampler.h"
#include "data/field_tiles.h"
#include "data/vtk/grid/grid_file.h"
#include "data/vtk/memory/memory_surface.h"
#include "data/vtk/surface/surface_file.h"

namespace aeolic {
namespace {

std::int64_t countBeyondHalves(const GridField& field)
{
    const Brick whole{{0, 0, 0}, {field.dims[0] - 1, field.dims[1] - 1, field.dims[2] - 1}};
    const CountedSamples counted{field.dims, field.firstSample(), field.heldDims(), field.brick.value_or(whole)};
    std::int64_t count = 0;
    for (std::size_t i = 0; i < field.sampleCount() * std::size_t(field.components); ++i)
        count += isBeyondHalves(field.floats()[i]) && counted(std::int64_t(i) / field.components);
    return count;
}

std::shared_ptr<const GridField> toHalf(const std::shared_ptr<const GridField>& field, std::vector<Tally>& tallies)
{
    const std::size_t count = field->sampleCount() * std::size_t(field->components);
    requireMemory(field->name, "the field in half precision", 2 * count);
    Tally tally{Tally::Of::halves, field->name};
    tally.longest = field->maxMagnitude;
    if (field->maxMagnitude > kLargestHalf) tally.found = countBeyondHalves(*field);
    tallies.push_back(tally);
    GridField half = *field;
    const auto memory =
        std::shared_ptr<std::uint16_t[]>(new std::uint16_t[count + 2]);  // Gathers may read past the end.
    halvesFromFloatsParallel(field->floats(), memory.get(), count);
    half.samples = std::shared_ptr<const void>(memory, memory.get());
    half.precision = FieldPrecision::float16;
    return std::make_shared<const GridField>(std::move(half));
}

/// Throws InputError where surface and field do not go together.
void checkSources(const SurfaceSpec& spec, const SceneDescription& description, const FieldPart& part)
{
    const std::string& field = description.field.spec;
    if (!field.empty() && !isBuiltinFlow(field)) return;
    if (part.split() && field.empty())
        throw InputError("--bricks", "there is nothing to split: no field, and a surface that is not in pieces",
                         "off or auto");
    if (spec.isCut())
        throw InputError("surface '" + spec.text + "'",
                         field.empty() ? "there is no field to cut it out of"
                                       : "the built-in field spans the surface and cannot be cut itself",
                         "a field from a file (--field FILE)");
    if (spec.kind == SurfaceSpec::Kind::builtin && field.empty())
        throw InputError("surface '" + spec.text + "'", "it has no vectors of its own",
                         "a field to sample on it (--field)");
}

}  // namespace

StepReader::StepReader(const SceneDescription& d, const Data& m, const FieldPart& p, const FieldPart& s)
    : description(d),
      memory(m),
      part(p),
      pieces(s),
      colorBy(parseColorBy(d.shading.colorBy)),
      fieldVectors(parseFieldVectors(d.field.vectors)),
      sources(d),
      colorsFromField(colorBy.mayBeOfField() && !d.field.spec.empty()),
      colorsFromSurface(colorBy.mayBeOfSurface())
{
    checkSources(sources.surfaceSpec, description, part);
    if (fieldVectors.shear && description.field.offset == 0.0)
        throw InputError("--offset", "found 0 with --vectors " + description.field.vectors, "auto or another length");
    if (const std::string& flow = description.field.spec; isBuiltinFlow(flow)) {  // Its one array is known beforehand.
        colorsFromField = colorsFromField && colorBy.name == flow.substr(0, flow.find(':')) + ":mag";
        colorsFromSurface = colorsFromSurface && !colorsFromField;
    }
    if (pieces.split() && !memory.surface) shares = pieceBytesOf(sources.surface.file(sources.surface.firstKey()).path);
}

void StepReader::failColorBy(const std::string& fieldArrays) const
{
    const std::string& typed = description.shading.colorBy;
    const bool hasField = !description.field.spec.empty();
    const bool fromFile = hasField && !isBuiltinFlow(description.field.spec);
    const bool ownArrays = sources.surfaceSpec.kind == SurfaceSpec::Kind::file;
    std::string expected = "one of: " + (hasField ? fieldArrays : surfaceArrays);
    if (hasField && ownArrays) expected += "; on the surface: " + surfaceArrays;
    std::vector<std::string> names;
    const auto add = [&](const std::string& listing, std::string_view prefix) {
        const std::string before(colorBy.of ? prefix : "");
        for (const std::string& name : colorableNames(arraysListed(listing))) names.push_back(before + name);
    };
    if (hasField) add(fieldArrays, ColorBy::kFieldPrefix);
    add(surfaceArrays, ColorBy::kSurfacePrefix);
    throw InputError(fromFile ? description.field.spec : sources.surfaceSpec.text,
                     "no array '" + typed + "' to colour by", expected + didYouMean(typed, names));
}

LoadedSurface StepReader::surface(double key, const ProgressReport& progress) const
{
    const SurfaceSpec& spec = sources.surfaceSpec;
    const SurfaceArrays arrays{description.field.spec.empty(),
                               description.field.vectors,
                               colorsFromSurface ? colorBy.name : "",
                               std::nullopt,
                               pieces,
                               shares,
                               {}};
    if (memory.surface) return surfaceFromMemory(*memory.surface, spec.text, arrays);
    if (spec.kind == SurfaceSpec::Kind::file) {
        const StepFile& file = sources.surface.file(key);
        SurfaceArrays ofStep = arrays;
        ofStep.timeInFile = file.timeInFile;
        ofStep.parts = file.parts;
        return readSurfaceFile(file.path, ofStep, progress);
    }
    LoadedSurface surface;
    surface.mesh = makeBuiltinSurface(spec.text, key);
    surface.where = surface.mesh.name;
    surface.arrays = "none";
    return surface;
}

/// Slices and isosurfaces pass through cells, where there is flow. A boundary may be a wall without slip.
bool StepReader::looksUpCells() const
{
    const SurfaceSpec& spec = sources.surfaceSpec;
    return !description.field.resampleSpacing && (!spec.isCut() || spec.kind == SurfaceSpec::Kind::boundary);
}

FieldStep StepReader::field(double key, const ProgressReport& progress) const
{
    const std::string wanted = !colorsFromField ? "" : colorsAreShear() ? fieldVectors.name + ":mag" : colorBy.name;
    if (sources.field.anyMoment) return builtinField(key, wanted);
    FieldStep step = fieldFile(sources.field.file(key), wanted, progress);
    if (!wanted.empty() && !step.vectors && !step.cells && !step.cut) failColorBy(step.arrays);
    return step;
}

FieldStep StepReader::builtinField(double time, const std::string& wanted) const
{
    FieldStep step;
    step.vectors = makeBuiltinFlow(description.field.spec, boundsWorld, part, time);
    if (description.field.precision == FieldPrecision::float16) step.vectors = toHalf(step.vectors, step.tallies);
    step.vectors = inTiles(step.vectors);
    step.arrays = step.vectors->name + ":mag";
    step.offered = {{step.vectors->name, 3}};
    step.hasScalar = step.scalarIsLength = !wanted.empty() && wanted == step.arrays;
    step.scalarName = "|" + step.vectors->name + "|";
    return step;
}

FieldStep StepReader::fieldFile(const StepFile& file, const std::string& wanted, const ProgressReport& progress) const
{
    const GridRequest request{fieldVectors.name,
                              wanted,
                              sources.surfaceSpec.array,
                              description.field.precision == FieldPrecision::float16,
                              file.timeInFile,
                              ranksOnHost,
                              looksUpCells(),
                              file.parts};
    if (memory.grid) {
        GridFile grid(*memory.grid, file.path, request);
        return fieldStep(grid, wanted, progress);
    }
    GridFile grid(file.path, request, part, progress);
    return fieldStep(grid, wanted, progress);
}

/// With the surface that may be cut out of it.
FieldStep StepReader::fieldStep(GridFile& grid, const std::string& wanted, const ProgressReport& progress) const
{
    const SurfaceSpec& spec = sources.surfaceSpec;
    FieldStep step;
    step.arrays = grid.arrays();
    step.offered = grid.offered();
    step.timeSteps = grid.timeSteps();
    step.hasScalar = grid.hasScalar();
    step.scalarIsLength = grid.scalarIsVectorLength();
    step.scalarName = colorsAreShear() ? "|" + description.field.vectors + "|" : grid.scalarLabel();
    const bool surfaceFollows = !firstIsRead && spec.kind == SurfaceSpec::Kind::file;
    if (!wanted.empty() && !step.hasScalar && !surfaceFollows) return step;  // The caller says so.

    const bool ownCells = !grid.uniform() && !description.field.resampleSpacing;
    const bool inCells = ownCells && looksUpCells() && (!spec.isCut() || grid.hasCells());
    const bool carried = spec.isCut() && ownCells && !inCells;
    if (fieldVectors.shear && carried)
        throw InputError("--vectors", "found '" + description.field.vectors + "' on a cut through cells",
                         "a surface along a wall: one from a file, or boundary");
    if (spec.isCut()) step.cut = grid.cut(spec, carried, progress);
    if (carried) {
        step.hasScalar = false;  // It is on the cut.
    } else if (inCells) {
        progress("sorting the field's cells", 0);
        step.cells = std::make_shared<const CellSampler>(grid.takeCells());
    } else {
        if (!grid.uniform()) grid.resample(description.field.resampleSpacing, progress);
        if (auto scalar = grid.takeScalar()) step.scalar = std::make_shared<const GridField>(std::move(*scalar));
        step.vectors = std::make_shared<const GridField>(grid.takeVectors());
        if (!grid.vectorsAreBorrowed()) step.vectors = inTiles(step.vectors);
    }
    step.tallies = grid.tallies();
    return step;
}

}  // namespace aeolic
