#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/image.h"
#include "render/lic/near_flow.h"
#include "render/limits.h"

namespace aeolic {

/// One pixel's flow, as the LIC stage reads it: 12 bits of signed displacement per step in x, 12 in y, 8 of noise.
/// One 64-bit gather then brings two neighbours. Noise 0 means "no flow here": background, or outside the field.
namespace flow_texel {

inline constexpr int kDisplacementMax = 2047;
inline constexpr int kDxShift = 20, kDyShift = 8;  ///< Where the fields of 12 bits begin; the noise is below.
inline constexpr int kNoiseZero = 128;             ///< The noise byte that means 0; bytes 1 to 255 are -1 to 1.
inline constexpr int kNoiseMost = 127;             ///< What 1 is above that.
inline constexpr float kNoiseUnit = 1.0f / float(kNoiseMost);

inline std::uint32_t pack(int dx, int dy, int noise)
{
    return (std::uint32_t(dx) << kDxShift) | ((std::uint32_t(dy) & 0xFFFu) << kDyShift) | std::uint32_t(noise);
}
inline int dx(std::uint32_t texel)
{
    return std::int32_t(texel) >> 20;
}
inline int dy(std::uint32_t texel)
{
    return std::int32_t(texel << 12) >> 20;
}
inline int noise(std::uint32_t texel)
{
    return int(texel & 0xFFu);
}

}  // namespace flow_texel

/// `drawn` with `rows` more on either side, those that links of its pixels need, as far as they are in `valid`. Where
/// these rows are another rank's they are drawn for that alone.
inline Extent withNeighbours(const Extent& drawn, const Extent& valid, int rows = limits::kLinkRows)
{
    return {valid.x0, std::max(drawn.y0 - rows, valid.y0), valid.x1, std::min(drawn.y1 + rows, valid.y1)};
}

/// Each of the eight neighbours of a pixel that lies on the same sheet of the surface has a bit. The neighbour (sx, sy)
/// has bit k = (sy + 1) * 3 + (sx + 1), or one less after the centre: NW N NE W E SW S SE.
inline int linkBit(int sx, int sy)
{
    const int k = (sy + 1) * 3 + (sx + 1);
    return k > 4 ? k - 1 : k;
}

/// What the projection stage leaves for the LIC and blending stages (paper, section 3: "three 2D textures").
/// All images share one valid extent; a pixel outside the surface has invDepth 0.
struct GBuffer {
    Image<float> invDepth;       ///< 1 / eye depth, 1 / View::unitWorld; 0: background.
    Image<float> gradX, gradY;   ///< Change of invDepth per pixel to the right / down on the pixel's own facet.
    Image<std::uint32_t> flow;   ///< flow_texel; displacement in units of `flowUnitPx` per step.
    Image<std::uint8_t> links;   ///< linkBit mask.
    Image<float> light;          ///< As shading_model.h says, (0, 1]; negative where no streaks show.
    Image<float> scalar;         ///< The surface is coloured by it; NaN: masked. Only sized when the scene has one.
    Image<std::uint8_t> colors;  ///< Which palette's table colours the pixel; only sized where the scene has several.
    /// [valid().height()]: outside of these columns the row is background for certain. All columns unless found out.
    /// A span begins at a multiple of Image::kApron columns from the first.
    std::vector<ColumnSpan> surface;
    float flowUnitPx = 1;  ///< Pixels per unit of the 12-bit displacement: a power of two, the same on every rank.

    void resize(const Extent& valid, bool withScalar, bool withColors = false)
    {
        flow.resize(valid);
        links.resize(valid);
        allColumns();
        invDepth.resize(valid);
        gradX.resize(valid);
        gradY.resize(valid);
        light.resize(valid);
        if (withScalar) scalar.resize(valid);
        if (withColors) colors.resize(valid);
    }
    /// Makes `valid` the extent of flow and links, which are all that the LIC stage reads. Rows that were there stay.
    void rollFlow(const Extent& valid)
    {
        flow.roll(valid, valid.y0);
        links.roll(valid, valid.y0);
        allColumns();
    }
    const Extent& valid() const { return flow.valid(); }
    ColumnSpan& surfaceColumns(int y) { return surface[std::size_t(y - valid().y0)]; }
    const ColumnSpan& surfaceColumns(int y) const { return surface[std::size_t(y - valid().y0)]; }
    /// From the first column of the surface in any of the rows [y0, y1) to the last.
    ColumnSpan surfaceColumns(int y0, int y1) const
    {
        ColumnSpan all;
        for (int y = y0; y < y1; ++y) all = all.with(surfaceColumns(y));
        return all;
    }

private:
    void allColumns() { surface.assign(std::size_t(std::max(valid().height(), 0)), {valid().x0, valid().x1}); }
};

}  // namespace aeolic
