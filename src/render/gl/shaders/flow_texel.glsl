// render/gbuffer.h: 12 bits of displacement in x, 12 in y, 8 of noise; 0: no flow.

uint packTexel(ivec2 displacement, int noise)
{
    return (uint(displacement.x) << kDxShift) | ((uint(displacement.y) & 0xFFFu) << kDyShift) | uint(noise);
}
int texelDx(uint texel) { return int(texel) >> 20; }
int texelDy(uint texel) { return int(texel << 12) >> 20; }
int texelNoise(uint texel) { return int(texel & 0xFFu); }
