// What flatten_rows.comp sums up: the values of the rows of `area` as whole numbers, and 0 where there is no flow and in
// the other rows held.
#include "view.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
layout(binding = 1) uniform usampler2D flow;
layout(binding = 2) uniform sampler2D lic;
layout(std430, binding = 0) writeonly buffer Words { uint words[]; };  // Of the rows held, in full width.
layout(location = 0) uniform ivec4 held;  // x0, y0, x1, y1, global pixels.
layout(location = 1) uniform ivec4 area;

void main()
{
    ivec2 pixel = held.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, held.zw))) return;
    ivec2 texel = ivec2(pixel.x, pixel.y - view.firstRow);
    uint word = 0u;
    if (pixel.y >= area.y && pixel.y < area.w && texelFetch(visible, pixel, 0).r != 0u && texelFetch(flow, texel, 0).r != 0u)
        word = uint(clamp(fma(texelFetch(lic, texel, 0).r, float(kFlatPerUnit), float(kFlatZero) + 0.5), 1.0,
                          float(2 * kFlatZero - 1)));
    words[uint(pixel.y - held.y) * uint(held.z - held.x) + uint(pixel.x - held.x)] = word;
}
