// Which tiles of kNearTile squared pixels hold any flow.
#include "tiles.glsl"
layout(local_size_x = kNearTile, local_size_y = kNearTile) in;
layout(binding = 0) uniform usampler2D flow;
layout(std430, binding = 0) writeonly buffer TileFlags { uint tileFlags[]; };

shared uint anyFlow;

void main()
{
    if (gl_LocalInvocationIndex == 0u) anyFlow = 0u;
    barrier();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool mine = pixel.x < tiling.size.x && pixel.y >= tiling.rows.x && pixel.y < tiling.rows.y;
    if (mine && texelFetch(flow, pixel, 0).r != 0u) atomicOr(anyFlow, 1u);
    barrier();
    if (gl_LocalInvocationIndex == 0u) tileFlags[gl_WorkGroupID.y * uint(tiling.tiles.x) + gl_WorkGroupID.x] = anyFlow;
}
