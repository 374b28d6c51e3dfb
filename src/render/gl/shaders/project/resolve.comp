// Resolves each visible pixel once: position, light, tangential vector, noise, scalar (cpu/project/resolve.cpp, line by line).
// BRICK: the field's part alone, of the pixels in this rank's cells, into buffers over `area`. Else into the G-buffer;
// SAMPLED: with vectors, which a split field leaves to others. MIXED: some of several surfaces carry what others are
// sampled for; without HAS_FIELD those alone have vectors here.
#include "view.glsl"
#include "arithmetic.glsl"
#include "flow_texel.glsl"
#if HAS_FIELD || HAS_SCALAR_FIELD
#include "field.glsl"
#endif
#include "noise.glsl"
#include "surface_hit.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform usampler2D visible;
#if HAS_FIELD
layout(binding = 1) uniform sampler3D field;
#endif
#if HAS_SCALAR_FIELD
layout(binding = 2) uniform sampler3D scalarField;
#endif
layout(std430, binding = 2) readonly buffer CellVectors { float cellVectors[]; };
layout(std430, binding = 3) readonly buffer CellScalars { float cellScalars[]; };
#if BRICK
layout(std430, binding = 4) writeonly buffer BrickFlow { uint brickFlow[]; };
layout(std430, binding = 5) writeonly buffer BrickScalar { float brickScalar[]; };
layout(std430, binding = 6) writeonly buffer BrickMask { uint brickMask[]; };
#else
layout(rgba32f, binding = 0) writeonly uniform image2D surfaceImage;  // invDepth, gradX, gradY, light
layout(r32ui, binding = 1) writeonly uniform uimage2D flowImage;
layout(r32f, binding = 2) writeonly uniform image2D scalarImage;
layout(r8ui, binding = 3) writeonly uniform uimage2D colorsImage;
#endif
layout(location = 0) uniform ivec4 area;  // x0, y0, x1, y1, global pixels.

float surfaceScalar(Hit hit)
{
#if CELL_SCALARS
    return cellScalars[hit.triangle];
#elif POINT_SCALARS
    return hit.scalar;
#else
    return notANumber();
#endif
}

vec3 surfaceVector(Hit hit)
{
#if CELL_VECTORS
    return vec3(cellVectors[3u * hit.triangle], cellVectors[3u * hit.triangle + 1u], cellVectors[3u * hit.triangle + 2u]);
#else
    return interpolate3(vertices[3u * hit.vertex.x + 2u].xyz, vertices[3u * hit.vertex.y + 2u].xyz, vertices[3u * hit.vertex.z + 2u].xyz, hit.u, hit.v);
#endif
}

struct Sampled {
    vec3 vector;
    float scalar;
    bool hasVector, inside;
};

// In the view's unit.
void takeVector(vec3 vector, bool known, inout Sampled s)
{
    precise vec3 scaled = vector * view.vectorFactor;
    s.vector = scaled;
    s.hasVector = known && !isnan(s.vector.x + (s.vector.y + s.vector.z));
}

// The part of the vector that needs the normal.
float partByNormal(Sampled s, vec3 normal)
{
    float across = dot3(normal, s.vector);
#if SCALAR_IS_TANGENTIAL
    vec3 tangent = along(s.vector, normal, -across);
    precise float value = sqrt(dot3(tangent, tangent)) * view.vectorUnit;
#else
    precise float value = across * view.vectorUnit;
#endif
    return s.hasVector ? value : notANumber();
}

Sampled sampleData(Hit hit, vec3 normal, vec3 local)
{
    Sampled s;
    s.inside = true;
#if HAS_FIELD
    Cell cell = findCell(vectorLookup, local);
    s.inside = cell.inside;
    takeVector(sampleField(field, cell), s.inside, s);
#else
    takeVector(surfaceVector(hit), MIXED == 0 || (hit.mark & kOwnVectors) != 0u, s);
#endif
#if SCALAR_IS_MAGNITUDE
    s.scalar = s.hasVector ? sqrt(dot3(s.vector, s.vector)) * view.vectorUnit : notANumber();
#elif HAS_SCALAR_FIELD
    Cell scalarCell = findCell(scalarLookup, local);
    s.scalar = scalarCell.inside ? sampleField(scalarField, scalarCell).x : notANumber();
#else
    s.scalar = surfaceScalar(hit);
#endif
#if MIXED && HAS_FIELD
    if ((hit.mark & kOwnVectors) != 0u) takeVector(surfaceVector(hit), true, s);
    if ((hit.mark & kOwnScalar) != 0u) s.scalar = surfaceScalar(hit);
#endif
#if SCALAR_IS_NORMAL || SCALAR_IS_TANGENTIAL
    if (MIXED == 0 || (hit.mark & kOwnScalar) == 0u) s.scalar = partByNormal(s, normal);
#endif
#if SEVERAL_SURFACES
    s.hasVector = s.hasVector && hit.mark < kNoStreaks;
#endif
    return s;
}

