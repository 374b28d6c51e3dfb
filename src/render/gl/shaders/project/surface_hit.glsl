// Where rays meet their triangles (cpu/project/surface_hit-inl.h, line by line). Needs view.glsl and arithmetic.glsl.
layout(std430, binding = 0) readonly buffer Triangles { uint triangles[]; };
layout(std430, binding = 1) readonly buffer Vertices { vec4 vertices[]; };  // Three each: VertexRecord.

struct Hit {
    uint triangle;
    uvec3 vertex;
    float u, v;
    vec3 fromEye;
    vec3 facetNormal;
    float facetOffset;
    vec3 smoothNormal;
    float scalar;
    uint mark;  // render/surface_mark.h
};

float interpolate(float a, float b, float c, float u, float v)
{
    precise float between = fma(c - a, v, fma(b - a, u, a));
    return between;
}
vec3 interpolate3(vec3 a, vec3 b, vec3 c, float u, float v)
{
    return vec3(interpolate(a.x, b.x, c.x, u, v), interpolate(a.y, b.y, c.y, u, v), interpolate(a.z, b.z, c.z, u, v));
}

// The ray through the pixel's centre against its triangle's plane (Möller & Trumbore 1997), kept inside the triangle.
Hit intersect(uint triangle, float xs, float ys)
{
    Hit hit;
    hit.triangle = triangle;
    hit.vertex = uvec3(triangles[3u * triangle], triangles[3u * triangle + 1u], triangles[3u * triangle + 2u]);
    vec4 a = vertices[3u * hit.vertex.x], b = vertices[3u * hit.vertex.y], c = vertices[3u * hit.vertex.z];
    vec4 restA = vertices[3u * hit.vertex.x + 1u], restB = vertices[3u * hit.vertex.y + 1u], restC = vertices[3u * hit.vertex.z + 1u];
    precise vec3 p0 = a.xyz, e1 = b.xyz - p0, e2 = c.xyz - p0;
    vec3 ray = along(along(view.forwardAndNear.xyz, -view.upAndCenterY.xyz, ys), view.rightAndCenterX.xyz, xs);
    precise vec3 toEye = view.eyeAndFocal.xyz - p0;
    vec3 p = cross3(ray, e2), q = cross3(toEye, e1);
    float determinant = dot3(e1, p);
    precise float inverse = 1.0 / (determinant == 0.0 ? 1.0 : determinant);
    precise float u = min(max(dot3(toEye, p) * inverse, 0.0), 1.0), v = min(max(dot3(ray, q) * inverse, 0.0), 1.0 - u);
    precise vec3 fromEye = along(along(p0, e1, u), e2, v) - view.eyeAndFocal.xyz;
    hit.u = u;
    hit.v = v;
    hit.fromEye = fromEye;
    hit.facetNormal = cross3(e1, e2);
    hit.facetOffset = -dot3(hit.facetNormal, toEye);
    hit.smoothNormal = interpolate3(vec3(a.w, restA.xy), vec3(b.w, restB.xy), vec3(c.w, restC.xy), hit.u, hit.v);
    hit.scalar = interpolate(restA.z, restB.z, restC.z, hit.u, hit.v);
    hit.mark = uint(restA.w);
    return hit;
}

// Interpolated, unit length; the facet's own where the vertices' cancel.
vec3 shadingNormal(Hit hit)
{
    vec3 n = dot3(hit.smoothNormal, hit.smoothNormal) > 1e-8 ? hit.smoothNormal : hit.facetNormal;
    precise vec3 unit = n * inverseLength(max(dot3(n, n), 1e-36));
    return unit;
}

// Change of 1/depth per pixel to the right and downwards on the hit's own facet.
vec2 depthGradient(Hit hit)
{
    precise float perPixel = hit.facetOffset == 0.0 ? 0.0 : view.inverseFocal * (1.0 / hit.facetOffset);
    precise vec2 gradient = vec2(dot3(hit.facetNormal, view.rightAndCenterX.xyz) * perPixel,
                                 -(dot3(hit.facetNormal, view.upAndCenterY.xyz) * perPixel));
    return gradient;
}

float facingOf(vec3 normal, Hit hit)
{
    precise float facing = -(dot3(normal, hit.fromEye) * inverseLength(dot3(hit.fromEye, hit.fromEye)));
    return facing;
}

// render/shading_model.h's light.
float lightOn(vec3 normal, float facing)
{
    vec3 softLight = along(along(kSoftRight * view.rightAndCenterX.xyz, view.upAndCenterY.xyz, kSoftUp),
                           view.forwardAndNear.xyz, kSoftForward);
    precise float headlight = fma(kDiffuse, abs(facing), kAmbient + 0.5 * kSoft);
    precise float soft = (clamp(kSoftTurn * facing, -1.0, 1.0) * dot3(normal, softLight)) * (0.5 * kSoft);
    precise float light = headlight + soft;
    return light;
}
