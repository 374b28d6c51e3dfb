// The mean of each edge pixel's samples.
#include "view.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D edges;
layout(std430, binding = 4) writeonly buffer Pixels { uint pixels[]; };  // RGBA bytes of the rows `shown`.
layout(std430, binding = 5) readonly buffer Sums { uvec4 sums[]; };
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, global pixels.
layout(location = 1) uniform ivec4 shown;
layout(location = 2) uniform uint background;  // What shows where nothing else does.

void main()
{
    ivec2 pixel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, area.zw))) return;
    if (texelFetch(edges, ivec2(pixel.x, pixel.y - view.firstRow), 0).r == 0u) return;
    uint width = uint(area.z - area.x);
    uvec4 sum = sums[uint(pixel.y - area.y) * width + uint(pixel.x - area.x)];
    uint color = background;
    if (sum.w > 0u) {
        color = ((sum.w + uint(kSamples) / 2u) / uint(kSamples)) << 24;
        for (int c = 0; c < 3; ++c) color |= ((sum[c] + sum.w / 2u) / sum.w) << uint(8 * c);
    }
    pixels[uint(pixel.y - shown.y) * width + uint(pixel.x - shown.x)] = color;
}
