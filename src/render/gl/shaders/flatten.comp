// Takes from each value the mean of those around it (render/flatten.h).
#include "view.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
layout(binding = 1) uniform usampler2D flow;
layout(r32f, binding = 0) uniform image2D licImage;
layout(std430, binding = 1) readonly buffer Sums { uvec2 sums[]; };  // flatten_rows.comp
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, global pixels.
layout(location = 1) uniform int reach;
layout(location = 2) uniform ivec4 held;

void main()
{
    ivec2 pixel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, area.zw))) return;
    ivec2 texel = ivec2(pixel.x, pixel.y - view.firstRow);
    if (texelFetch(visible, pixel, 0).r == 0u || texelFetch(flow, texel, 0).r == 0u) return;
    uvec2 sum = uvec2(0u);
    for (int y = max(pixel.y - reach, held.y); y <= min(pixel.y + reach, held.w - 1); ++y)
        sum += sums[uint(y - held.y) * uint(held.z - held.x) + uint(pixel.x - held.x)];
    int count = max(int(sum.y), 1), signedSum = int(sum.x) - int(sum.y) * kFlatZero;
    float mean = float(signedSum) / (float(count) * float(kFlatPerUnit));
    imageStore(licImage, texel, vec4((imageLoad(licImage, texel).r - mean) * kFlatGain));
}
