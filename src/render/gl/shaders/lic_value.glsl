// A trace's weighted sum (noise bytes times pixels) and walked length (pixels) to the LIC value (lic_kernel.h).
layout(location = 2) uniform vec3 contrastModel;  // zeroLength, perLength, inverse mean weight * noise unit

float licValue(float sum, float lengthPx)
{
    float power = fma(lengthPx * lengthPx, contrastModel.y, contrastModel.x);
    return (sum / lengthPx) * (sqrt(sqrt(power)) * contrastModel.z);
}

float ownLength(FlowSample origin) { return max(stepLength(origin.v), kShortestOwnPx); }
