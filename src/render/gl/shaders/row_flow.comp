// For each row the first and last + 1 column with flow, and the largest vertical displacement. A row a workgroup.
#include "flow_texel.glsl"
layout(local_size_x = 128) in;
layout(binding = 0) uniform usampler2D flow;
layout(std430, binding = 0) writeonly buffer Facts { uvec4 facts[]; };
layout(location = 0) uniform ivec3 rows;  // First row held, how many, columns.

shared uint first, past, largest;

void main()
{
    if (gl_LocalInvocationIndex == 0u) {
        first = 0xFFFFFFFFu;
        past = 0u;
        largest = 0u;
    }
    barrier();
    int row = int(gl_WorkGroupID.x);
    for (int x = int(gl_LocalInvocationIndex); x < rows.z; x += 128) {
        uint texel = texelFetch(flow, ivec2(x, rows.x + row), 0).r;
        if (texel == 0u) continue;
        atomicMin(first, uint(x));
        atomicMax(past, uint(x) + 1u);
        atomicMax(largest, uint(abs(texelDy(texel))));
    }
    barrier();
    if (gl_LocalInvocationIndex == 0u) facts[row] = past == 0u ? uvec4(0u) : uvec4(first, past, largest, 0u);
}
