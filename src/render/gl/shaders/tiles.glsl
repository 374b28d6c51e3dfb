// Tiles of kNearTile squared pixels over the rows that the frame's textures hold.
layout(std140, binding = 2) uniform TilingBlock {
    ivec2 size;   // Columns, rows held.
    ivec2 tiles;
    ivec2 rows;   // Where flow counts, of the rows held.
    ivec2 unused;
} tiling;
