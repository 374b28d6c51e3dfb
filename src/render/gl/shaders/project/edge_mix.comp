// Puts the edge pixels' colours into the picture, once all are found: their neighbours' were looked up in it.
#include "edge_list.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 4) writeonly buffer Pixels { uint pixels[]; };  // RGBA bytes of the rows `shown`.
layout(location = 1) uniform ivec4 shown;  // x0, y0, x1, y1, global pixels.

void main()
{
    for (uint i = gl_GlobalInvocationID.x; i < edgeList.edgeCount; i += gl_NumWorkGroups.x * 64u) {
        ivec2 pixel = placeOf(i);
        pixels[uint(pixel.y - shown.y) * uint(shown.z - shown.x) + uint(pixel.x - shown.x)] = edgeList.edgePixels[i].y;
    }
}
