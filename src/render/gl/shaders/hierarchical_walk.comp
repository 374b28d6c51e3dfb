// The first steps of the hierarchical method, one by one (cpu/lic/hierarchical_walk.cpp): steps two pixels long whose
// middles serve as samples too. An invocation a pixel and direction.
#include "near_tile.glsl"
#include "arithmetic.glsl"
#include "flow_texel.glsl"
#include "trace.glsl"
#include "jumps.glsl"
#include "store_jump.glsl"
layout(location = 3) uniform float noiseUnit;
layout(location = 4) uniform bool even;

// Adds the sample after `step` steps, the last of them `walked` pixels long, and ends the trace where the flow turns.
void countSample(inout Trace t, inout Walk walk, vec2 from, FlowSample s, float walked, int step, int direction)
{
    float narrowing = halfNarrowing(s, !even ? 0.0 : direction == 0 ? flowUnitPx : -flowUnitPx), there = walk.width * narrowing;
    walked *= there;
    precise float noise = walked * (s.noise * noiseUnit);
    walk.sum += noise;
    walk.lengthPx += walked;
    walk.width = there * narrowing;
#if WEIGHTED
    vec4 by = turnOf(direction, step);
    walk.weighted = vec2(fma(noise, by.x, walk.weighted.x), fma(noise, by.z, walk.weighted.y));
#endif
    t.alive = flowsOn(from, s.v);
}

void main()
{
    ivec2 pixel = nearPixel();
    if (pixel.x < 0) return;
    int direction = int(gl_WorkGroupID.z), remainder = jumpPlan.remainderSteps;
    uint texel = texelFetch(flow, pixel, 0).r;
    if (texel == 0u) {
        storeNoJump(pixel, 0, direction);
        if (remainder > 0) storeNoJump(pixel, jumpPlan.levels, direction);
        return;
    }
    startAt(pixel);
    bool open = texelFetch(openFlow, pixel, 0).r != 0u;
    FlowSample here = flowAtPixel(texel), middle = here;
    Trace t = Trace(vec2(0.0), vec2(0.0), flowsOn(here.v, here.v));
    Walk walk = noWalk();
    float unit = direction == 0 ? flowUnitPx : -flowUnitPx;
    vec2 from = t.at;
    for (int i = 1; i <= jumpPlan.directSteps; ++i) {
        if (t.alive) {
            if ((i & 1) == 1) {
                from = t.at;
                middle = sampleFlow(t, stepped(from, here.v, unit));
                if (t.alive) countSample(t, walk, here.v, middle, stepLength(middle.v), i, direction);
            } else {
                here = sampleFlow(t, stepped(from, middle.v, 2.0 * unit));
                if (t.alive) countSample(t, walk, middle.v, here, stepLength(middle.v), i, direction);
            }
        }
        if (i == remainder) storeJump(pixel, jumpPlan.levels, direction, t, walk, open);
    }
    storeJump(pixel, 0, direction, t, walk, open);
}
