// Nothing but gathers of four texels, each a step beside the last, as a trace's are: how fast the device does them.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D texels;  // All zero.
layout(std430, binding = 0) buffer Sums { uint sums[]; };
layout(location = 0) uniform int gathers;

void main()
{
    vec2 scale = 1.0 / vec2(textureSize(texels, 0)), at = (vec2(gl_GlobalInvocationID.xy) + 1.0) * scale;
    uint sum = 0u;
    for (int i = 0; i < gathers; ++i) {
        uvec4 four = textureGather(texels, at);
        sum += (four.x ^ four.y) + (four.z ^ four.w);
        at += vec2(0.8, 0.6) * scale * (1.0 + uintBitsToFloat(four.x));  // Where to go next is known only now.
    }
    if (sum != 0u) sums[0] = sum;
}
