// Which pixels lie at an edge (cpu/edges/find_edges.h).
#include "view.glsl"
#include "one_sheet.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
layout(binding = 1) uniform sampler2D surface;  // invDepth, gradX, gradY, light
layout(r8ui, binding = 0) writeonly uniform uimage2D edgeImage;
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, global pixels.
layout(location = 1) uniform float slackPerDepth;
layout(location = 2) uniform bool lighting;

void main()
{
    ivec2 pixel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, area.zw))) return;
    ivec2 first = ivec2(0, view.firstRow);
    bool covered = texelFetch(visible, pixel, 0).r != 0u, edge = false;
    vec4 a = covered ? texelFetch(surface, pixel - first, 0) : vec4(0.0);
    float own = abs(a.w), least = own, most = own, nine[9];
    for (int k = 0; k < 9; ++k) nine[k] = own;
    for (int sy = -1; sy <= 1; ++sy)
        for (int sx = -1; sx <= 1; ++sx) {
            ivec2 other = pixel + ivec2(sx, sy);
            if (any(lessThan(other, ivec2(0))) || any(greaterThanEqual(other, view.imageSize))) continue;
            bool there = texelFetch(visible, other, 0).r != 0u;
            if (there != covered) edge = true;
            if (!there || !covered) continue;
            vec4 b = texelFetch(surface, other - first, 0);
            if (!onOneSheet(predict(a.xyz, b.xyz, vec2(sx, sy), slackPerDepth))) edge = true;
            nine[(sy + 1) * 3 + sx + 1] = abs(b.w);
            least = min(least, abs(b.w));
            most = max(most, abs(b.w));
        }
    if (lighting && covered && most - least > kLightStep) {  // A crease, if either side is even in itself.
        float middle = (least + most) * 0.5, darkEnd = least, brightBegin = most;
        for (int k = 0; k < 9; ++k) {
            if (nine[k] > middle) brightBegin = min(brightBegin, nine[k]);
            else darkEnd = max(darkEnd, nine[k]);
        }
        if (max(darkEnd - least, most - brightBegin) <= (most - least) * kUneven) edge = true;
    }
    imageStore(edgeImage, pixel - first, uvec4(edge ? 1u : 0u));
}
