// Traces: how they move from pixel to pixel without leaving their sheet of the surface, and the flow they meet there
// (cpu/links-inl.h, cpu/trace-inl.h). Positions count from the starting pixel's centre, so that a trace's arithmetic is
// the same wherever in the image, and in whichever stripe, it runs.
layout(binding = 0) uniform usampler2D flow;       // flow_texel, one by one.
layout(binding = 1) uniform usampler2D links;
layout(binding = 2) uniform usampler2D openFlow;   // trace_texels.comp; zeros beyond the border.
layout(binding = 3) uniform usampler2D wholeFlow;
layout(location = 1) uniform float flowUnitPx;

struct Trace {
    vec2 at;     // Pixels from the start.
    vec2 sheet;  // A position near by whose nearest pixel is on the trace's sheet for certain.
    bool alive;
};

ivec2 startPixel;                  // Of the rows held.
vec2 gatherScale, gatherStart;     // Texture coordinates of the corner that a cell's four texels meet in.

void startAt(ivec2 pixel)
{
    startPixel = pixel;
    gatherScale = 1.0 / vec2(textureSize(openFlow, 0));
    gatherStart = (vec2(pixel) + 1.0) * gatherScale;
}
vec2 gatherCorner(vec2 lower) { return vec2(fma(lower.x, gatherScale.x, gatherStart.x), fma(lower.y, gatherScale.y, gatherStart.y)); }

// The four values of a cell in the order (0,0) (1,0) (0,1) (1,1), y down; textureGather's is another.
uvec4 cellOrder(uvec4 gathered) { return gathered.wzxy; }

ivec2 nearestOf(vec2 position)
{
    vec2 lower = floor(position);
    return ivec2(lower) + ivec2(greaterThanEqual(position - lower, vec2(0.5)));
}

// Link masks with the pixel itself in the middle: bit (sy + 1) * 3 + (sx + 1). Beyond what is held: itself alone.
uint nineBits(ivec2 relative)
{
    ivec2 p = startPixel + relative;
    bool there = all(greaterThanEqual(p, ivec2(0))) && all(lessThan(p, tiling.size));
    uint mask = there ? texelFetch(links, p, 0).r : 0u;
    return (mask & 0x0Fu) | 0x10u | ((mask & 0xF0u) << 1);
}

// Walks from the sheet's pixel to `to`, hop by hop; the trace dies where a hop has no link. Returns the links there.
uint followLinks(inout Trace t, ivec2 to)
{
    ivec2 p = nearestOf(t.sheet);
    uint bits = nineBits(p);
    for (;;) {
        ivec2 hop = clamp(to - p, ivec2(-1), ivec2(1));
        if ((bits >> uint(hop.y * 3 + hop.x + 4) & 1u) == 0u) {
            t.alive = false;
            return bits;
        }
        p += hop;
        bits = nineBits(p);
        if (p == to) return bits;
    }
}

// Bilinear weights of the taps that are linked to the nearest pixel, whose nine bits are `bits`; their sum is 1.
vec4 linkedWeights(uint bits, ivec2 nearestWithinCell, vec2 w)
{
    // Seen from the nearest pixel the four taps are bits shift + {0, 1, 3, 4} of its nine.
    bits >>= uint(4 - nearestWithinCell.x - 3 * nearestWithinCell.y);
    vec2 u = 1.0 - w;
    vec4 weight = vec4((bits & 1u) != 0u ? u.x * u.y : 0.0, (bits & 2u) != 0u ? w.x * u.y : 0.0,
                       (bits & 8u) != 0u ? u.x * w.y : 0.0, (bits & 16u) != 0u ? w.x * w.y : 0.0);
    return weight * (1.0 / ((weight.x + weight.y) + (weight.z + weight.w)));
}

float farthest(vec2 a, vec2 b) { return max(abs(a.x - b.x), abs(a.y - b.y)); }

