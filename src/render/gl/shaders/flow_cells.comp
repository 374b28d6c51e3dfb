// The flow as traces read it, twice: all of it, and its open part. A pixel is open where it and kOpenRings rings around
// it are linked all round. Where four open texels meet, a step of kOpenReachPx stays on it (render/limits.h). The
// noise is sharpened for the hierarchical method (docs/hierarchical.md).
#include "near_tile.glsl"
#include "flow_texel.glsl"
layout(binding = 0) uniform usampler2D flow;
layout(binding = 1) uniform usampler2D links;
layout(r32ui, binding = 0) writeonly uniform uimage2D openImage;
layout(r32ui, binding = 1) writeonly uniform uimage2D wholeImage;
layout(location = 1) uniform vec2 sharpening;  // Sharpness, 1 / noise unit.

uint linksAt(ivec2 p)
{
    bool there = all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, tiling.size));
    return there ? texelFetch(links, p, 0).r : 0u;
}

uint displacement(float v) { return uint(clamp(int(roundEven(v)), -2048, 2047)) & 0xFFFu; }

// Displacements are read with the bits below them, and are rounded here with those in mind (cpu/lic/flow_cells.h).
uint cellTexel(int dx, int dy, int noise)
{
    precise float y = float(dy) - float(noise) * (1.0 / 256.0);
    uint low20 = displacement(y) << kDyShift | uint(noise);
    precise float x = float(dx) - float(low20) * (1.0 / 1048576.0);
    return displacement(x) << kDxShift | low20;
}

float noiseAt(ivec2 p) { return float(texelNoise(texelFetch(flow, p, 0).r)); }

void main()
{
    ivec2 pixel = nearPixel();
    if (pixel.x < 0) return;
    uint texel = texelFetch(flow, pixel, 0).r, whole = 0u, open = 0u;
    if (texel != 0u) {
        uint mask = linksAt(pixel);
        float noise = float(texelNoise(texel)), excess = 0.0;
        if (sharpening.x > 0.0) {  // A linked neighbour is there.
            if ((mask & 0x10u) != 0u) excess += noise - noiseAt(pixel + ivec2(1, 0));
            if ((mask & 0x08u) != 0u) excess += noise - noiseAt(pixel - ivec2(1, 0));
            if ((mask & 0x40u) != 0u) excess += noise - noiseAt(pixel + ivec2(0, 1));
            if ((mask & 0x02u) != 0u) excess += noise - noiseAt(pixel - ivec2(0, 1));
        }
        float sharp = fma(excess, sharpening.x, noise - float(kNoiseZero));
        int byte = clamp(int(roundEven(fma(sharp, sharpening.y, float(kNoiseZero)))), kLeastNoise, kMostNoise);
        whole = cellTexel(texelDx(texel), texelDy(texel), byte);
        uint all8 = mask;
        for (int y = -kOpenRings; y <= kOpenRings; ++y)
            for (int x = -kOpenRings; x <= kOpenRings && all8 == 0xFFu; ++x) all8 &= linksAt(pixel + ivec2(x, y));
        open = all8 == 0xFFu ? whole : 0u;
    }
    imageStore(wholeImage, pixel, uvec4(whole));
    imageStore(openImage, pixel, uvec4(open));
}
