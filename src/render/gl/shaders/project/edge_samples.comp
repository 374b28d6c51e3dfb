// Draws the triangles listed into the samples of edge pixels (cpu/project/sample_triangles.h). First how near the nearest
// are, then which they are. An invocation looks at one of a pixel's samples and at every so many-th pixel. SHARES: how
// many workgroups a triangle has; 0: LANES invocations.
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

#if SHARES
#define CROSS wideCross
#else
#define CROSS narrowCross
#endif

void drawSample(ScreenTriangle t, uint triangle, ivec2 pixel, uint number, int s)
{
    ivec2 at = pixel * kSubpixels + kSubpixels / 2 + samplePlaces[s];
    bool outsideAB, outsideBC, outsideCA;
    float ab = CROSS(t.a.at, t.b.at, at, outsideAB), bc = CROSS(t.b.at, t.c.at, at, outsideBC),
          ca = CROSS(t.c.at, t.a.at, at, outsideCA);
    if (outsideAB || outsideBC || outsideCA) return;
    precise float inverse = 1.0 / t.doubleArea;
    precise float plane = fma(t.b.invDepth - t.a.invDepth, ca * inverse, fma(t.c.invDepth - t.a.invDepth, ab * inverse, t.a.invDepth));
    precise float depth = min(max(plane, t.lowest), t.highest) + t.bias;
    if (depth < farInvDepth) return;
    uint bits = floatBitsToUint(depth);
    if (!naming)
        atomicMax(samples[depthWord(number, s)], bits);
    else if (samples[depthWord(number, s)] == bits)
        atomicMax(samples[triangleWord(number, s)], ~triangle);
}

// The edge pixels of a block that lie in the triangle's box, `low` to `high` in pixels of the area.
uvec2 edgesWithin(ivec2 block, ivec2 low, ivec2 high)
{
    return blocks[block.y * blocksPerRow() + block.x].xy & pixelsWithin(low - block * kBlock, high - block * kBlock);
}

// Of these pixels of a block every `slots`-th, from the `slot`-th on, at one sample.
void sampleBlock(ScreenTriangle t, uint triangle, ivec2 block, uvec2 marked, uint slot, uint slots, int s)
{
    uint count = uint(bitCount(marked.x) + bitCount(marked.y));
    if (slot >= count) return;
    uvec4 edges = blocks[block.y * blocksPerRow() + block.x];
    for (uint k = slot; k < count; k += slots) {
        uint pixel = nthOf(marked, k), number = numberIn(edges, pixel);
        if (hasSamples(number)) drawSample(t, triangle, area.xy + block * kBlock + ivec2(pixel & 7u, pixel >> 3), number, s);
    }
}

#if SHARES
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

const uint kGroup = 64u;
shared uvec2 markedIn[kGroup];

// One share of a triangle's blocks. All invocations look for blocks with edges, a block each, and then go through them.
void sampleTriangle(ScreenTriangle t, uint triangle, uint share)
{
    ivec2 low = max(t.low, area.xy) - area.xy, high = min(t.high, area.zw) - area.xy;
    if (any(greaterThanEqual(low, high))) return;
    ivec2 begin = low / kBlock, size = (high - 1) / kBlock - begin + 1;
    uint own = gl_LocalInvocationIndex, count = uint(size.x) * uint(size.y);
    for (uint first = share * kGroup; first < count; first += uint(SHARES) * kGroup) {
        ivec2 block = begin + ivec2(int(first + own) % size.x, int(first + own) / size.x);
        barrier();
        markedIn[own] = first + own < count ? edgesWithin(block, low, high) : uvec2(0u);
        barrier();
        for (uint i = 0u; i < min(kGroup, count - first); ++i)
            sampleBlock(t, triangle, begin + ivec2(int(first + i) % size.x, int(first + i) / size.x), markedIn[i],
                        own / uint(kSamples), kGroup / uint(kSamples), int(own) % kSamples);
    }
}

void main()
{
    uint count = SHARES == 1 ? edgeList.mediumCount : edgeList.largeCount;
    for (uint i = gl_WorkGroupID.x; i < count * uint(SHARES); i += gl_NumWorkGroups.x) {
        uint listed = i / uint(SHARES), triangle = nearTriangles[SHARES == 1 ? triangleCount + listed : triangleCount - 1u - listed];
        vec3 corners[kMostCorners];
        bool safe = true;
        for (int k = 0; k < 3; ++k) {
            corners[k] = eyePosition(triangles[3u * triangle + uint(k)]);
            safe = safe && isSafe(corners[k]);
        }
        int cornerCount = 3;
        if (!safe) cut(corners, cornerCount);
        for (int k = 2; k < cornerCount; ++k) {
            ScreenTriangle t;
            if (setUp(cornerAt(corners[0]), cornerAt(corners[k - 1]), cornerAt(corners[k]), t)) sampleTriangle(t, triangle, i % uint(SHARES));
        }
    }
}
#else
void main()
{
    const int lane = int(gl_GlobalInvocationID.x) % LANES;
    for (uint i = gl_GlobalInvocationID.x / uint(LANES); i < edgeList.smallCount; i += gl_NumWorkGroups.x * (64u / uint(LANES))) {
        uint triangle = nearTriangles[i];
        ScreenTriangle t;
        if (!setUp(cornerAt(eyePosition(triangles[3u * triangle])), cornerAt(eyePosition(triangles[3u * triangle + 1u])),
                   cornerAt(eyePosition(triangles[3u * triangle + 2u])), t))
            continue;
        ivec2 low = max(t.low, area.xy) - area.xy, high = min(t.high, area.zw) - area.xy;
        for (int y = low.y / kBlock; y <= (high.y - 1) / kBlock; ++y)
            for (int x = low.x / kBlock; x <= (high.x - 1) / kBlock; ++x) {
                uvec2 marked = edgesWithin(ivec2(x, y), low, high);
                for (int s = lane; s < kSamples; s += LANES) sampleBlock(t, triangle, ivec2(x, y), marked, 0u, 1u, s);
            }
    }
}
#endif
