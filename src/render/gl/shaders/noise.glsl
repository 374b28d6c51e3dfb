// The noise pyramid at P-space positions (render/lic/noise.h). A texel holds the eight corners of its cell, a bit each.
layout(binding = 3) uniform usampler3D noiseCells;

const vec3 kLevelOffset = vec3(kNoiseOffsetX, kNoiseOffsetY, kNoiseOffsetZ);

float noiseTexel(uint cell, int k) { return float(int(cell >> k & 1u) * 2 - 1); }

// Between four corners, from bit k on: a + b x + c y + d x y.
float noiseFace(uint cell, int k, vec3 weight)
{
    precise float a = noiseTexel(cell, k), b = noiseTexel(cell, k + 1) - a, c = noiseTexel(cell, k + 2) - a;
    precise float d = (noiseTexel(cell, k + 3) - noiseTexel(cell, k + 2)) - b;
    precise float value = fma(fma(d, weight.x, c), weight.y, fma(b, weight.x, a));
    return value;
}

const uint kNoGrains = 0u, kGrainHeights = 1u, kGrainCosines = 2u, kGrainSines = 3u;  // GrainValue.

// The cosine or the sine of a grain's phase, as grains::phaseOf() tells it: of the one grain that a cell can have.
float grainPhase(uint cell, ivec3 first)
{
    ivec3 beside = ivec3((cell & 0xAAu) != 0u, (cell & 0xCCu) != 0u, (cell & 0xF0u) != 0u);
    uvec3 grain = uvec3(first + beside & kNoiseSize - 1);
    uint hash = (grain.x | grain.y << 6 | grain.z << 12) * kGrainHashFirst;
    hash = (hash ^ hash >> 15) * kGrainHashSecond;
    return kGrainWave[(hash >> 28) + (view.grains == kGrainSines ? 12u : 0u) & 15u];
}

// Trilinear noise of one level, -1 to 1; `texel` in that level's texels. Of grains with a phase: 0 to 1, times the
// phase's cosine or sine.
float noiseLevel(vec3 texel)
{
    precise vec3 lower = floor(texel), weight = texel - lower;
    ivec3 first = ivec3(lower) & (kNoiseSize - 1);
    uint cell = texelFetch(noiseCells, first, 0).r;
    float level = lerp(noiseFace(cell, 0, weight), noiseFace(cell, 4, weight), weight.z);
    if (view.grains < kGrainCosines) return level;
    precise float value = fma(level, 0.5, 0.5) * grainPhase(cell, first);
    return value;
}

// Noise of grains, 1 or -1 where there is none, as their height above the mean; `m` is 1 to 2 within an octave. That of
// grains with a phase has no mean.
float grainHeight(float noise, float m, float height)
{
    precise float above = (view.grains == kGrainHeights ? fma(noise, 0.5, 0.5 - kGrainShare) : noise) * (m * height);
    return above;
}

// For a footprint in world units: the two levels it lies between, blended, with the contrast of one restored.
float sampleNoise(vec3 local, float footprint)
{
    vec3 texel = vec3(dot3(local, view.noiseRow[0].xyz), dot3(local, view.noiseRow[1].xyz), dot3(local, view.noiseRow[2].xyz));
    precise float scaled = footprint * view.levelFromFootprint;
    int bits = floatBitsToInt(scaled);
    int exponent = (bits >> 23) - 127;
    float mantissa = intBitsToFloat((bits & 0x007FFFFF) | 0x3F800000);
    precise float blend = mantissa - 1.0;
    if (view.grains != kNoGrains) blend = clamp((mantissa - kGrainBlendFrom) * (1.0 / (kGrainBlendTo - kGrainBlendFrom)), 0.0, 1.0);
    float shrink = intBitsToFloat((127 - exponent) << 23);
    float level = float(exponent);
    float fine = noiseLevel(along(level * kLevelOffset, texel, shrink));
    float coarse = noiseLevel(along((level + 1.0) * kLevelOffset, texel, shrink * 0.5));
    precise float keep = 1.0 - blend;
    if (view.grains != kNoGrains) {
        fine = grainHeight(fine, mantissa, kGrainHeight);
        coarse = grainHeight(coarse, mantissa, 0.5 * kGrainHeight);
    }
    precise float value = fma(coarse, blend, fine * keep) * inverseLength(fma(keep, keep, blend * blend));
    return value;
}
