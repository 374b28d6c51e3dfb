// Joins `radix` jumps of one level to one of the next. An invocation a pixel and direction.
#include "near_tile.glsl"
#include "arithmetic.glsl"
#include "flow_texel.glsl"
#include "trace.glsl"
#include "jumps.glsl"
#include "store_jump.glsl"
layout(location = 3) uniform ivec2 levelAndRadix;

void main()
{
    ivec2 pixel = nearPixel();
    if (pixel.x < 0) return;
    int direction = int(gl_WorkGroupID.z), level = levelAndRadix.x;
    if (texelFetch(flow, pixel, 0).r == 0u) {
        storeNoJump(pixel, level + 1, direction);
        return;
    }
    startAt(pixel);
    Trace t = Trace(vec2(0.0), vec2(0.0), true);
    Walk walk = noWalk();
    firstJump(level, direction, t, walk);
    for (int j = 1; j < levelAndRadix.y && t.alive; ++j) nextJump(level, direction, j * jumpPlan.counts[level].x, t, walk);
    settle(t);
    storeJump(pixel, level + 1, direction, t, walk, texelFetch(openFlow, pixel, 0).r != 0u);
}
