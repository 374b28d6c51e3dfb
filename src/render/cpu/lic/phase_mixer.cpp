#include "render/cpu/lic/phase_mixer.h"

#include <utility>

#include "base/parallel.h"

namespace aeolic::cpu {

void PhaseMixer::keep(int which, LicImage& values)
{
    LicImage& kept = kept_[std::size_t(which)];
    std::swap(kept, values);
    values.resize(kept.valid());
}

void PhaseMixer::mix(const GBuffer& buffer, const std::array<float, phase_mix::kPhases>& weights,
                     LicImage& values) const
{
    static_assert(phase_mix::kPhases == 3);
    const Extent& rows = kept_[0].valid();
    values.resize(rows);
    const float a = weights[0], b = weights[1], c = weights[2];
    parallelRanges(std::size_t(rows.empty() ? 0 : rows.height()), 16, [&](std::size_t begin, std::size_t end) {
        for (int y = rows.y0 + int(begin); y < rows.y0 + int(end); ++y) {
            const ColumnSpan& columns = buffer.surfaceColumns(y);
            const float *first = kept_[0].row(y), *second = kept_[1].row(y), *third = kept_[2].row(y);
            float* out = values.row(y);
            for (int x = columns.x0; x < columns.x1; ++x) out[x] = a * first[x] + b * second[x] + c * third[x];
        }
    });
}

}  // namespace aeolic::cpu
