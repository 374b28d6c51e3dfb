// Traces: how they move from pixel to pixel without leaving their sheet of the surface, and the flow they meet there
// (cpu/lic/sheets-inl.h, cpu/lic/trace-inl.h). Positions count from the starting pixel's centre, so that a trace's arithmetic is
// the same wherever in the image, and in whichever stripe, it runs.
layout(binding = 0) uniform usampler2D flow;       // flow_texel, one by one.
layout(binding = 1) uniform usampler2D links;
layout(binding = 2) uniform usampler2D openFlow;   // flow_cells.comp; zeros beyond the border.
layout(binding = 3) uniform usampler2D wholeFlow;
layout(location = 1) uniform float flowUnitPx;

struct Trace {
    vec2 at;     // Pixels from the start.
    vec2 sheet;  // A position near by whose nearest pixel is on the trace's sheet for certain.
    bool alive;
};

ivec2 startPixel;                  // Counted in the rows held.
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
    precise vec2 lower = floor(position), within = position - lower;
    return ivec2(lower) + ivec2(greaterThanEqual(within, vec2(0.5)));
}

// Link masks with the pixel itself in the middle: bit (sy + 1) * 3 + (sx + 1). Beyond the rows held: itself alone.
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

// Bilinear, in the order (0,0) (1,0) (0,1) (1,1).
vec4 bilinear(vec2 w)
{
    precise float both = w.x * w.y, right = w.x - both, below = w.y - both, own = (1.0 - w.x) - below;
    return vec4(own, right, below, both);
}

float blend(vec4 weight, vec4 v)
{
    precise float sum = fma(weight.y, v.y, weight.x * v.x) + fma(weight.w, v.w, weight.z * v.z);
    return sum;
}

// The weights of those taps that are linked to the nearest pixel, whose nine bits are `bits`. Their sum is 1.
vec4 linkedWeights(uint bits, ivec2 nearestWithinCell, vec4 weight)
{
    // Seen from the nearest pixel the four taps are bits shift + {0, 1, 3, 4} of its nine.
    bits >>= uint(4 - nearestWithinCell.x - 3 * nearestWithinCell.y);
    weight = vec4((bits & 1u) != 0u ? weight.x : 0.0, (bits & 2u) != 0u ? weight.y : 0.0,
                  (bits & 8u) != 0u ? weight.z : 0.0, (bits & 16u) != 0u ? weight.w : 0.0);
    precise vec4 scaled = weight * (1.0 / (((weight.x + weight.y) + weight.z) + weight.w));
    return scaled;
}

float farthest(vec2 a, vec2 b) { return max(abs(a.x - b.x), abs(a.y - b.y)); }

// Fields of words as floats, by their bits alone: a conversion costs a GPU several times as much. n < 2^23 becomes
// 2^23 + n, and 2^23 is subtracted, without rounding. `sign`: the bit that is the field's sign. A compiler that
// reorders these sums loses the bits that count: they are precise.
const float kTwo23 = 8388608.0;
vec4 aboveTwo23(uvec4 bits, uint sign) { return uintBitsToFloat(bits ^ (0x4B000000u | sign)); }
vec4 fieldOf(uvec4 bits, uint sign)
{
    precise vec4 field = aboveTwo23(bits, sign) - (kTwo23 + float(sign));
    return field;
}

// A field together with those below it, `unit` each, as a conversion of the whole word rounds it: once.
vec4 fieldWithBelow(uvec4 bits, uint sign, uvec4 below, float unit)
{
    precise vec4 upper = aboveTwo23(bits, sign) - (kTwo23 + float(sign) + kTwo23 * unit), lower = aboveTwo23(below, 0u);
    precise vec4 field = vec4(fma(lower.x, unit, upper.x), fma(lower.y, unit, upper.y), fma(lower.z, unit, upper.z), fma(lower.w, unit, upper.w));
    return field;
}

struct FlowSample {
    vec2 v;       // Displacement per step, flow units; 0 where the trace has ended.
    float noise;  // In bytes of the texture it came from, 0 on average.
    vec2 right, down;  // How v changes a pixel to the right, and down; 0 between pixels of several sheets.
};
FlowSample noFlow() { return FlowSample(vec2(0.0), 0.0, vec2(0.0), vec2(0.0)); }

