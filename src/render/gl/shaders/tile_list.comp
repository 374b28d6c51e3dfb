// Lists the tiles near flow: those with any and their neighbours. Only there traces read. In which order they come does
// not matter: every pixel is computed by itself.
#include "tiles.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer TileFlags { uint tileFlags[]; };
layout(std430, binding = 1) buffer TileList {
    uint groups[2][4];  // Arguments of indirect dispatches: a group a tile, and a group a tile and direction.
    uint count, unused[3];
    uint tiles[];
};

void main()
{
    uint tile = gl_GlobalInvocationID.x;
    if (tile >= uint(tiling.tiles.x * tiling.tiles.y)) return;
    ivec2 at = ivec2(int(tile) % tiling.tiles.x, int(tile) / tiling.tiles.x);
    uint any = 0u;
    for (int y = max(at.y - 1, 0); y <= min(at.y + 1, tiling.tiles.y - 1); ++y)
        for (int x = max(at.x - 1, 0); x <= min(at.x + 1, tiling.tiles.x - 1); ++x) any |= tileFlags[y * tiling.tiles.x + x];
    if (any == 0u) return;
    uint slot = atomicAdd(count, 1u);
    tiles[slot] = tile;
    uvec2 grid = uvec2(min(slot + 1u, kRowOfTiles), slot / kRowOfTiles + 1u);  // One dimension alone may be too short.
    for (int k = 0; k < 2; ++k) {
        atomicMax(groups[k][0], grid.x);
        atomicMax(groups[k][1], grid.y);
    }
}
