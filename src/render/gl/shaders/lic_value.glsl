// A trace's weighted sum (noise bytes times pixels), weighted length, and how many pixels of full weight vary as much, to the
// LIC value (lic_kernel.h).
layout(location = 2) uniform vec3 contrastModel;  // zeroLength, perLength, inverse mean weight * noise unit

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
