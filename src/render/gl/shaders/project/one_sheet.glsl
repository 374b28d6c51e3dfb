// Whether two places of the image show one sheet of the surface (cpu/project/one_sheet-inl.h).
struct Prediction {
    float errorA, errorB;  // Of the facet at a, and of that at b.
    float slack;
};

// `a`, `b`: 1/depth there and its change per pixel to the right and downwards. `way`: from a to b, in pixels.
Prediction predict(vec3 a, vec3 b, vec2 way, float perDepth)
{
    precise float ga = fma(a.y, way.x, a.z * way.y), gb = fma(b.y, way.x, b.z * way.y);
    precise float change = b.x - a.x, errorA = change - ga, errorB = gb - change;
    precise float slack = fma(a.x + b.x, perDepth, max(abs(ga), abs(gb)) * kSlackSlope);
    return Prediction(errorA, errorB, slack);
}

bool onOneSheet(Prediction p)
{
    return min(abs(p.errorA), abs(p.errorB)) <= p.slack || p.errorA * p.errorB >= 0.0;
}
