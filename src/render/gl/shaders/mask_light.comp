// Gives the light of masked pixels its sign, where other ranks' bricks found them (resolve.comp does it elsewhere).
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D masked;
layout(rgba32f, binding = 0) uniform image2D surfaceImage;
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, texels.

void main()
{
    ivec2 texel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, area.zw)) || texelFetch(masked, texel, 0).r == 0u) return;
    vec4 seen = imageLoad(surfaceImage, texel);
    imageStore(surfaceImage, texel, vec4(seen.xyz, -seen.w));
}
