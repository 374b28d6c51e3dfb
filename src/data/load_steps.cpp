#include "data/load_steps.h"

#include <fmt/format.h>

#include "base/half.h"
#include "base/memory.h"
#include "data/builtin_flows.h"
#include "data/vtk/grid_file.h"

namespace aeolic {

namespace {

std::shared_ptr<const GridField> toHalf(const std::shared_ptr<const GridField>& field,
                                        std::vector<std::string>& warnings)
{
    const std::size_t count = field->sampleCount() * std::size_t(field->components);
    requireMemory(field->name, "the field in half precision", 2 * count);
    GridField half = *field;
    const auto memory =
        std::shared_ptr<std::uint16_t[]>(new std::uint16_t[count + 2]);  // Gathers may read past the end.
    const std::size_t clamped = halvesFromFloatsParallel(field->floats(), memory.get(), count);
    if (clamped > 0) warnings.push_back(fmt::format("{}: {} values beyond 65504 were set to it", field->name, clamped));
    half.samples = std::shared_ptr<const void>(memory, memory.get());
    half.precision = FieldPrecision::float16;
    return std::make_shared<const GridField>(std::move(half));
}

}  // namespace

LoadedSurface loadSurfaceFile(const StepFile& file, const SceneDescription& description, bool wantVectors,
                              const FieldPart& part, const ProgressReport& progress)
{
    return readSurfaceFile(file.path,
                           {wantVectors, description.field.vectors, description.shading.colorBy, file.timeInFile, part},
                           progress);
}

FieldStep makeFieldStep(const SceneDescription& description, const Bounds& boundsWorld, const FieldPart& part,
                        double time, const std::string& colorBy)
{
    FieldStep step;
    step.vectors = makeBuiltinFlow(description.field.spec, boundsWorld, part, time);
    if (description.field.precision == "half") step.vectors = toHalf(step.vectors, step.warnings);
    step.arrays = step.vectors->name + ":mag";
    step.offered = {{step.vectors->name, 3}};
    step.hasScalar = step.scalarIsLength = !colorBy.empty() && colorBy == step.arrays;
    step.scalarName = "|" + step.vectors->name + "|";
    return step;
}

FieldStep loadFieldFile(const StepFile& file, const SceneDescription& description, const SurfaceSpec& spec,
                        const FieldPart& part, const std::string& colorBy, const ProgressReport& progress)
{
    GridFile grid(
        file.path,
        {description.field.vectors, colorBy, spec.array, description.field.precision == "half", file.timeInFile}, part,
        progress);
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
    }
    step.warnings = grid.warnings();
    return step;
}

}  // namespace aeolic
