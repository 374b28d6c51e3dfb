// The mean of the colours of each edge pixel's samples (cpu/edges/edge_colors.h). An invocation a sample.
#include "view.glsl"
#include "arithmetic.glsl"
#include "surface_hit.glsl"
#include "one_sheet.glsl"
#include "surface_color.glsl"
#include "edge_samples.glsl"
layout(local_size_x = 64) in;
layout(binding = 2) uniform usampler2D visible;  // At pixels' centres.
layout(binding = 3) uniform sampler2D surface;   // invDepth, gradX, gradY, light
layout(binding = 4) uniform sampler2D scalars;
layout(binding = 5) uniform usampler2D colors;
layout(std430, binding = 4) readonly buffer Pixels { uint pixels[]; };  // RGBA bytes of the rows `shown`.
layout(std430, binding = 6) readonly buffer Open { float open[]; };  // Of the rows `shown`, with occlusion.
layout(location = 1) uniform ivec4 shown;  // x0, y0, x1, y1, global pixels.
layout(location = 2) uniform float slackPerDepth;
layout(location = 3) uniform vec2 sampleOffsets[kSamples];  // From the pixel's centre, in pixels.

// Nearest first.
const ivec2 kNeighbours[9] = ivec2[](ivec2(0, 0), ivec2(0, -1), ivec2(-1, 0), ivec2(1, 0), ivec2(0, 1), ivec2(-1, -1),
                                     ivec2(1, -1), ivec2(-1, 1), ivec2(1, 1));

uint scaled(uint byte, float brighter) { return uint(min(fma(float(byte), brighter, 0.5), 255.0)); }

uint placeIn(ivec2 pixel) { return uint(pixel.y - shown.y) * uint(shown.z - shown.x) + uint(pixel.x - shown.x); }

// `sampleOffset`: from the pixel's centre, in pixels.
uint sampleColor(uint triangle, ivec2 pixel, vec2 sampleOffset)
{
    vec2 place = vec2(pixel) + 0.5 + sampleOffset;
    Hit hit = intersect(triangle, (place.x - view.rightAndCenterX.w) * view.inverseFocal,
                        (place.y - view.upAndCenterY.w) * view.inverseFocal);
    float depth = max(dot3(hit.fromEye, view.forwardAndNear.xyz), view.forwardAndNear.w);
    vec3 facet = vec3(1.0 / depth, depthGradient(hit)), normal = shadingNormal(hit);
    float light = lightOn(normal, facingOf(normal, hit));
    float best = 1e38, closest = 1e38, bestLight = 1.0, scalar = 0.0, openShare = 1.0;
    uint kind = 0u;
    ivec2 chosen = ivec2(-1);
    for (int k = 0; k < 9; ++k) {
        ivec2 other = pixel + kNeighbours[k];
        if (any(lessThan(other, ivec2(0))) || any(greaterThanEqual(other, view.imageSize))) continue;
        if (texelFetch(visible, other, 0).r == 0u) continue;
        ivec2 texel = ivec2(other.x, other.y - view.firstRow);
        vec4 theirs = texelFetch(surface, texel, 0);
        vec2 way = sampleOffset - vec2(kNeighbours[k]);
        Prediction fit = predict(theirs.xyz, facet, way, slackPerDepth);
        float far = dot(way, way) * kDistanceShare;
        float error = fma(far, fit.slack, abs(fit.errorA) + abs(fit.errorB)), off = abs(facet.x - theirs.x);
        if (off < closest) {
            closest = off;
            if (palette.occlusion) openShare = open[placeIn(other)];
            if (palette.useScalar) scalar = texelFetch(scalars, texel, 0).r;
            if (palette.several) kind = texelFetch(colors, texel, 0).r;
        }
        if (!onOneSheet(fit) || error >= best) continue;
        best = error;
        bestLight = abs(theirs.w);
        chosen = other;
        if (error <= fit.slack * kFits) break;
    }
    if (chosen.x < 0) return surfaceColor(0.0, light * openShare, scalar, kind);
    uint color = pixels[placeIn(chosen)];
    if (!palette.lighting) return color;
    float brighter = light / bestLight;
    return scaled(color & 0xFFu, brighter) | scaled((color >> 8) & 0xFFu, brighter) << 8 |
           scaled((color >> 16) & 0xFFu, brighter) << 16 | 0xFF000000u;
}

shared uvec4 sums[64];  // Colours times alpha, alpha: of each pixel's samples.

uint meanOf(uint first)
{
    uvec4 sum = sums[first];
    for (uint k = 1u; k < uint(kSamples); ++k) sum += sums[first + k];
    if (sum.w == 0u) return palette.background;  // What shows where nothing else does.
    uint mean = ((sum.w + uint(kSamples) / 2u) / uint(kSamples)) << 24;
    for (int c = 0; c < 3; ++c) mean |= ((sum[c] + sum.w / 2u) / sum.w) << uint(8 * c);
    return mean;
}

void main()
{
    uint own = gl_LocalInvocationIndex, s = own % uint(kSamples), before = min(uint(held.x), edgeList.edgeCount);
    uint end = before + min(uint(held.y), edgeList.edgeCount - before);
    const uint kAtOnce = 64u / uint(kSamples);
    for (uint first = before + gl_WorkGroupID.x * kAtOnce; first < end; first += gl_NumWorkGroups.x * kAtOnce) {
        uint number = first + own / uint(kSamples);
        if (number < end) {
            uint seen = samples[triangleWord(number, int(s))];  // 0: background.
            uint color = seen == 0u ? palette.background : sampleColor(~seen, placeOf(number), sampleOffsets[s]), alpha = color >> 24;
            sums[own] = uvec4((color & 0xFFu) * alpha, ((color >> 8) & 0xFFu) * alpha, ((color >> 16) & 0xFFu) * alpha, alpha);
        }
        barrier();
        if (number < end && s == 0u) edgeList.edgePixels[number].y = meanOf(own);
        barrier();
    }
}
