// Packs what a trace has walked as a jump of `level`.
layout(r32ui, binding = 0) writeonly uniform uimage2DArray placeImage;
layout(r32ui, binding = 1) writeonly uniform uimage2DArray metaImage;
#if WEIGHTED
layout(r32ui, binding = 2) writeonly uniform uimage2DArray weightedImage;
#endif

uint wordField(float v, int least, int most) { return uint(clamp(int(roundEven(v)), least, most)); }

void storeJump(ivec2 pixel, int level, int direction, Trace t, Walk walk, bool open)
{
    ivec3 texel = ivec3(pixel, layerOf(level, direction));
    vec4 perUnit = jumpPlan.perUnit[level];
    uint word = t.alive ? kAliveBit : 0u;
    precise float lengthUnits = walk.lengthPx * perUnit.z - float(word) / float(1 << kLengthShift);
    word |= wordField(lengthUnits, 0, kLengthMost) << kLengthShift;
    precise float sumUnits = walk.sum * perUnit.y - float(word) / float(1 << kSumShift);
    uint sum = wordField(sumUnits, -kSumMost, kSumMost);
    word |= (sum & uint(2 * kSumMost + 1)) << kSumShift;
    word |= wordField(walk.width * float(kWidthOne), 0, kWidthOne) << kWidthShift;
    imageStore(placeImage, texel, uvec4(halves(t.at.x * perUnit.x, t.at.y * perUnit.x)));
    imageStore(metaImage, texel, uvec4(word | (open ? kOpenBit : 0u)));
#if WEIGHTED
    imageStore(weightedImage, texel, uvec4(halves(walk.weighted.x * perUnit.w, walk.weighted.y * perUnit.w)));
#endif
}

// Background: a jump that goes nowhere.
void storeNoJump(ivec2 pixel, int level, int direction)
{
    ivec3 texel = ivec3(pixel, layerOf(level, direction));
    imageStore(placeImage, texel, uvec4(0u));
    imageStore(metaImage, texel, uvec4(0u));
#if WEIGHTED
    imageStore(weightedImage, texel, uvec4(0u));
#endif
}
