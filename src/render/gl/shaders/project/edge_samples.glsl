// What is seen at the samples of edge pixels. Of the nearest triangle 1/depth comes first; of those that are as near the
// one with the smallest number is named then.
#include "edge_list.glsl"
layout(std430, binding = 5) buffer Samples { uint samples[]; };  // A pixel: the bits of 1/depth of all, then ~triangle.

uint depthWord(uint number, int s) { return (number - uint(held.x)) * uint(2 * kSamples) + uint(s); }
uint triangleWord(uint number, int s) { return depthWord(number, kSamples + s); }
bool hasSamples(uint number) { return number - uint(held.x) < uint(held.y); }