// Without its normal component.
vec3 tangentOf(Sampled s, vec3 normal)
{
    vec3 v = s.hasVector ? s.vector : vec3(0.0);
    return along(v, normal, -dot3(normal, v));
}

// Less where the flow along the surface is slow.
float faded(float noise, vec3 tangent)
{
    precise float part = sqrt(dot3(tangent, tangent)) * view.fadePerVector;
    precise float shown = noise * sqrt(min(part, 1.0));
    return shown;
}

// At its length in P-space.
vec3 tangentialStep(vec3 tangent)
{
    precise float size = sqrt(dot3(tangent, tangent));
    precise vec3 step = tangent * (!view.normalizeSteps ? view.vectorScale : size > view.tinyVector ? view.stepLocal / size : 0.0);
    return step;
}

int quantise(float v) { return clamp(int(roundEven(v)), -kDisplacementMax, kDisplacementMax); }

uint packFlow(vec3 step, float xs, float ys, float invDepth, float noise)
{
    precise float pixels = view.eyeAndFocal.w * invDepth;
    float deeper = dot3(step, view.forwardAndNear.xyz);
    precise float dx = pixels * fma(-xs, deeper, dot3(step, view.rightAndCenterX.xyz));
    precise float dy = -(pixels * fma(ys, deeper, dot3(step, view.upAndCenterY.xyz)));
    precise float length2 = fma(dx, dx, dy * dy);
    precise float toUnits = 1.0 / view.flowUnitPx;
    if (length2 > view.maxStepPx * view.maxStepPx) toUnits = (view.maxStepPx * inverseLength(max(length2, 1e-30))) * toUnits;
    precise vec2 units = vec2(dx, dy) * toUnits;
    int noiseByte = clamp(int(roundEven(noise * float(kNoiseMost))) + kNoiseZero, kNoiseZero - kNoiseMost, kNoiseZero + kNoiseMost);
    return packTexel(ivec2(quantise(units.x), quantise(units.y)), noiseByte);
}

void main()
{
    ivec2 pixel = area.xy + ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, area.zw))) return;
    uint seen = texelFetch(visible, pixel, 0).r;
#if BRICK
    uint at = uint(pixel.y - area.y) * uint(area.z - area.x) + uint(pixel.x - area.x);
    uint noFlow = 0u;
    brickFlow[at] = noFlow;
    if (WITH_SCALAR != 0) brickScalar[at] = notANumber();
    if (view.maskBelow > 0.0) brickMask[at] = 0u;
#else
    ivec2 texel = ivec2(pixel.x, pixel.y - view.firstRow);
    if (seen == 0u) imageStore(flowImage, texel, uvec4(0u));  // All that later stages test; the rest is not read there.
#endif
    if (seen == 0u) return;

    precise float xs = (float(pixel.x) - (view.rightAndCenterX.w - 0.5)) * view.inverseFocal;
    precise float ys = (float(pixel.y) + 0.5 - view.upAndCenterY.w) * view.inverseFocal;
    Hit hit = intersect(seen - 1u, xs, ys);
    precise vec3 local = hit.fromEye + view.eyeAndFocal.xyz;
    float depth = max(dot3(hit.fromEye, view.forwardAndNear.xyz), view.forwardAndNear.w);
    precise float invDepth = 1.0 / depth;
    vec3 normal = shadingNormal(hit);
    float facing = facingOf(normal, hit), faces = abs(facing);
#if SAMPLED
    Sampled s = sampleData(hit, normal, local);
    uint flow = 0u;
    bool masked = view.maskBelow > 0.0 && s.hasVector && sqrt(dot3(s.vector, s.vector)) < view.maskBelow;
    if (s.hasVector) {
        // The footprint grows with foreshortening, by the geometric mean of its two sides; beyond 16:1 no further.
        precise float footprint = (depth * view.inverseFocal) / sqrt(max(faces, 1.0 / 16.0));
        vec3 tangent = tangentOf(s, normal);
        float noise = sampleNoise(local, footprint);
        if (view.fadePerVector > 0.0) noise = faded(noise, tangent);
        flow = packFlow(tangentialStep(tangent), xs, ys, invDepth, noise);
    }
    float scalar = s.scalar;
#else
    uint flow = 0u;
    bool masked = false;
    float scalar = surfaceScalar(hit);
#endif
#if BRICK
    if (!s.inside) return;
    brickFlow[at] = flow;
    if (WITH_SCALAR != 0) brickScalar[at] = scalar;
    // Pixels of own vectors were masked in the surface's pass.
    if (masked && (MIXED == 0 || (hit.mark & kOwnVectors) == 0u)) brickMask[at] = 1u;
#else
#if SEVERAL_SURFACES
    masked = masked || hit.mark >= kNoStreaks;
    imageStore(colorsImage, texel, uvec4(hit.mark % kMostKinds));
#endif
    float light = lightOn(normal, facing);
    imageStore(surfaceImage, texel, vec4(invDepth, depthGradient(hit), masked ? -light : light));
    imageStore(flowImage, texel, uvec4(flow));
    if (WITH_SCALAR != 0) imageStore(scalarImage, texel, vec4(scalar));
#endif
}
