// The CPU's arithmetic: fused multiply-adds are spelled out, so that no compiler decides differently in two programs.

float dot3(vec3 a, vec3 b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }

vec3 cross3(vec3 a, vec3 b)
{
    return vec3(fma(a.y, b.z, -(a.z * b.y)), fma(a.z, b.x, -(a.x * b.z)), fma(a.x, b.y, -(a.y * b.x)));
}

// base + t * step
vec3 along(vec3 base, vec3 step, float t) { return vec3(fma(step.x, t, base.x), fma(step.y, t, base.y), fma(step.z, t, base.z)); }

float lerp(float a, float b, float t) { return fma(t, b - a, a); }
vec3 lerp3(vec3 a, vec3 b, float t) { return vec3(lerp(a.x, b.x, t), lerp(a.y, b.y, t), lerp(a.z, b.z, t)); }

float inverseLength(float squared) { return 1.0 / sqrt(squared); }

float notANumber() { return uintBitsToFloat(0x7fc00000u); }
