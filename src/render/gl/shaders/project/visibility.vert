// Projects a point. 1/depth is linear in the image, so it is the depth buffer's value: near / depth, larger is nearer.
#include "view.glsl"
#include "arithmetic.glsl"

layout(location = 0) in vec3 position;  // Local P-space.
layout(location = 0) uniform vec2 shift;  // NDC.

invariant gl_Position;

void main()
{
    vec3 fromEye = position - view.eyeAndFocal.xyz;
    float depth = dot3(fromEye, view.forwardAndNear.xyz);
    float x = fma(dot3(fromEye, view.rightAndCenterX.xyz), view.clipScale.x, depth * view.clipScale.z);
    float y = fma(dot3(fromEye, view.upAndCenterY.xyz), view.clipScale.y, depth * view.clipScale.w);
    gl_Position = vec4(x + shift.x * depth, y + shift.y * depth, view.forwardAndNear.w, depth);
}
