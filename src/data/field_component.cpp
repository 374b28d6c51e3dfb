#include "data/field_component.h"

#include <cmath>
#include <utility>

#include "base/large_memory.h"
#include "base/memory.h"
#include "base/parallel.h"

namespace aeolic {

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

}  // namespace aeolic
