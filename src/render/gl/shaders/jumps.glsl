// Reading, joining and writing jumps (cpu/lic/jumps-inl.h). Two words a pixel, in the layers of two array textures:
//   place  bits 0 to 15 displacement in x, signed, in displacementUnitPx; 16 to 31 in y
//   meta   jump_word (render/lic/jump_plan.h)
//   weighted  the two sums weighted by the kernel's pair (KernelModel), as in place, in weightedUnit
layout(binding = 4) uniform usampler2DArray places;
layout(binding = 5) uniform usampler2DArray metas;
#if WEIGHTED
layout(binding = 6) uniform usampler2DArray weightedSums;
layout(std430, binding = 0) readonly buffer Turns { vec4 turns[]; };  // Turns of i steps, downstream and upstream: aa, ab, ba, bb.
#endif

layout(std140, binding = 3) uniform JumpBlock {
    vec4 units[kJumpLevels];     // displacementUnitPx, sumUnit, lengthUnitPx, weightedUnit
    vec4 perUnit[kJumpLevels];   // 1 / those
    ivec4 counts[kJumpLevels];   // Steps of a jump, how many the kernel takes.
    int levels, directSteps, remainderSteps, unused;
} jumpPlan;

int layerOf(int level, int direction) { return 2 * level + direction; }

// What a trace has gathered so far.
struct Walk {
    float sum, lengthPx;
    float width;  // The stream tube's least so far, beside that at the start.
    vec2 weighted;
};
Walk noWalk() { return Walk(0.0, 0.0, 1.0, vec2(0.0)); }

// Signed halves of words. The upper one comes with the lower one's bits below it, and was rounded with them in mind.
vec4 lowHalf(uvec4 v) { return fieldOf(v & 0xFFFFu, 0x8000u); }
vec4 highHalf(uvec4 v) { return fieldWithBelow(v >> 16, 0x8000u, v & 0xFFFFu, 1.0 / 65536.0); }
// The fields of jump_word without its open bit, each in its unit, with the bits below it.
vec4 lengthField(uvec4 meta) { return fieldOf(meta & ((1u << kSumShift) - 1u), 0u) * (1.0 / float(1u << kLengthShift)); }
vec4 sumField(uvec4 meta)
{
    uint lower = (1u << kSumShift) - 1u;
    return fieldWithBelow((meta >> kSumShift) & 0xFFFu, 0x800u, meta & lower, 1.0 / float(lower + 1u));
}
vec4 widthField(uvec4 meta) { return fieldOf(meta >> kWidthShift, 0u) * (1.0 / float(kWidthOne)); }
vec2 halvesOf(uint v) { return vec2(lowHalf(uvec4(v)).x, highHalf(uvec4(v)).x); }

uint halfOf(float v) { return uint(clamp(int(roundEven(v)), -kHalfMost, kHalfMost)); }
uint halves(float low, float high)
{
    uint lowBits = halfOf(low) & 0xFFFFu;
    precise float rest = high - float(lowBits) * (1.0 / 65536.0);
    return lowBits | halfOf(rest) << 16;
}

#if WEIGHTED
vec4 turnOf(int direction, int steps) { return turns[2 * steps + direction]; }

// Weighted sums count from the jump's own start: turned by the steps walked before it.
vec2 turned(vec2 sums, int direction, int stepsBefore)
{
    vec4 by = turnOf(direction, stepsBefore);
    return vec2(fma(sums.y, by.y, sums.x * by.x), fma(sums.x, by.z, sums.y * by.w));
}
#endif

// The jump of the pixel itself: the first of every trace, without interpolation.
void firstJump(int level, int direction, inout Trace t, inout Walk walk)
{
    ivec3 texel = ivec3(startPixel, layerOf(level, direction));
    uint place = texelFetch(places, texel, 0).r, meta = texelFetch(metas, texel, 0).r & ~kOpenBit;
    vec3 unit = jumpPlan.units[level].xyz;
    precise vec2 at = halvesOf(place) * unit.x;
    precise float sum = sumField(uvec4(meta)).x * unit.y, lengthPx = lengthField(uvec4(meta)).x * unit.z;
    t.at = t.sheet = at;
    walk.sum = sum;
    walk.lengthPx = lengthPx;
    walk.width = widthField(uvec4(meta)).x;
#if WEIGHTED
    uint pair = texelFetch(weightedSums, texel, 0).r;
    walk.weighted = halvesOf(pair) * jumpPlan.units[level].w;
#endif
    t.alive = (meta & kAliveBit) != 0u;
}

