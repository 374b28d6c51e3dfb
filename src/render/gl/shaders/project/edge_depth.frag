// Clears a picture of which edge pixels alone are drawn: everywhere else something nearer than anything is there
// already.
#include "view.glsl"
layout(binding = 0) uniform usampler2D edges;
layout(location = 1) uniform float farthest;
layout(location = 0) out uint triangle;

void main()
{
    ivec2 texel = ivec2(gl_FragCoord.xy) - ivec2(0, view.firstRow);
    gl_FragDepth = texelFetch(edges, texel, 0).r != 0u ? farthest : 1.0;
    triangle = 0u;
}
