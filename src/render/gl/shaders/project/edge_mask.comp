// Which pixels lie at an edge (cpu/edges/find_edges.h). A block a workgroup, which also numbers its edge pixels.
#include "view.glsl"
#include "one_sheet.glsl"
#include "edge_blocks.glsl"
#include "edge_list.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
layout(binding = 1) uniform sampler2D surface;  // invDepth, gradX, gradY, light
layout(location = 1) uniform float slackPerDepth;
layout(location = 2) uniform bool lighting;

shared uint edgeBits[2];
shared uint firstNumber;

bool isEdge(ivec2 pixel)
{
    ivec2 first = ivec2(0, view.firstRow);
    bool covered = texelFetch(visible, pixel, 0).r != 0u;
    vec4 a = covered ? texelFetch(surface, pixel - first, 0) : vec4(0.0);
    float own = abs(a.w), least = own, most = own, nine[9];
    for (int k = 0; k < 9; ++k) nine[k] = own;
    for (int sy = -1; sy <= 1; ++sy)
        for (int sx = -1; sx <= 1; ++sx) {
            ivec2 other = pixel + ivec2(sx, sy);
            if (any(lessThan(other, ivec2(0))) || any(greaterThanEqual(other, view.imageSize))) continue;
            bool there = texelFetch(visible, other, 0).r != 0u;
            if (there != covered) return true;
            if (!there) continue;
            vec4 b = texelFetch(surface, other - first, 0);
            if (!onOneSheet(predict(a.xyz, b.xyz, vec2(sx, sy), slackPerDepth))) return true;
            nine[(sy + 1) * 3 + sx + 1] = abs(b.w);
            least = min(least, abs(b.w));
            most = max(most, abs(b.w));
        }
    if (!(lighting && covered && most - least > kLightStep)) return false;
    float middle = (least + most) * 0.5, darkEnd = least, brightBegin = most;
    for (int k = 0; k < 9; ++k) {
        if (nine[k] > middle) brightBegin = min(brightBegin, nine[k]);
        else darkEnd = max(darkEnd, nine[k]);
    }
    return max(darkEnd - least, most - brightBegin) <= (most - least) * kUneven;  // A crease: either side is even in itself.
}

void main()
{
    uint i = gl_LocalInvocationIndex;
    if (i < 2u) edgeBits[i] = 0u;
    barrier();
    ivec2 pixel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    bool edge = all(lessThan(pixel, area.zw)) && isEdge(pixel);
    if (edge) atomicOr(edgeBits[i >> 5], 1u << (i & 31u));
    barrier();
    uvec4 block = uvec4(edgeBits[0], edgeBits[1], 0u, 0u);
    if (i == 0u) {
        uint count = uint(bitCount(block.x) + bitCount(block.y));
        firstNumber = count > 0u ? atomicAdd(edgeList.edgeCount, count) : 0u;
        blocks[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = uvec4(block.xy, firstNumber, 0u);
    }
    barrier();
    block.z = firstNumber;
    if (edge) edgeList.edgePixels[numberIn(block, i)] = uvec2(uint(pixel.x) | uint(pixel.y) << 16, 0u);
}
