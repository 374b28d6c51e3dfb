// Mixes the values of three phases to those of another (render/lic/phase_mix.h).
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D first;
layout(binding = 1) uniform sampler2D second;
layout(binding = 2) uniform sampler2D third;
layout(r32f, binding = 0) writeonly uniform image2D licImage;
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, texels.
layout(location = 1) uniform vec3 weights;

void main()
{
    ivec2 texel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, area.zw))) return;
    vec3 values = vec3(texelFetch(first, texel, 0).r, texelFetch(second, texel, 0).r, texelFetch(third, texel, 0).r);
    precise float mixed = weights.x * values.x + weights.y * values.y + weights.z * values.z;
    imageStore(licImage, texel, vec4(mixed));
}
