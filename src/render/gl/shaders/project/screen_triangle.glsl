// Triangles on the image, in sub-pixels, as the processor has them (cpu/project/raster). Needs view.glsl and
// arithmetic.glsl. Edge functions of whole numbers are exact: no sample falls between two neighbours.
layout(std430, binding = 0) readonly buffer Triangles { uint triangles[]; };
layout(std430, binding = 1) readonly buffer Vertices { vec4 vertices[]; };  // Three each: VertexRecord.
layout(location = 3) uniform bool frontFacesOnly;

const int kSubpixels = 256;
const float kGuardBandPx = 2097152.0;  // Farther off the image coordinates are no longer exact.
const int kSampleMargin = kReach * (kSubpixels / kParts);

struct Corner {
    ivec2 at;
    float invDepth;
};

struct ScreenTriangle {
    Corner a, b, c;  // Clockwise on the image.
    float lowest, highest, bias;
    float doubleArea;
    ivec2 low, high;  // Pixels that it may cover a sample of, half-open.
};

// In the viewer's axes: right, up, depth.
vec3 eyePosition(uint vertex)
{
    precise vec3 fromEye = vertices[3u * vertex].xyz - view.eyeAndFocal.xyz;
    return vec3(dot3(fromEye, view.rightAndCenterX.xyz), dot3(fromEye, view.upAndCenterY.xyz),
                dot3(fromEye, view.forwardAndNear.xyz));
}

// On the image, in pixels. The depth is positive.
vec2 onImage(vec3 eye)
{
    precise float scale = view.eyeAndFocal.w * (1.0 / eye.z);
    precise vec2 place = vec2(fma(eye.x, scale, view.rightAndCenterX.w), fma(-eye.y, scale, view.upAndCenterY.w));
    return place;
}

bool isSafe(vec3 eye)
{
    return eye.z >= view.forwardAndNear.w && all(lessThan(abs(onImage(eye)), vec2(kGuardBandPx)));
}

Corner cornerAt(vec3 eye) { return Corner(ivec2(roundEven(onImage(eye) * float(kSubpixels))), 1.0 / eye.z); }

// Twice the area of (p, q, r), which is 0 or more; else its sign is lost, and `isLess` says so. Exact but for the last
// rounding.
float wideCross(ivec2 p, ivec2 q, ivec2 r, out bool isLess)
{
    ivec2 u = q - p, v = r - p;
    int high0, high1, low0, low1;
    imulExtended(u.x, v.y, high0, low0);
    imulExtended(u.y, v.x, high1, low1);
    isLess = high0 < high1 || (high0 == high1 && uint(low0) < uint(low1));
    if (isLess) {
        int swapped = high0;
        high0 = high1, high1 = swapped;
        swapped = low0;
        low0 = low1, low1 = swapped;
    }
    uint borrow, low = usubBorrow(uint(low0), uint(low1), borrow);
    return fma(float(uint(high0 - high1) - borrow), 4294967296.0, float(low));
}

float narrowCross(ivec2 p, ivec2 q, ivec2 r, out bool isLess)
{
    ivec2 u = q - p, v = r - p;
    int area = u.x * v.y - u.y * v.x;
    isLess = area < 0;
    return float(abs(area));
}

// By how much a face that is turned to the viewer counts as nearer: frontBias() in cpu/project/raster/raster.h.
float frontBias(ScreenTriangle t)
{
    precise vec2 ab = vec2(t.b.at - t.a.at), ac = vec2(t.c.at - t.a.at);
    precise float zb = t.b.invDepth - t.a.invDepth, zc = t.c.invDepth - t.a.invDepth;
    precise float perSubpixel = (abs(fma(zb, ac.y, -(zc * ab.y))) + abs(fma(zc, ab.x, -(zb * ac.x)))) / t.doubleArea;
    precise float bias = fma(t.highest, kFrontRounding, min(min(perSubpixel, t.highest - t.lowest), kMostFrontBias * t.highest));
    return bias;
}

// False where nothing of it shows.
bool setUp(Corner a, Corner b, Corner c, out ScreenTriangle t)
{
    bool isFront;
    t.doubleArea = wideCross(a.at, b.at, c.at, isFront);  // Rows count downwards.
    t.a = a;
    t.b = b;
    t.c = c;
    if (isFront) {
        t.b = c;
        t.c = b;
    }
    t.lowest = min(min(a.invDepth, b.invDepth), c.invDepth);
    t.highest = max(max(a.invDepth, b.invDepth), c.invDepth);
    if (t.doubleArea == 0.0 || (frontFacesOnly && !isFront)) return false;
    t.bias = isFront ? frontBias(t) : 0.0;
    // A pixel's centre lies at 256 n + 128.
    t.low = (min(min(a.at, b.at), c.at) - kSampleMargin + kSubpixels / 2 - 1) >> 8;
    t.high = ((max(max(a.at, b.at), c.at) + kSampleMargin - kSubpixels / 2) >> 8) + 1;
    return true;
}
