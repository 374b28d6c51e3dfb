// Samples at which nothing is seen yet.
#include "edge_samples.glsl"
layout(local_size_x = 64) in;

void main()
{
    uint words = min(edgeList.edgeCount - min(edgeList.edgeCount, uint(held.x)), uint(held.y)) * uint(2 * kSamples);
    for (uint i = gl_GlobalInvocationID.x; i < words; i += gl_NumWorkGroups.x * 64u) samples[i] = 0u;
}
