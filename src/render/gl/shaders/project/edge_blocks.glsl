// Which pixels are edge pixels, in blocks of 8 x 8. Most blocks have none.
const int kBlock = 8;
layout(std430, binding = 2) buffer EdgeBlocks { uvec4 blocks[]; };  // A bit a pixel, row after row; the first one's number.
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, global pixels. The blocks begin at its corner.

int blocksPerRow() { return (area.z - area.x + kBlock - 1) / kBlock; }

uint lowBits(int count) { return count >= 32 ? 0xFFFFFFFFu : (1u << uint(count)) - 1u; }

// A bit for each pixel of a block whose column is in [x0, x1) and whose row in [y0, y1), counted from the block's corner.
uvec2 pixelsWithin(ivec2 low, ivec2 high)
{
    low = clamp(low, 0, kBlock);
    high = clamp(high, 0, kBlock);
    if (any(greaterThanEqual(low, high))) return uvec2(0u);
    uint columns = (lowBits(high.x) & ~lowBits(low.x)) * 0x01010101u;
    return columns & uvec2(lowBits(8 * min(high.y, 4)) & ~lowBits(8 * min(low.y, 4)),
                           lowBits(8 * max(high.y - 4, 0)) & ~lowBits(8 * max(low.y - 4, 0)));
}

// The number of a block's pixel.
uint numberIn(uvec4 block, uint pixel)
{
    uvec2 before = uvec2(lowBits(int(min(pixel, 32u))), lowBits(int(max(pixel, 32u)) - 32));
    return block.z + uint(bitCount(block.x & before.x)) + uint(bitCount(block.y & before.y));
}

// Where the bit number n of those set in a block is.
uint nthOf(uvec2 marked, uint n)
{
    uint before = uint(bitCount(marked.x)), word = marked.x, at = 0u;
    if (n >= before) {
        word = marked.y;
        at = 32u;
        n -= before;
    }
    for (uint bits = 16u; bits > 0u; bits >>= 1) {
        uint below = uint(bitCount(word & lowBits(int(bits))));
        if (n < below) continue;
        n -= below;
        word >>= bits;
        at += bits;
    }
    return at;
}
