// Sums of the words to the left and right of each pixel, and how many there are.
layout(local_size_x = 16, local_size_y = 8) in;
layout(std430, binding = 0) readonly buffer Words { uint words[]; };  // Of the rows held, in full width.
layout(std430, binding = 1) writeonly buffer Sums { uvec2 sums[]; };
layout(location = 0) uniform ivec4 held;  // x0, y0, x1, y1, global pixels.
layout(location = 1) uniform int reach;

void main()
{
    ivec2 pixel = held.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, held.zw))) return;
    uint row = uint(pixel.y - held.y) * uint(held.z - held.x);
    uvec2 sum = uvec2(0u);
    for (int x = max(pixel.x - reach, held.x); x <= min(pixel.x + reach, held.z - 1); ++x) {
        uint word = words[row + uint(x - held.x)];
        sum += uvec2(word, word != 0u);
    }
    sums[row + uint(pixel.x - held.x)] = sum;
}
