// Which triangle a pixel sees. Triangles come in order and only nearer ones replace, so ties go to the smaller number.
layout(location = 0) out uint triangle;  // Plus one; 0: background.

void main() { triangle = uint(gl_PrimitiveID) + 1u; }