// A cell's texels as floats (cpu/lic/flow_cells.h): flow units, 256ths of them, noise bytes.
vec4 cellX(uvec4 texel) { return fieldWithBelow(texel >> 20, 0x800u, texel & 0xFFFFFu, 1.0 / 1048576.0); }
vec4 cellY(uvec4 texel) { return fieldOf(texel & 0xFFFFFu, 0x80000u); }
vec4 cellNoise(uvec4 texel) { return fieldOf(texel & 0xFFu, 0u); }

// The flow at `to`. Moves the trace there, along links; one that cannot get there ends.
FlowSample sampleFlow(inout Trace t, vec2 to)
{
    precise vec2 lower = floor(to), w = to - lower;
    uvec4 texel = cellOrder(textureGather(openFlow, gatherCorner(lower)));
    bool open = texel.x != 0u && texel.y != 0u && texel.z != 0u && texel.w != 0u;
    vec4 weight = bilinear(w);
    float whole = 1.0;
    if (!(open && farthest(to, t.sheet) <= float(kOpenReachPx))) {
        ivec2 within = ivec2(greaterThanEqual(w, vec2(0.5)));
        uint bits = followLinks(t, ivec2(lower) + within);
        if (!t.alive) return noFlow();
        texel = cellOrder(textureGather(wholeFlow, gatherCorner(lower)));
        if (bits != kAllNine) {
            weight = linkedWeights(bits, within, weight);
            whole = 0.0;
        }
    }
    t.at = to;
    t.sheet = to;
    texel.x = (texel.x + (texel.x >> 1 & 1u)) & ~1u;  // The processor keeps a flag in the first one's lowest bit: its noise is even.
    vec4 x = cellX(texel), y = cellY(texel) * (1.0 / 256.0);
    vec2 upper = vec2(x.y - x.x, y.y - y.x), left = vec2(x.z - x.x, y.z - y.x);
    vec2 both = vec2(x.w - x.z, y.w - y.z) - upper;
    return FlowSample(vec2(blend(weight, x), blend(weight, y)), blend(weight, cellNoise(texel)) - float(kNoiseZero),
                      whole * vec2(fma(w.y, both.x, upper.x), fma(w.y, both.y, upper.y)),
                      whole * vec2(fma(w.x, both.x, left.x), fma(w.x, both.y, left.y)));
}

// The stream tube's width after half a step at `s`, in widths before it, at most 1 (cpu/lic/trace-inl.h). `unitPx`: of the
// vectors, negative for a trace upstream; 0 leaves all widths as they are.
float halfNarrowing(FlowSample s, float unitPx)
{
    vec2 v = s.v * unitPx;
    float across = fma(v.y, fma(-v.x, s.down.x, v.y * s.right.x), v.x * fma(-v.y, s.right.y, v.x * s.down.y));
    float squared = max(fma(v.x, v.x, v.y * v.y), 1e-12);
    float half_ = max(fma(-across, 0.5 * unitPx, squared * (-0.5 * kSteadyWidth)), 0.0);
    float fourth = squared * squared;
    return fourth / fma(half_, fma(0.5, half_, squared), fourth);
}

// A streamline ends where the vector vanishes, and where it turns by more than a right angle within a step.
bool flowsOn(vec2 from, vec2 to) { return fma(from.x, to.x, from.y * to.y) > kVanishing; }

// The flow at a pixel itself.
FlowSample flowAtPixel(uint texel)
{
    return FlowSample(vec2(float(texelDx(texel)), float(texelDy(texel))), float(texelNoise(texel)) - float(kNoiseZero),
                      vec2(0.0), vec2(0.0));
}

// The length in the image of one step of flow v, pixels.
float stepLength(vec2 v) { return sqrt(fma(v.x, v.x, v.y * v.y)) * flowUnitPx; }

vec2 stepped(vec2 from, vec2 v, float unit)
{
    precise vec2 end = vec2(fma(v.x, unit, from.x), fma(v.y, unit, from.y));
    return end;
}
