// Ambient occlusion (render/occlusion.h): the share of the light that each pixel's own taps find hidden.
#include "view.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
layout(binding = 1) uniform sampler2D surface;  // invDepth, gradX, gradY, light
layout(std430, binding = 0) readonly buffer Depths { float depths[]; };  // Of the rows `held`; 0: background.
layout(std430, binding = 1) writeonly buffer Hidden { float hidden[]; };  // Of the rows `hiddenRows`.
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, global pixels.
layout(location = 1) uniform ivec4 held;
layout(location = 2) uniform ivec4 hiddenRows;
layout(location = 3) uniform float perFar;
layout(location = 4) uniform ivec2 taps[kPatterns * kTaps];  // In pixels.

void main()
{
    ivec2 pixel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, area.zw)) || texelFetch(visible, pixel, 0).r == 0u) return;
    vec3 facet = texelFetch(surface, ivec2(pixel.x, pixel.y - view.firstRow), 0).xyz;
    float scale = view.eyeAndFocal.w / facet.x, sum = 0.0;
    vec2 slope = facet.yz * scale;
    float perHeight = 1.0 / fma(slope.x, slope.x, fma(slope.y, slope.y, 1.0));
    int first = ((pixel.y & (kTile - 1)) * kTile + (pixel.x & (kTile - 1))) * kTaps;
    for (int k = 0; k < kTaps; ++k) {
        ivec2 tap = taps[first + k], at = pixel + tap;
        if (any(lessThan(at, held.xy)) || any(greaterThanEqual(at, held.zw))) continue;
        float there = depths[uint(at.y - held.y) * uint(held.z - held.x) + uint(at.x - held.x)];
        float toEye = (there - facet.x) * scale;
        float above = max(toEye - fma(slope.x, float(tap.x), slope.y * float(tap.y)), 0.0);
        float far = fma(toEye, toEye, float(max(tap.x * tap.x + tap.y * tap.y, 1)));
        sum = fma(above * above * max(fma(-far, perFar, 1.0), 0.0) / far, perHeight, sum);
    }
    hidden[uint(pixel.y - hiddenRows.y) * uint(area.z - area.x) + uint(pixel.x - area.x)] = sum * (1.0 / float(kTaps));
}
