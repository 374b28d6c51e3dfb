// Ambient occlusion (render/occlusion.h): the share of the light that gets to each pixel of the surface.
#include "view.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
layout(binding = 1) uniform sampler2D surface;  // invDepth, gradX, gradY, light
layout(std430, binding = 0) readonly buffer Depths { float depths[]; };  // Of the rows `held`; 0: background.
layout(std430, binding = 1) readonly buffer Hidden { float hidden[]; };  // Of the rows `hiddenRows`.
layout(std430, binding = 2) writeonly buffer Open { float open[]; };     // Of the rows of `area`.
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, global pixels.
layout(location = 1) uniform ivec4 held;
layout(location = 2) uniform ivec4 hiddenRows;

void main()
{
    ivec2 pixel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, area.zw))) return;
    uint width = uint(area.z - area.x);
    float result = 1.0;
    if (texelFetch(visible, pixel, 0).r != 0u) {
        vec3 facet = texelFetch(surface, ivec2(pixel.x, pixel.y - view.firstRow), 0).xyz;
        float slack = kSlackPx / (view.eyeAndFocal.w / facet.x), sum = 0.0, count = 0.0;
        for (int v = -kBefore; v < kBefore; ++v)
            for (int u = -kBefore; u < kBefore; ++u) {
                ivec2 at = pixel + ivec2(u, v);
                if (any(lessThan(at, hiddenRows.xy)) || any(greaterThanEqual(at, hiddenRows.zw))) continue;
                float there = depths[uint(at.y - held.y) * width + uint(at.x - held.x)];
                float predicted = fma(facet.y, float(u), fma(facet.z, float(v), facet.x));
                if (there == 0.0 || abs(there - predicted) > slack) continue;
                sum += hidden[uint(at.y - hiddenRows.y) * width + uint(at.x - hiddenRows.x)];
                count += 1.0;
            }
        result = 1.0 / fma(sum / max(count, 1.0), kOcclusionStrength, 1.0);
    }
    open[uint(pixel.y - area.y) * width + uint(pixel.x - area.x)] = result;
}
