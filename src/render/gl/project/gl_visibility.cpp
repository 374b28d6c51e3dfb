#include "render/gl/project/gl_visibility.h"

#include "render/gl/device/arguments.h"
#include "render/gl/device/gl_blocks.h"
#include "render/gl/device/raster.h"

namespace aeolic::gl {

void drawVisibility(Programs& programs, const GpuScene& scene, const View& view, GLuint target, const Extent& area)
{
    RasterPass pass;
    pass.program = programs.drawing("visibility");
    pass.target = target;
    pass.width = view.camera.width;
    pass.height = view.camera.height;
    pass.area = area;
    pass.farthest = view.farInvDepth * float(view.nearDepth);  // Nothing beyond the far plane is nearer.
    pass.frontFacesOnly = view.frontFacesOnly;
    rasterize(scene, pass);
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
