// The blending stage (render/shading_model.h): base colour, light and LIC on the surface, the background elsewhere.
#include "view.glsl"
#include "arithmetic.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
layout(binding = 1) uniform sampler2D surface;  // invDepth, gradX, gradY, light
layout(binding = 2) uniform usampler2D flow;
layout(binding = 3) uniform sampler2D lic;
layout(binding = 4) uniform sampler2D scalars;
layout(std430, binding = 0) writeonly buffer Pixels { uint pixels[]; };  // RGBA bytes of the rows shaded.
layout(std140, binding = 4) uniform PaletteBlock {
    uvec4 base[65], dark[65], bright[65];  // Palette's entries; bytes R, G, B from the lowest, then the knee in `base`.
    vec4 plain;  // Grays: without a streak, the darkest, the brightest.
    float scalarLo, entriesPerScalar, contrast;
    uint background;
    bool useScalar, lighting, hasLic;
} palette;
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, global pixels.

// Turns LIC of unit variance into -1 to 1 with an even histogram: erf.
float tone(float z)
{
    float x = abs(z);
    float poly = fma(x, fma(x, fma(x, fma(x, kErf3, kErf2), kErf1), kErf0), 1.0);
    float squared = poly * poly, value = 1.0 - 1.0 / (squared * squared);
    return z < 0.0 ? -value : value;
}

uint paletteEntry(float scalar)
{
    if (isnan(scalar)) return kMaskedEntry;
    return uint(clamp((scalar - palette.scalarLo) * palette.entriesPerScalar, 0.0, 255.0));
}

float byteOf(uint word, int k) { return float(bitfieldExtract(word, 8 * k, 8)); }

// `end`: the colour of the brightest or the darkest streak; `part`: of the way there.
uint channel(float base, float end, float part, float light)
{
    float shown = fma(end - base, part, base);
    return uint(clamp(fma(shown, light, 0.5), 0.0, 255.0));
}

void main()
{
    ivec2 pixel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, area.zw))) return;
    ivec2 texel = ivec2(pixel.x, pixel.y - view.firstRow);
    uint color = palette.background;
    if (texelFetch(visible, pixel, 0).r != 0u) {
        bool streaks = palette.hasLic && texelFetch(flow, texel, 0).r != 0u;
        float z = streaks ? texelFetch(lic, texel, 0).r : 0.0;
        float m = tone(z * (palette.contrast * 0.70710678));
        float light = palette.lighting ? texelFetch(surface, texel, 0).w : 1.0;
        if (palette.useScalar) {
            uint entry = paletteEntry(texelFetch(scalars, texel, 0).r), at = entry >> 2, k = entry & 3u;
            uint base = palette.base[at][k];
            float knee = fma(byteOf(base, 3), 1.0 / float(kKneeZero), -1.0);
            bool brightens = m >= knee;
            uint end = brightens ? palette.bright[at][k] : palette.dark[at][k];
            float part = abs(m - knee) / (brightens ? 1.0 - knee : 1.0 + knee);
            color = 0xFF000000u;
            for (int c = 0; c < 3; ++c) color |= channel(byteOf(base, c), byteOf(end, c), part, light) << uint(8 * c);
        } else {
            float end = 255.0 * (m >= 0.0 ? palette.plain.z : palette.plain.y);
            color = channel(255.0 * palette.plain.x, end, abs(m), light) * 0x010101u | 0xFF000000u;
        }
    }
    pixels[uint(pixel.y - area.y) * uint(area.z - area.x) + uint(pixel.x - area.x)] = color;
}
