// A workgroup of 256 pixels on one of the listed tiles; warps take blocks of 8x4, whose traces stay together.
#include "tiles.glsl"
layout(local_size_x = kNearTile * kNearTile) in;
layout(std430, binding = 1) readonly buffer TileList {
    uint groups[2][4];
    uint count, unused[3];
    uint tiles[];
} tileList;
layout(location = 0) uniform ivec2 computeRows;  // What is written, counted in the rows held; half-open.

// This invocation's pixel, of the rows held; x is -1 where it has none.
ivec2 nearPixel()
{
    uint slot = gl_WorkGroupID.y * kRowOfTiles + gl_WorkGroupID.x;
    if (slot >= tileList.count) return ivec2(-1);
    int tile = int(tileList.tiles[slot]), i = int(gl_LocalInvocationIndex);
    ivec2 corner = kNearTile * ivec2(tile % tiling.tiles.x, tile / tiling.tiles.x);
    ivec2 pixel = corner + ivec2((i & 7) | ((i >> 2) & 8), ((i >> 3) & 3) | ((i >> 4) & 12));
    bool mine = pixel.x < tiling.size.x && pixel.y >= computeRows.x && pixel.y < computeRows.y;
    return mine ? pixel : ivec2(-1);
}
