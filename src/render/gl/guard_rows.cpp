#include "render/gl/guard_rows.h"

#include <algorithm>

namespace aeolic::gl {
namespace {

struct Rows {
    int y0, y1;  // Global.
};

// Moves rows between a layer and memory; `move(x, y, z, width, height, bytes, pixels)` is the call that does it.
template <class Move>
void moveRows(const ImageRows& rows, const Rows& range, int layer, const Move& move)
{
    const int y0 = std::max(range.y0, rows.valid.y0), y1 = std::min(range.y1, rows.valid.y1);
    if (y0 >= y1) return;
    const int width = rows.valid.width();
    move(0, y0 - rows.valid.y0, layer, width, y1 - y0, GLsizei(rows.strideBytes) * (y1 - y0),
         rows.at(rows.valid.x0, y0));
}

}  // namespace

void GuardRowExchange::begin(GuardExchange& guards, const Extent& compute, StageTimers& timers)
{
    timers_ = &timers;
    guards_ = &guards;
    compute_ = compute;
}

void GuardRowExchange::receive(const Extent& valid, const std::vector<Plane>& planes, const TraceReach& reach)
{
    std::vector<ImageRows> rows;
    const bool isLinks = planes[0].texture->format() == GL_R8UI;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if (words_.size() <= i) words_.push_back(std::make_unique<Image<std::uint32_t>>());
        if (isLinks) {
            bytes_.resize(valid);
            rows.push_back(imageRows(bytes_));
        } else {
            words_[i]->resize(valid);
            rows.push_back(imageRows(*words_[i]));
        }
    }
    const GuardRows sent = guards_->sentRows(reach), needed = guards_->rows(reach);
    const Rows upper{compute_.y0, std::min(compute_.y0 + sent.above, compute_.y1)};
    const Rows lower{std::max(compute_.y1 - sent.below, upper.y1), compute_.y1};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ROW_LENGTH, GLint(rows[0].strideBytes / rows[0].pixelBytes));
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const TexelFormat texel = texelFormat(planes[i].texture->format());
        for (const Rows& range : {upper, lower})
            moveRows(rows[i], range, planes[i].layer, [&](int x, int y, int z, int w, int h, GLsizei bytes, void* to) {
                glGetTextureSubImage(planes[i].texture->id(), 0, x, y, z, w, h, 1, texel.format, texel.type, bytes, to);
            });
    }
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    timers_->end();
    guards_->receive(rows, reach);
    timers_->begin(Stage::convolve);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, GLint(rows[0].strideBytes / rows[0].pixelBytes));
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const Texture& texture = *planes[i].texture;
        const TexelFormat texel = texelFormat(texture.format());
        for (const Rows& range :
             {Rows{compute_.y0 - needed.above, compute_.y0}, Rows{compute_.y1, compute_.y1 + needed.below}})
            moveRows(rows[i], range, planes[i].layer,
                     [&](int x, int y, int z, int w, int h, GLsizei, const void* from) {
                         if (texture.layered())
                             glTextureSubImage3D(texture.id(), 0, x, y, z, w, h, 1, texel.format, texel.type, from);
                         else
                             glTextureSubImage2D(texture.id(), 0, x, y, w, h, texel.format, texel.type, from);
                     });
    }
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void GuardRowExchange::receiveFlow(const FrameImages& images, const TraceReach& reach)
{
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    receive(images.valid, {{&images.flow, 0}}, reach);
}

void GuardRowExchange::receiveLinks(const FrameImages& images, const TraceReach& reach)
{
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    receive(images.valid, {{&images.links, 0}}, reach);
}

void GuardRowExchange::receiveLevel(const FrameImages& images, int level, bool withWaves, const TraceReach& reach)
{
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    std::vector<Plane> planes;
    for (int direction = 0; direction < 2; ++direction) {
        const int layer = 2 * level + direction;
        planes.push_back({&images.places, layer});
        planes.push_back({&images.metas, layer});
        if (withWaves) planes.push_back({&images.waves, layer});
    }
    receive(images.valid, planes, reach);
}

}  // namespace aeolic::gl
