#include "data/field_copies.h"

#include <cstdint>
#include <utility>

#include "base/half.h"
#include "base/large_memory.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "data/bricks.h"

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

}  // namespace

std::shared_ptr<const GridField> componentOf(const GridField& vectors, int component)
{
    auto scalar = std::make_shared<GridField>(vectors);
    scalar->components = 1;
    const std::size_t count = scalar->sampleCount();
    requireMemory(vectors.name, "a component to colour by", scalar->bytes());
    auto values = makeLargeArray<float>(count);
    const float* source = vectors.floats() + component;
    parallelRanges(count, std::size_t{1} << 15, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) values[i] = source[i * std::size_t(vectors.components)];
    });
    scalar->samples = std::shared_ptr<float>(values.release(), FreeLarge());
    return scalar;
}

std::shared_ptr<const GridField> halfField(const std::shared_ptr<const GridField>& field, std::vector<Tally>& tallies)
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

}  // namespace aeolic
