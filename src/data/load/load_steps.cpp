#include "data/load/load_steps.h"

#include "aeolic/error.h"
#include "base/half.h"
#include "base/memory.h"
#include "data/builtin/flows.h"
#include "data/builtin/surfaces.h"
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
    : description(d), memory(m), part(p), pieces(s), sources(d)
{
    checkSources(sources.surfaceSpec, description, part);
    if (pieces.split() && !memory.surface) shares = pieceBytesOf(sources.surface.file(sources.surface.firstKey()).path);
}

void StepReader::failColorBy(const std::string& arrays) const
{
    const bool fromFile = !description.field.spec.empty() && !isBuiltinFlow(description.field.spec);
    throw InputError(fromFile ? description.field.spec : sources.surfaceSpec.text,
                     "no array '" + description.shading.colorBy + "' to colour by",
                     "one of: " + arrays + nearestArray(description.shading.colorBy, arraysListed(arrays)));
}

LoadedSurface StepReader::surface(double key, const ProgressReport& progress) const
{
    const SurfaceSpec& spec = sources.surfaceSpec;
    const SurfaceArrays arrays{description.field.spec.empty(),
                               description.field.vectors,
                               description.shading.colorBy,
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

FieldStep StepReader::field(double key, const ProgressReport& progress) const
{
    const std::string colorBy = colorsFromField ? description.shading.colorBy : "";
    if (sources.field.anyMoment) return builtinField(key, colorBy);
    FieldStep step = fieldFile(sources.field.file(key), colorBy, progress);
    if (!colorBy.empty() && !step.vectors && !step.cut)
        failColorBy(step.arrays + (surfaceArrays == "none" ? "" : "; on the surface: " + surfaceArrays));
    return step;
}

FieldStep StepReader::builtinField(double time, const std::string& colorBy) const
{
    FieldStep step;
    step.vectors = makeBuiltinFlow(description.field.spec, boundsWorld, part, time);
    if (description.field.precision == FieldPrecision::float16) step.vectors = toHalf(step.vectors, step.tallies);
    step.vectors = inTiles(step.vectors);
    step.arrays = step.vectors->name + ":mag";
    step.offered = {{step.vectors->name, 3}};
    step.hasScalar = step.scalarIsLength = !colorBy.empty() && colorBy == step.arrays;
    step.scalarName = "|" + step.vectors->name + "|";
    return step;
}

FieldStep StepReader::fieldFile(const StepFile& file, const std::string& colorBy, const ProgressReport& progress) const
{
    const GridRequest request{description.field.vectors, colorBy,
                              sources.surfaceSpec.array, description.field.precision == FieldPrecision::float16,
                              file.timeInFile,           ranksOnHost};
    if (memory.grid) {
        GridFile grid(*memory.grid, file.path, request);
        return fieldStep(grid, colorBy, progress);
    }
    GridFile grid(file.path, request, part, progress);
    return fieldStep(grid, colorBy, progress);
}

/// With the surface that may be cut out of it.
FieldStep StepReader::fieldStep(GridFile& grid, const std::string& colorBy, const ProgressReport& progress) const
{
    const SurfaceSpec& spec = sources.surfaceSpec;
    FieldStep step;
    step.arrays = grid.arrays();
    step.offered = grid.offered();
    step.timeSteps = grid.timeSteps();
    step.hasScalar = grid.hasScalar();
    step.scalarIsLength = grid.scalarIsVectorLength();
    step.scalarName = grid.scalarLabel();
    if (!colorBy.empty() && !step.hasScalar) return step;  // The caller knows what else there is to choose from.

    const bool carried = spec.isCut() && !grid.uniform() && !description.field.resampleSpacing;
    if (spec.isCut()) step.cut = grid.cut(spec, carried, progress);
    if (carried) {
        step.hasScalar = false;  // It is on the cut.
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
