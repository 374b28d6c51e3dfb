// The edge pixels of some rows. Each has a number, in an order that no result depends on.
layout(std430, binding = 3) buffer EdgeList {
    uint edgeCount;  // How many there are.
    uint smallCount, mediumCount, largeCount;  // How many triangles lie near them: edge_near.comp.
    uvec2 edgePixels[];  // x and y of each, 16 bits each, global; its colour.
} edgeList;
layout(location = 20) uniform ivec2 held;  // There are samples of the pixels from number held.x on, of held.y of them.

ivec2 placeOf(uint number)
{
    uint place = edgeList.edgePixels[number].x;
    return ivec2(place & 0xFFFFu, place >> 16);
}
