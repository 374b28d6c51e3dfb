// A trace's weighted sum (noise bytes times pixels), weighted length, and how many pixels of full weight vary as much, to the
// LIC value (lic_kernel.h).
layout(location = 2) uniform vec3 contrastModel;  // zeroLength, perLength, inverse mean weight * noise unit
layout(location = 5) uniform vec3 phase;  // Cosine, sine, 1 / steps

float licValue(float sum, float lengthPx, float effectivePx)
{
    float power = fma(effectivePx * effectivePx, contrastModel.y, contrastModel.x);
    return (sum / lengthPx) * (sqrt(sqrt(power)) * contrastModel.z);
}

float effectivePixels(float total, float own, float down, float downWidth, float up, float upWidth)
{
    float both = fma(down, 1.0 + downWidth, up * (1.0 + upWidth));
    return total * total / fma(0.5, both, own);
}

float ownLength(FlowSample origin) { return max(stepLength(origin.v), kShortestOwnPx); }

#if WEIGHTED
// Sine and cosine of pi x, as on the processor (contrast-inl.h).
vec2 sinCosPi(float x)
{
    float angle = (x - 0.5) * 3.14159265, z = angle * angle;
    float sine = fma(fma(fma(fma(1.0 / 40320.0, z, -1.0 / 720.0), z, 1.0 / 24.0), z, -0.5), z, 1.0);
    float cosine = fma(fma(fma(fma(1.0 / 362880.0, z, -1.0 / 5040.0), z, 1.0 / 120.0), z, -1.0 / 6.0), z, 1.0);
    return vec2(sine, -angle * cosine);
}

// The squared weight of a Hann kernel between its ends (ContrastModel), for the cosine and sine of a phase.
float squaredWeight(vec2 ahead, vec2 behind, float whole, vec2 turn)
{
    float once = turn.x * (ahead.x + behind.x) - turn.y * (ahead.y - behind.y);
    vec2 twice = vec2(1.0 - 2.0 * turn.y * turn.y, 2.0 * turn.x * turn.y);
    float sines = 2.0 * (ahead.x * ahead.y + behind.x * behind.y);
    float cosines = 2.0 * (behind.x * behind.x - ahead.x * ahead.x);
    return whole + 0.636619772 * once + 0.0795774715 * (twice.x * sines - twice.y * cosines);
}

float phaseGain(float own, float down, float up)
{
    if (phase.x == 1.0) return 1.0;
    float ahead = min((down + 0.5 * own) * (phase.z / own), 1.0), behind = min((up + 0.5 * own) * (phase.z / own), 1.0);
    vec2 a = sinCosPi(ahead), b = sinCosPi(behind);
    float whole = 1.5 * (ahead + behind), atRest = squaredWeight(a, b, whole, vec2(1.0, 0.0));
    float now = squaredWeight(a, b, whole, phase.xy);
    return sqrt(atRest / max(now, atRest / (kMostPhaseGain * kMostPhaseGain)));
}
#else
float phaseGain(float own, float down, float up) { return 1.0; }
#endif
