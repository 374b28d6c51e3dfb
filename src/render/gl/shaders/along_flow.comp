// The second, short convolution along the flow (render/lic/along_flow.h, cpu/lic/cpu_along_flow.cpp).
#include "near_tile.glsl"
#include "flow_texel.glsl"
layout(binding = 0) uniform usampler2D flow;
layout(binding = 1) uniform usampler2D words;
layout(r32f, binding = 0) writeonly uniform image2D licImage;
layout(location = 1) uniform float gain;

const float kWeights[kAlongRows + 1] = float[](kAlongWeight0, kAlongWeight1, kAlongWeight2, kAlongWeight3);

float valueOf(uint word) { return uintBitsToFloat(word & ~0xFFu); }

int linkBit(ivec2 to)
{
    int k = (to.y + 1) * 3 + to.x + 1;
    return k > 4 ? k - 1 : k;
}

void main()
{
    ivec2 pixel = nearPixel();
    if (pixel.x < 0) return;
    uint texel = texelFetch(flow, pixel, 0).r;
    if (texel == 0u) return;
    ivec2 v = ivec2(texelDx(texel), texelDy(texel));
    ivec2 along = abs(v), sense = ivec2(v.x < 0 ? -1 : 1, v.y < 0 ? -1 : 1);
    bool wide = along.x >= along.y, flows = v.x * v.x + v.y * v.y > int(kVanishing);
    int longer = max(along.x, along.y), shorter = min(along.x, along.y);
    ivec2 straight = wide ? ivec2(sense.x, 0) : ivec2(0, sense.y), aside = sense - straight;
    uint own = texelFetch(words, pixel, 0).r;
    precise float sum = kWeights[0] * valueOf(own), weight = 0.0, most = 0.0;
    for (int k = 1; k <= kAlongRows; ++k) most += 2.0 * kWeights[k];
    for (int side = 1; side >= -1 && flows; side -= 2) {
        ivec2 at = pixel;
        uint links = own;
        int asideBefore = 0;
        for (int k = 1; k <= kAlongRows; ++k) {
            int pixelsAside = (2 * k * shorter + longer) / (2 * longer);
            ivec2 hop = side * (pixelsAside > asideBefore ? straight + aside : straight);
            if ((links >> linkBit(hop) & 1u) == 0u) break;
            asideBefore = pixelsAside;
            at += hop;
            links = texelFetch(words, at, 0).r;
            sum = fma(kWeights[k], valueOf(links), sum);
            weight = weight + kWeights[k];
        }
    }
    float raised = fma(weight, (gain - 1.0) / most, 1.0);
    imageStore(licImage, pixel, vec4(sum / (weight + kWeights[0]) * raised));
}
