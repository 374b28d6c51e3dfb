#pragma once

#include "render/backend.h"

namespace aeolic::gl {

/// What a GPU does at most, as measured: the limits that its LIC stage is judged by.
struct FetchRates {
    double lanesPerS = 0;  ///< 32-bit texels, gathered by fours along traces through an image of 4096x4096 or less.
    double bytesPerS = 0;  ///< Read and written in copying large buffers.
};

/// Takes about a second on a GPU. Throws InputError like makeBackend().
FetchRates measureFetchRates(const GpuChoice& choice);

}  // namespace aeolic::gl
