#include "data/load/load_steps.h"

#include "base/half.h"
#include "base/memory.h"
#include "data/builtin/flows.h"
#include "data/field_tiles.h"
#include "data/vtk/grid/grid_file.h"

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

}  // namespace

LoadedSurface loadSurfaceFile(const StepFile& file, const SceneDescription& description, bool wantVectors,
                              const FieldPart& part, const std::vector<std::uint64_t>& shares,
                              const ProgressReport& progress)
{
    return readSurfaceFile(
        file.path, {wantVectors, description.field.vectors, description.shading.colorBy, file.timeInFile, part, shares},
        progress);
}

FieldStep makeFieldStep(const SceneDescription& description, const Bounds& boundsWorld, const FieldPart& part,
                        double time, const std::string& colorBy)
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

FieldStep loadFieldFile(const StepFile& file, const SceneDescription& description, const SurfaceSpec& spec,
                        const FieldPart& part, const std::string& colorBy, const ProgressReport& progress)
{
    GridFile grid(file.path,
                  {description.field.vectors, colorBy, spec.array,
                   description.field.precision == FieldPrecision::float16, file.timeInFile},
                  part, progress);
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
        step.vectors = inTiles(std::make_shared<const GridField>(grid.takeVectors()));
    }
    step.tallies = grid.tallies();
    return step;
}

}  // namespace aeolic
