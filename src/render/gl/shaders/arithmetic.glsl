// The CPU's arithmetic: fused multiply-adds are spelled out, and `precise` results are neither reordered nor fused with
// others. So no compiler decides differently in two programs.

float dot3(vec3 a, vec3 b)
{
    precise float sum = fma(a.x, b.x, fma(a.y, b.y, a.z * b.z));
    return sum;
}

vec3 cross3(vec3 a, vec3 b)
{
    precise vec3 product = vec3(fma(a.y, b.z, -(a.z * b.y)), fma(a.z, b.x, -(a.x * b.z)), fma(a.x, b.y, -(a.y * b.x)));
    return product;
}

// base + t * step
vec3 along(vec3 base, vec3 step, float t)
{
    precise vec3 end = vec3(fma(step.x, t, base.x), fma(step.y, t, base.y), fma(step.z, t, base.z));
    return end;
}

float lerp(float a, float b, float t)
{
    precise float between = fma(t, b - a, a);
    return between;
}
vec3 lerp3(vec3 a, vec3 b, float t) { return vec3(lerp(a.x, b.x, t), lerp(a.y, b.y, t), lerp(a.z, b.z, t)); }

float inverseLength(float squared)
{
    precise float inverse = 1.0 / sqrt(squared);
    return inverse;
}

float notANumber() { return uintBitsToFloat(0x7fc00000u); }
