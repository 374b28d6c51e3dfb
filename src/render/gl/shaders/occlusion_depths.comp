// The depths that ambient occlusion looks at: of the rows `area`, and zeros in the other rows held.
#include "view.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
layout(binding = 1) uniform sampler2D surface;  // invDepth, gradX, gradY, light
layout(std430, binding = 0) writeonly buffer Depths { float depths[]; };  // Of the rows held, in full width.
layout(location = 0) uniform ivec4 held;  // x0, y0, x1, y1, global pixels.
layout(location = 1) uniform ivec4 area;

void main()
{
    ivec2 pixel = held.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, held.zw))) return;
    float depth = 0.0;
    if (pixel.y >= area.y && pixel.y < area.w && texelFetch(visible, pixel, 0).r != 0u)
        depth = texelFetch(surface, ivec2(pixel.x, pixel.y - view.firstRow), 0).x;
    depths[uint(pixel.y - held.y) * uint(held.z - held.x) + uint(pixel.x - held.x)] = depth;
}
