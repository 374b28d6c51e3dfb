// Draws the triangles listed into the samples of edge pixels (cpu/project/sample_triangles.h). LARGE: a workgroup for a
// part of each, else an invocation for each. First how near the nearest are, then which they are.
#include "view.glsl"
#include "arithmetic.glsl"
#include "edge_blocks.glsl"
#include "edge_samples.glsl"
#include "screen_triangle.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 4) readonly buffer NearTriangles { uint nearTriangles[]; };
layout(location = 1) uniform uint triangleCount;
layout(location = 2) uniform bool naming;
layout(location = 4) uniform float farInvDepth;
layout(location = 5) uniform ivec2 samplePlaces[kSamples];  // From the pixel's centre, in sub-pixels.

#if LARGE
#define CROSS wideCross
#else
#define CROSS narrowCross
#endif

void samplePixel(ScreenTriangle t, uint triangle, ivec2 pixel, uint number)
{
    for (int s = 0; s < kSamples; ++s) {
        ivec2 at = pixel * kSubpixels + kSubpixels / 2 + samplePlaces[s];
        bool outsideAB, outsideBC, outsideCA;
        float ab = CROSS(t.a.at, t.b.at, at, outsideAB), bc = CROSS(t.b.at, t.c.at, at, outsideBC),
              ca = CROSS(t.c.at, t.a.at, at, outsideCA);
        if (outsideAB || outsideBC || outsideCA) continue;
        precise float inverse = 1.0 / t.doubleArea;
        precise float plane = fma(t.b.invDepth - t.a.invDepth, ca * inverse, fma(t.c.invDepth - t.a.invDepth, ab * inverse, t.a.invDepth));
        precise float depth = min(max(plane, t.lowest), t.highest) + t.bias;
        if (depth < farInvDepth) continue;
        uint bits = floatBitsToUint(depth);
        if (!naming)
            atomicMax(samples[depthWord(number, s)], bits);
        else if (samples[depthWord(number, s)] == bits)
            atomicMax(samples[triangleWord(number, s)], ~triangle);
    }
}

// The pixels of a block within the triangle's box.
void sampleBlock(ScreenTriangle t, uint triangle, ivec2 block, ivec2 low, ivec2 high)
{
    uvec4 edges = blocks[block.y * blocksPerRow() + block.x];
    ivec2 corner = block * kBlock;
    uvec2 left = edges.xy & pixelsWithin(low - corner, high - corner);
    while (any(notEqual(left, uvec2(0u)))) {
        bool upper = left.x != 0u;
        uint word = upper ? left.x : left.y;
        int bit = findLSB(word), pixel = upper ? bit : 32 + bit;
        word &= word - 1u;
        if (upper) left.x = word;
        else left.y = word;
        uint number = numberIn(edges, uint(pixel));
        if (hasSamples(number)) samplePixel(t, triangle, area.xy + corner + ivec2(pixel & 7, pixel >> 3), number);
    }
}

// Every `stride`-th block, from `first` on.
void sampleTriangle(ScreenTriangle t, uint triangle, int first, int stride)
{
    ivec2 low = max(t.low, area.xy) - area.xy, high = min(t.high, area.zw) - area.xy;
    if (any(greaterThanEqual(low, high))) return;
    ivec2 begin = low / kBlock, size = (high - 1) / kBlock - begin + 1;
    for (int i = first; i < size.x * size.y; i += stride) sampleBlock(t, triangle, begin + ivec2(i % size.x, i / size.x), low, high);
}

#if LARGE
// Cuts a polygon at the near plane and at a wide band around the image (Sutherland & Hodgman 1974). New corners are
// computed from an edge's inner end to its outer one: neighbours get the same.
const int kMostCorners = 8;
void cut(inout vec3 corners[kMostCorners], inout int count)
{
    precise vec2 slope = (vec2(view.rightAndCenterX.w, view.upAndCenterY.w) + 65536.0) * view.inverseFocal;
    vec4 planes[5] = vec4[](vec4(0.0, 0.0, 1.0, -view.forwardAndNear.w), vec4(1.0, 0.0, slope.x, 0.0), vec4(-1.0, 0.0, slope.x, 0.0),
                            vec4(0.0, 1.0, slope.y, 0.0), vec4(0.0, -1.0, slope.y, 0.0));
    for (int k = 0; k < 5; ++k) {
        vec3 before[kMostCorners] = corners;
        int beforeCount = count;
        count = 0;
        for (int i = 0; i < beforeCount; ++i) {
            vec3 p = before[i], q = before[i + 1 < beforeCount ? i + 1 : 0];
            precise float dp = dot3(planes[k].xyz, p) + planes[k].w, dq = dot3(planes[k].xyz, q) + planes[k].w;
            if (dp >= 0.0) corners[count++] = p;
            if ((dp >= 0.0) != (dq >= 0.0)) {
                bool inner = dp >= 0.0;
                corners[count++] = inner ? along(p, q - p, dp / (dp - dq)) : along(q, p - q, dq / (dq - dp));
            }
        }
        if (count < 3) return;
    }
}

const int kShares = 32;  // Of each triangle, a workgroup each.

void main()
{
    for (uint i = gl_WorkGroupID.x; i < edgeList.largeCount * uint(kShares); i += gl_NumWorkGroups.x) {
        uint triangle = nearTriangles[triangleCount - 1u - i / uint(kShares)];
        vec3 corners[kMostCorners];
        bool safe = true;
        for (int k = 0; k < 3; ++k) {
            corners[k] = eyePosition(triangles[3u * triangle + uint(k)]);
            safe = safe && isSafe(corners[k]);
        }
        int count = 3;
        if (!safe) cut(corners, count);
        int first = int(i % uint(kShares)) * 64 + int(gl_LocalInvocationIndex);
        for (int k = 2; k < count; ++k) {
            ScreenTriangle t;
            if (setUp(cornerAt(corners[0]), cornerAt(corners[k - 1]), cornerAt(corners[k]), t))
                sampleTriangle(t, triangle, first, kShares * 64);
        }
    }
}
#else
void main()
{
    for (uint i = gl_GlobalInvocationID.x; i < edgeList.smallCount; i += gl_NumWorkGroups.x * 64u) {
        uint triangle = nearTriangles[i];
        ScreenTriangle t;
        if (setUp(cornerAt(eyePosition(triangles[3u * triangle])), cornerAt(eyePosition(triangles[3u * triangle + 1u])),
                  cornerAt(eyePosition(triangles[3u * triangle + 2u])), t))
            sampleTriangle(t, triangle, 0, 1);
    }
}
#endif
