#include "render/gl/project/row_counts.h"

#include <algorithm>
#include <cstring>

#include "render/gl/device/dispatch.h"
#include "render/gl/device/draw_visibility.h"
#include "render/gl/device/gl_blocks.h"

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

std::vector<std::int64_t> CoverageCount::count(Programs& programs, const GpuScene& scene, const View& view)
{
    const int width = view.camera.width, height = view.camera.height;
    if (!ids_ || ids_.width() != width || ids_.height() != height) {
        target_ = {};
        ids_ = Texture::image(GL_R32UI, width, height);
        depth_ = Texture::image(GL_DEPTH_COMPONENT32F, width, height);
        target_ = makeTarget(ids_, depth_);
    }
    const ViewBlock block = makeViewBlock(view, 0, height);
    if (block_.bytes() == 0) block_ = Buffer(sizeof block, GL_DYNAMIC_STORAGE_BIT);
    block_.write(0, sizeof block, &block);
    bindUniforms(kViewBinding, block_);
    drawVisibility(programs, scene, view, target_, {0, 0, width, height});
    counts_.start(programs, ids_, 0, height);
    counts_.wait();
    std::vector<std::int64_t> covered;
    covered.reserve(std::size_t(height));
    for (int y = 0; y < height; ++y) covered.push_back(counts_.get(y, y + 1));
    return covered;
}

}  // namespace aeolic::gl
