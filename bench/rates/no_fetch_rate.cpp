#include <stdexcept>

#include "rates/fetch_rate.h"

/// For builds without OpenGL (AEOLIC_GL=OFF), in which no backend is gl.
namespace aeolic::gl {

FetchRates measureFetchRates(const GpuChoice&)
{
    throw std::logic_error("a build without OpenGL measures no GPU");
}

}  // namespace aeolic::gl
