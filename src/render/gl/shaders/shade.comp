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
    uvec4 colors[64];  // 256 entries: bytes R, G, B, 0.
    float scalarLo, entriesPerScalar, contrast, blend;
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

uint tableEntry(float scalar)
{
    if (isnan(scalar)) return kMaskedGray;
    uint entry = uint(clamp((scalar - palette.scalarLo) * palette.entriesPerScalar, 0.0, 255.0));
    return palette.colors[entry >> 2][entry & 3u];
}

uint channel(float base, float m, float highlight, float shadow, float toByte)
{
    float shown = fma(m >= 0.0 ? (1.0 - base) * highlight : base * shadow, m, base);
    return uint(clamp(fma(shown, toByte, 0.5), 0.0, 255.0));
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
        float m = tone(z * (palette.contrast * 0.70710678)) * palette.blend;
        float toByte = (palette.lighting ? texelFetch(surface, texel, 0).w : 1.0) * 255.0;
        if (palette.useScalar) {
            uint entry = tableEntry(texelFetch(scalars, texel, 0).r);
            color = 0xFF000000u;
            for (int k = 0; k < 3; ++k)
                color |= channel(float(bitfieldExtract(entry, 8 * k, 8)) * (1.0 / 255.0), m, kColorHighlight, kColorShadow, toByte) << uint(8 * k);
        } else {
            color = channel(1.0 - 0.5 * palette.blend, m, 1.0, 1.0, toByte) * 0x010101u | 0xFF000000u;
        }
    }
    pixels[uint(pixel.y - area.y) * uint(area.z - area.x) + uint(pixel.x - area.x)] = color;
}
