#include "render/gl/project/row_counts.h"

#include <algorithm>
#include <cstring>

#include "render/gl/device/arguments.h"
#include "render/gl/device/dispatch.h"

namespace aeolic::gl {

void RowCounts::start(Programs& programs, const Texture& visible, int y0, int y1)
{
    y0_ = y0;
    y1_ = y1;
    if (y0 >= y1) return;
    const std::size_t bytes = std::size_t(y1 - y0) * 4;
    counts_.reserve(bytes);
    const GLuint program = programs.compute("row_counts");
    setInts(program, 0, y0, y1 - y0, visible.width());
    visible.bind(0);
    bindStorage(0, counts_.get());
    dispatch(program, GLuint(y1 - y0));
    copy_.copy(counts_.get(), bytes);
    copy_.start();
}

void RowCounts::wait()
{
    found_ = copy_.wait();
}

std::int64_t RowCounts::get(int y0, int y1) const
{
    std::int64_t sum = 0;
    for (int y = std::max(y0, y0_); y < std::min(y1, y1_); ++y) {
        std::uint32_t row;
        std::memcpy(&row, found_ + std::size_t(y - y0_) * sizeof row, sizeof row);
        sum += row;
    }
    return sum;
}

}  // namespace aeolic::gl
