// Values of oriented streaks that flow, from what is kept (render/lic/phase_mix.h). MEAN: the mean of all phases.
layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D cosineCosine;
layout(binding = 1) uniform sampler2D cosineSine;
layout(binding = 2) uniform sampler2D sineCosine;
layout(binding = 3) uniform sampler2D sineSine;
layout(binding = 4) uniform sampler2D mean;
layout(binding = 5) uniform usampler2D flow;
layout(r32f, binding = 0) writeonly uniform image2D licImage;
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, texels.
#if !MEAN
layout(location = 1) uniform vec2 turned;  // Cosine and sine of the phase.
#endif

void main()
{
    ivec2 texel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, area.zw)) || texelFetch(flow, texel, 0).r == 0u) return;
    // Where along the streak the pixel lies, times how bright the streak is.
    precise float re = texelFetch(cosineCosine, texel, 0).r - texelFetch(sineSine, texel, 0).r;
    precise float im = -(texelFetch(cosineSine, texel, 0).r + texelFetch(sineCosine, texel, 0).r);
    precise float bright = sqrt(fma(re, re, im * im));
#if MEAN
    precise float value = fma(bright, kCometMean, -kCometTakenOff);
#else
    precise float inverse = 1.0 / max(bright, 1e-6);
    precise float c = fma(re, turned.x, im * turned.y) * inverse, s = (im * turned.x - re * turned.y) * inverse;
    precise float c2 = (c + c) * c - 1.0, s2 = (c + c) * s;
    precise float c3 = c * ((c2 + c2) - 1.0), s3 = s * fma(c2, 2.0, 1.0);
    precise float first = fma(kCometCosine[0], c, kCometSine[0] * s), second = fma(kCometCosine[1], c2, kCometSine[1] * s2);
    precise float comet = first + (second + fma(kCometCosine[2], c3, kCometSine[2] * s3));
    precise float value = fma(bright * kCometContrast, comet, texelFetch(mean, texel, 0).r);
#endif
    imageStore(licImage, texel, vec4(value));
}
