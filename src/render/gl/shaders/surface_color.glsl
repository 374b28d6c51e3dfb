// The colour of a surface (render/shading_model.h).
layout(std140, binding = 4) uniform PaletteBlock {
    vec4 plain;  // Grays: without a streak, the darkest, the brightest.
    float contrast;
    uint background;
    bool useScalar, several, lighting, hasLic, occlusion;
} palette;
struct ColorTable {
    uint base[kAllEntries], dark[kAllEntries], bright[kAllEntries];  // Bytes R, G, B from the lowest, then the knee in `base`.
    float edges[kColorEntries];
    float scalarLo, lowest, highest, entriesPerScalar, lastEntry;
    bool searched;
};
layout(std430, binding = 7) readonly buffer ColorTables { ColorTable tables[]; };  // The palette's; more of several surfaces.

// Turns LIC of unit variance into -1 to 1 with an even histogram: erf.
float tone(float z)
{
    float x = abs(z);
    float poly = fma(x, fma(x, fma(x, fma(x, kErf3, kErf2), kErf1), kErf0), 1.0);
    float squared = poly * poly, value = 1.0 - 1.0 / (squared * squared);
    return z < 0.0 ? -value : value;
}

uint tableEntry(uint table, float scalar)
{
    if (isnan(scalar)) return kMaskedEntry;
    if (scalar < tables[table].lowest) return kBelowEntry;
    if (scalar > tables[table].highest) return kAboveEntry;
    if (!tables[table].searched)
        return uint(clamp((scalar - tables[table].scalarLo) * tables[table].entriesPerScalar, 0.0, tables[table].lastEntry));
    uint entry = 0u;
    for (uint step = kColorEntries / 2u; step > 0u; step /= 2u) {
        uint next = entry + step;
        if (scalar >= tables[table].edges[next]) entry = next;
    }
    return entry;
}

float byteOf(uint word, int k) { return float(bitfieldExtract(word, 8 * k, 8)); }

// `end`: the colour of the brightest or the darkest streak; `part`: of the way there.
uint channel(float base, float end, float part, float light)
{
    float shown = fma(end - base, part, base);
    return uint(clamp(fma(shown, light, 0.5), 0.0, 255.0));
}

// RGBA bytes, opaque. `lic`: unit variance. `signedLight`: negative where no streaks show. `kind`: which table.
uint surfaceColor(float lic, float signedLight, float scalar, uint kind)
{
    bool masked = signedLight < 0.0;
    float light = palette.lighting ? abs(signedLight) : 1.0;
    float m = tone(lic * (palette.contrast * 0.70710678));
    uint color = 0xFF000000u;
    bool isPlain = palette.several ? kind == kPlainKind : !palette.useScalar;
    if (!isPlain) {
        uint entry = tableEntry(kind, scalar), base = tables[kind].base[entry];
        float knee = fma(byteOf(base, 3), 1.0 / float(kKneeZero), -1.0);
        bool brightens = m >= knee;
        uint end = brightens ? tables[kind].bright[entry] : tables[kind].dark[entry];
        float part = masked ? 0.0 : abs(m - knee) / (brightens ? 1.0 - knee : 1.0 + knee);
        for (int c = 0; c < 3; ++c) color |= channel(byteOf(base, c), byteOf(end, c), part, light) << uint(8 * c);
    } else {
        float end = 255.0 * (m >= 0.0 ? palette.plain.z : palette.plain.y);
        color |= channel(255.0 * palette.plain.x, end, masked ? 0.0 : abs(m), light) * 0x010101u;
    }
    return color;
}
