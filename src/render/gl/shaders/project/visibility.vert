// Projects a point. 1/depth is linear in the image, so it is the depth buffer's value: near / depth, larger is nearer.
#include "view.glsl"
#include "arithmetic.glsl"

layout(location = 0) in vec3 position;  // Local P-space.

invariant gl_Position;

void main()
{
    precise vec3 fromEye = position - view.eyeAndFocal.xyz;
    float depth = dot3(fromEye, view.forwardAndNear.xyz);
    precise float x = fma(dot3(fromEye, view.rightAndCenterX.xyz), view.clipScale.x, depth * view.clipScale.z);
    precise float y = fma(dot3(fromEye, view.upAndCenterY.xyz), view.clipScale.y, depth * view.clipScale.w);
    gl_Position = vec4(x, y, view.forwardAndNear.w, depth);
}
