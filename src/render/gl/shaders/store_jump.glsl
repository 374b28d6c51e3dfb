// Packs what a trace has walked as a jump of `level`.
layout(r32ui, binding = 0) writeonly uniform uimage2DArray placeImage;
layout(r32ui, binding = 1) writeonly uniform uimage2DArray metaImage;
#if HANN
layout(r32ui, binding = 2) writeonly uniform uimage2DArray waveImage;
#endif

void storeJump(ivec2 pixel, int level, int direction, Trace t, Walk walk, bool open)
{
    ivec3 texel = ivec3(pixel, layerOf(level, direction));
    vec3 perUnit = jumpPlan.perUnit[level].xyz;
    uint sum = uint(clamp(int(roundEven(walk.sum * perUnit.y)), -kHalfMost, kHalfMost)) & 0xFFFFu;
    uint walked = uint(min(int(roundEven(walk.lengthPx * perUnit.z)), kLengthMost));
    imageStore(placeImage, texel, uvec4(halves(t.at.x * perUnit.x, t.at.y * perUnit.x)));
    imageStore(metaImage, texel, uvec4(sum | (open ? kOpenBit : 0u) | (t.alive ? kAliveBit : 0u) | walked << kLengthShift));
#if HANN
    imageStore(waveImage, texel, uvec4(halves(walk.wave.x * perUnit.y, walk.wave.y * perUnit.y)));
#endif
}

// Background: a jump that goes nowhere.
void storeNoJump(ivec2 pixel, int level, int direction)
{
    ivec3 texel = ivec3(pixel, layerOf(level, direction));
    imageStore(placeImage, texel, uvec4(0u));
    imageStore(metaImage, texel, uvec4(0u));
#if HANN
    imageStore(waveImage, texel, uvec4(0u));
#endif
}