// Integers below 2^23 as floats above 2^23, by their bits alone: a conversion costs a GPU several times as much. Their
// differences are exact. `sign`: the bit that is the integer's sign; the float lies that much too high besides.
vec4 aboveTwo23(uvec4 bits, uint sign) { return uintBitsToFloat(bits ^ (0x4B000000u | sign)); }
const float kTwo23 = 8388608.0;

// Bilinear among values that all lie `offset` too high.
float blendCell(vec4 v, vec2 w, float offset)
{
    return lerp(fma(w.x, v.y - v.x, v.x - offset), fma(w.x, v.w - v.z, v.z - offset), w.y);
}
float blendPartial(vec4 v, vec4 weight, float offset)
{
    v -= offset;
    return fma(weight.x, v.x, fma(weight.y, v.y, fma(weight.z, v.z, weight.w * v.w)));
}

struct FlowSample {
    vec2 v;       // Displacement per step, flow units; 0 where the trace has ended.
    float noise;  // In bytes of the texture it came from, 0 on average.
};

// The fields of texels as floats, and how much too high they lie.
vec4 fieldX(uvec4 texel) { return aboveTwo23((texel >> 9) & 0x7FF800u, 0x400000u); }
vec4 fieldY(uvec4 texel) { return aboveTwo23(texel & 0xFFF00u, 0x80000u); }
vec4 fieldNoise(uvec4 texel) { return aboveTwo23(texel & 0xFFu, 0u); }
const float kOffsetX = kTwo23 + 2048.0 * 2048.0, kOffsetY = kTwo23 + 256.0 * 2048.0, kOffsetNoise = kTwo23 + 128.0;
const vec2 kFieldUnit = vec2(1.0 / 2048.0, 1.0 / 256.0);

// The flow at `to`. Moves the trace there, along links; one that cannot get there ends.
FlowSample sampleFlow(inout Trace t, vec2 to)
{
    vec2 lower = floor(to), w = to - lower;
    uvec4 texel = cellOrder(textureGather(openFlow, gatherCorner(lower)));
    FlowSample s;
    bool open = texel.x != 0u && texel.y != 0u && texel.z != 0u && texel.w != 0u;
    bool partial = false;
    vec4 weight = vec4(0.0);
    if (!(open && farthest(to, t.sheet) <= 2.0)) {
        ivec2 within = ivec2(greaterThanEqual(w, vec2(0.5)));
        uint bits = followLinks(t, ivec2(lower) + within);
        if (!t.alive) return FlowSample(vec2(0.0), 0.0);
        texel = cellOrder(textureGather(wholeFlow, gatherCorner(lower)));
        partial = bits != 0x1FFu;
        if (partial) weight = linkedWeights(bits, within, w);
    }
    t.at = to;
    t.sheet = to;
    vec4 x = fieldX(texel), y = fieldY(texel), noise = fieldNoise(texel);
    if (partial)
        return FlowSample(vec2(blendPartial(x, weight, kOffsetX), blendPartial(y, weight, kOffsetY)) * kFieldUnit,
                          blendPartial(noise, weight, kOffsetNoise));
    return FlowSample(vec2(blendCell(x, w, kOffsetX), blendCell(y, w, kOffsetY)) * kFieldUnit, blendCell(noise, w, kOffsetNoise));
}

// A streamline ends where the vector vanishes, and where it turns by more than a right angle within a step.
bool flowsOn(vec2 from, vec2 to) { return fma(from.x, to.x, from.y * to.y) > 2.0; }

// The flow at a pixel itself.
FlowSample flowAtPixel(uint texel)
{
    return FlowSample(vec2(float(texelDx(texel)), float(texelDy(texel))), float(texelNoise(texel)) - kNoiseZero);
}

// The length in the image of one step of flow v, pixels.
float stepLength(vec2 v) { return sqrt(fma(v.x, v.x, v.y * v.y)) * flowUnitPx; }

vec2 stepped(vec2 from, vec2 v, float unit) { return vec2(fma(v.x, unit, from.x), fma(v.y, unit, from.y)); }
