// Lists the triangles that may show in edge pixels. The list has two halves: small ones stand from the beginning of the
// first half on; large ones, and those that must be cut first, from its end; medium ones in the second. Which of them a
// triangle is does not depend on the rows drawn.
#include "view.glsl"
#include "arithmetic.glsl"
#include "edge_blocks.glsl"
#include "edge_list.glsl"
#include "screen_triangle.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 4) writeonly buffer NearTriangles { uint nearTriangles[]; };
layout(location = 1) uniform uint triangleCount;
layout(location = 2) uniform ivec2 mostPx;  // How high and wide a small and a medium triangle is at most.

bool meetsEdges(ivec2 low, ivec2 high)
{
    ivec2 first = low / kBlock, last = (high - 1) / kBlock;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            ivec2 corner = ivec2(x, y) * kBlock;
            if (any(notEqual(blocks[y * blocksPerRow() + x].xy & pixelsWithin(low - corner, high - corner), uvec2(0u)))) return true;
        }
    return false;
}

void listLarge(uint triangle) { nearTriangles[triangleCount - 1u - atomicAdd(edgeList.largeCount, 1u)] = triangle; }

void main()
{
    uint triangle = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationIndex;
    if (triangle >= triangleCount) return;
    vec3 a = eyePosition(triangles[3u * triangle]), b = eyePosition(triangles[3u * triangle + 1u]),
         c = eyePosition(triangles[3u * triangle + 2u]);
    if (max(max(a.z, b.z), c.z) < view.forwardAndNear.w) return;
    if (!isSafe(a) || !isSafe(b) || !isSafe(c)) {
        listLarge(triangle);
        return;
    }
    ScreenTriangle t;
    if (!setUp(cornerAt(a), cornerAt(b), cornerAt(c), t)) return;
    ivec2 low = max(t.low, area.xy) - area.xy, high = min(t.high, area.zw) - area.xy;
    if (any(greaterThanEqual(low, high))) return;
    ivec2 size = t.high - t.low;
    if (any(greaterThan(size, ivec2(mostPx.y))))
        listLarge(triangle);
    else if (any(greaterThan(size, ivec2(mostPx.x))))
        nearTriangles[triangleCount + atomicAdd(edgeList.mediumCount, 1u)] = triangle;
    else if (meetsEdges(low, high))
        nearTriangles[atomicAdd(edgeList.smallCount, 1u)] = triangle;
}
