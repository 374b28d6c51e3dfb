// The line integral of every pixel by stepping its streamline both ways (cpu/lic/direct.cpp).
#include "near_tile.glsl"
#include "arithmetic.glsl"
#include "flow_texel.glsl"
#include "trace.glsl"
#include "lic_value.glsl"
layout(r32f, binding = 0) writeonly uniform image2D licImage;
layout(location = 3) uniform int steps;
layout(location = 4) uniform bool even;
#if WEIGHTED
layout(std430, binding = 0) readonly buffer KernelWeights { float weights[]; };  // [2][steps + 1]: down, up.
float weightOf(int direction, int i) { return weights[direction * (steps + 1) + i]; }
#else
float weightOf(int direction, int i) { return 1.0; }
#endif

// One step; afterwards `here` is the flow at the new position. Returns the step's length in the image.
float walkStep(float unit, inout Trace t, inout FlowSample here)
{
    vec2 from = t.at, v = here.v;
#if INTEGRATOR == 1
    v = sampleFlow(t, stepped(from, v, 0.5 * unit)).v;
    if (!t.alive) return 0.0;
#elif INTEGRATOR == 2
    vec2 k2 = sampleFlow(t, stepped(from, v, 0.5 * unit)).v;
    if (!t.alive) return 0.0;
    vec2 k3 = sampleFlow(t, stepped(from, k2, 0.5 * unit)).v;
    if (!t.alive) return 0.0;
    vec2 k4 = sampleFlow(t, stepped(from, k3, unit)).v;
    if (!t.alive) return 0.0;
    vec2 middle = k2 + k3, ends = v + k4;
    v = (1.0 / 6.0) * vec2(fma(2.0, middle.x, ends.x), fma(2.0, middle.y, ends.y));
#endif
    here = sampleFlow(t, stepped(from, v, unit));
    return stepLength(v);
}

void main()
{
    ivec2 pixel = nearPixel();
    if (pixel.x < 0) return;
    uint texel = texelFetch(flow, pixel, 0).r;
    if (texel == 0u) return;
    startAt(pixel);
    FlowSample origin = flowAtPixel(texel);
    float own = ownLength(origin);
    precise float sum = (own * weightOf(0, 0)) * origin.noise;
    float walked[2] = {0.0, 0.0}, width[2] = {1.0, 1.0};
    if (flowsOn(origin.v, origin.v))
        for (int direction = 0; direction < 2; ++direction) {
            Trace t = Trace(vec2(0.0), vec2(0.0), true);
            FlowSample here = origin;
            float unit = direction == 0 ? flowUnitPx : -flowUnitPx;
            precise float lengthPx = 0.0, tube = 1.0;
            for (int i = 1; i <= steps; ++i) {
                vec2 before = here.v;
                float stepPx = walkStep(unit, t, here);
                if (!t.alive) break;
                float narrowing = halfNarrowing(here, even ? unit : 0.0), there = tube * narrowing;
                stepPx *= there;
                sum = fma(stepPx * weightOf(direction, i), here.noise, sum);
                lengthPx = lengthPx + stepPx;
                tube = there * narrowing;
                if (!flowsOn(before, here.v)) break;
            }
            walked[direction] = lengthPx;
            width[direction] = tube;
        }
    precise float lengthPx = own + (walked[0] + walked[1]);
    float effectivePx = effectivePixels(lengthPx, own, walked[0], width[0], walked[1], width[1]);
    imageStore(licImage, pixel, vec4(licValue(sum, lengthPx, effectivePx) * phaseGain(own, walked[0], walked[1])));
}