// One more jump from where the trace is, interpolated among taps of its sheet that got as far as the nearest one did.
void nextJump(int level, int direction, int stepsBefore, inout Trace t, inout Walk walk)
{
    precise vec2 lower = floor(t.at), w = t.at - lower;
    vec3 corner = vec3(gatherCorner(lower), float(layerOf(level, direction)));
    uvec4 place = cellOrder(textureGather(places, corner)), meta = cellOrder(textureGather(metas, corner));
    uint common4 = (meta.x & meta.y) & (meta.z & meta.w);
    vec3 unit = jumpPlan.units[level].xyz;
    ivec2 within = ivec2(greaterThanEqual(w, vec2(0.5)));
    bool goesOn = true;
    vec4 weight = bilinear(w);
    if (!((common4 & (kOpenBit | kAliveBit)) == (kOpenBit | kAliveBit) && farthest(t.at, t.sheet) <= float(kOpenReachPx))) {
        uint bits = followLinks(t, ivec2(lower) + within);
        if (!t.alive) return;  // Ended on the way here: gains nothing. Ends further on: gains what it walked.
        if (bits != kAllNine) weight = linkedWeights(bits, within, weight);
        // A trace goes on where most of its taps do, and then with those alone: the others would drag it back. A tap without
        // weight has no say, not even by rounding: it may lie where a rank has nothing.
        bvec4 alive = notEqual(meta & kAliveBit, uvec4(0u));
        precise float going = (((alive.x ? weight.x : 0.0) + (alive.y ? weight.y : 0.0)) + (alive.z ? weight.z : 0.0)) + (alive.w ? weight.w : 0.0);
        precise float ending = (((alive.x ? 0.0 : weight.x) + (alive.y ? 0.0 : weight.y)) + (alive.z ? 0.0 : weight.z)) + (alive.w ? 0.0 : weight.w);
        goesOn = going >= 0.5;
        float inverse = 1.0 / (goesOn ? going : max(ending, kLeastWeight));
        if ((goesOn ? ending : going) > 0.0)
            weight = vec4(alive.x == goesOn ? weight.x * inverse : 0.0, alive.y == goesOn ? weight.y * inverse : 0.0,
                          alive.z == goesOn ? weight.z * inverse : 0.0, alive.w == goesOn ? weight.w * inverse : 0.0);
    }
    float dx = blend(weight, lowHalf(place)), dy = blend(weight, highHalf(place));
    meta &= ~kOpenBit;
    precise float sum = blend(weight, sumField(meta)) * unit.y, lengthPx = blend(weight, lengthField(meta)) * unit.z;
    float width = walk.width;  // The jump's weights count from its own start.
    walk.sum = fma(sum, width, walk.sum);
    walk.lengthPx = fma(lengthPx, width, walk.lengthPx);
    walk.width = width * blend(weight, widthField(meta));
#if WEIGHTED
    uvec4 texel = cellOrder(textureGather(weightedSums, corner));
    walk.weighted += turned(vec2(blend(weight, lowHalf(texel)), blend(weight, highHalf(texel))) * (width * jumpPlan.units[level].w), direction, stepsBefore);
#endif
    t.alive = goesOn;
    if (!goesOn) return;
    // The pixel on which the nearest tap's own trace ended is on the sheet for certain: the interpolated end is checked
    // against it. Where neighbours part by more than kTogetherPx their mean lies on neither's way: go as the nearest does.
    uint nearest = within.y == 0 ? (within.x == 0 ? place.x : place.y) : (within.x == 0 ? place.z : place.w);
    vec2 fromCell = vec2(within) - w, end = stepped(t.at, vec2(dx, dy), unit.x);
    t.sheet = stepped(t.at + fromCell, halvesOf(nearest), unit.x);
    t.at = farthest(end, t.sheet) <= float(kTogetherPx) ? end : stepped(t.at, halvesOf(nearest), unit.x);
}

// Ends a trace whose interpolated position is not on the sheet its sheet position is on; after this it is.
void settle(inout Trace t)
{
    if (!t.alive) return;
    uint bits = nineBits(nearestOf(t.sheet));
    if (!(farthest(t.at, t.sheet) <= float(kSettledPx) && bits == kAllNine)) followLinks(t, nearestOf(t.at));
    t.sheet = t.at;
}
