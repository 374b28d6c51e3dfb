// The kernel's full length in both directions, from the highest level down, and the pixel's own sample: its LIC value.
#include "near_tile.glsl"
#include "arithmetic.glsl"
#include "flow_texel.glsl"
#include "trace.glsl"
#include "jumps.glsl"
#include "lic_value.glsl"
layout(r32f, binding = 0) writeonly uniform image2D licImage;
layout(location = 3) uniform vec4 kernel;  // Shares of the plain and the weighted sums; weight of the own sample.

Walk walkAll(int direction)
{
    Trace t = Trace(vec2(0.0), vec2(0.0), true);
    Walk walk = noWalk();
    int walked = 0;
    bool first = true;
    for (int i = jumpPlan.levels; i >= 0; --i) {
        int level = i > 0 ? i - 1 : jumpPlan.levels;  // The remainder comes last.
        for (int k = 0; k < jumpPlan.counts[level].y && t.alive; ++k) {
            if (first)
                firstJump(level, direction, t, walk);
            else
                nextJump(level, direction, walked, t, walk);
            first = false;
            walked += jumpPlan.counts[level].x;
        }
    }
    return walk;
}

void main()
{
    ivec2 pixel = nearPixel();
    if (pixel.x < 0) return;
    uint texel = texelFetch(flow, pixel, 0).r;
    if (texel == 0u) return;
    startAt(pixel);
    Walk down = walkAll(0), up = walkAll(1);
    FlowSample origin = flowAtPixel(texel);
    float own = ownLength(origin);
    precise float sum = down.sum + up.sum;
#if WEIGHTED
    vec2 weighted = down.weighted + up.weighted;
    sum = 0.5 * (kernel.x * sum + fma(kernel.y, weighted.x, kernel.z * weighted.y));
#endif
    sum = fma(own * kernel.w, origin.noise, sum);
    precise float lengthPx = own + (down.lengthPx + up.lengthPx);
    float effectivePx = effectivePixels(lengthPx, own, down.lengthPx, down.width, up.lengthPx, up.width);
    imageStore(licImage, pixel, vec4(licValue(sum, lengthPx, effectivePx) * phaseGain(own, down.lengthPx, up.lengthPx)));
}
