// The blending stage (render/shading_model.h): base colour, light and LIC on the surface, the background elsewhere.
#include "view.glsl"
#include "arithmetic.glsl"
#include "surface_color.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
layout(binding = 1) uniform sampler2D surface;  // invDepth, gradX, gradY, light
layout(binding = 2) uniform usampler2D flow;
layout(binding = 3) uniform sampler2D lic;
layout(binding = 4) uniform sampler2D scalars;
layout(binding = 5) uniform usampler2D colors;
layout(std430, binding = 0) writeonly buffer Pixels { uint pixels[]; };  // RGBA bytes of the rows shaded.
layout(std430, binding = 1) readonly buffer Open { float open[]; };  // Of the same rows, with occlusion.
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, global pixels.

void main()
{
    ivec2 pixel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, area.zw))) return;
    ivec2 texel = ivec2(pixel.x, pixel.y - view.firstRow);
    uint color = palette.background, at = uint(pixel.y - area.y) * uint(area.z - area.x) + uint(pixel.x - area.x);
    if (texelFetch(visible, pixel, 0).r != 0u) {
        bool streaks = palette.hasLic && texelFetch(flow, texel, 0).r != 0u;
        float light = texelFetch(surface, texel, 0).w;
        if (palette.occlusion) light *= open[at];
        color = surfaceColor(streaks ? texelFetch(lic, texel, 0).r : 0.0, light,
                             palette.useScalar ? texelFetch(scalars, texel, 0).r : 0.0,
                             palette.several ? texelFetch(colors, texel, 0).r : 0u);
    }
    pixels[at] = color;
}
