// A pixel's value with its links in the low bits, so that one look-up brings both (render/lic/along_flow.h).
#include "near_tile.glsl"
layout(binding = 0) uniform sampler2D lic;
layout(binding = 1) uniform usampler2D links;
layout(r32ui, binding = 0) writeonly uniform uimage2D words;

void main()
{
    ivec2 pixel = nearPixel();
    if (pixel.x < 0) return;
    uint mask = texelFetch(links, pixel, 0).r;
    imageStore(words, pixel, uvec4((floatBitsToUint(texelFetch(lic, pixel, 0).r) & ~0xFFu) | mask));
}
