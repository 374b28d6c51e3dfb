// Which of a pixel's eight neighbours lie on its own sheet of the surface (cpu/project/links.h).
#include "near_tile.glsl"
#include "one_sheet.glsl"
layout(binding = 0) uniform usampler2D flow;
layout(binding = 1) uniform sampler2D surface;  // invDepth, gradX, gradY, light
layout(r8ui, binding = 0) writeonly uniform uimage2D linkImage;
layout(location = 1) uniform float slackPerDepth;

void main()
{
    ivec2 pixel = nearPixel();
    if (pixel.x < 0) return;
    uint mask = 0u;
    if (texelFetch(flow, pixel, 0).r != 0u) {
        vec3 a = texelFetch(surface, pixel, 0).xyz;
        int bit = 0;
        for (int sy = -1; sy <= 1; ++sy)
            for (int sx = -1; sx <= 1; ++sx) {
                if (sx == 0 && sy == 0) continue;
                ivec2 other = pixel + ivec2(sx, sy);
                bool there = all(greaterThanEqual(other, ivec2(0))) && all(lessThan(other, tiling.size));
                if (there && texelFetch(flow, other, 0).r != 0u) {
                    vec3 b = texelFetch(surface, other, 0).xyz;
                    if (onOneSheet(predict(a, b, vec2(sx, sy), slackPerDepth))) mask |= 1u << bit;
                }
                ++bit;
            }
    }
    imageStore(linkImage, pixel, uvec4(mask));
}
