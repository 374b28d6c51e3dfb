// The colour of a surface (render/shading_model.h).
layout(std140, binding = 4) uniform PaletteBlock {
    uvec4 base[65], dark[65], bright[65];  // Palette's entries; bytes R, G, B from the lowest, then the knee in `base`.
    vec4 edges[64];
    vec4 plain;  // Grays: without a streak, the darkest, the brightest.
    float scalarLo, lowest, highest, entriesPerScalar, lastEntry, contrast;
    uint background;
    bool useScalar, searched, lighting, hasLic, occlusion;
} palette;

// Turns LIC of unit variance into -1 to 1 with an even histogram: erf.
float tone(float z)
{
    float x = abs(z);
    float poly = fma(x, fma(x, fma(x, fma(x, kErf3, kErf2), kErf1), kErf0), 1.0);
    float squared = poly * poly, value = 1.0 - 1.0 / (squared * squared);
    return z < 0.0 ? -value : value;
}

uint paletteEntry(float scalar)
{
    if (isnan(scalar)) return kMaskedEntry;
    if (scalar < palette.lowest) return kBelowEntry;
    if (scalar > palette.highest) return kAboveEntry;
    if (!palette.searched)
        return uint(clamp((scalar - palette.scalarLo) * palette.entriesPerScalar, 0.0, palette.lastEntry));
    uint entry = 0u;
    for (uint step = 128u; step > 0u; step /= 2u) {
        uint next = entry + step;
        if (scalar >= palette.edges[next >> 2][next & 3u]) entry = next;
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

// RGBA bytes, opaque. `lic`: unit variance. `signedLight`: negative where no streaks show.
uint surfaceColor(float lic, float signedLight, float scalar)
{
    bool masked = signedLight < 0.0;
    float light = palette.lighting ? abs(signedLight) : 1.0;
    float m = tone(lic * (palette.contrast * 0.70710678));
    uint color = 0xFF000000u;
    if (palette.useScalar) {
        uint entry = paletteEntry(scalar), at = entry >> 2, k = entry & 3u;
        uint base = palette.base[at][k];
        float knee = fma(byteOf(base, 3), 1.0 / float(kKneeZero), -1.0);
        bool brightens = m >= knee;
        uint end = brightens ? palette.bright[at][k] : palette.dark[at][k];
        float part = masked ? 0.0 : abs(m - knee) / (brightens ? 1.0 - knee : 1.0 + knee);
        for (int c = 0; c < 3; ++c) color |= channel(byteOf(base, c), byteOf(end, c), part, light) << uint(8 * c);
    } else {
        float end = 255.0 * (m >= 0.0 ? palette.plain.z : palette.plain.y);
        color |= channel(255.0 * palette.plain.x, end, masked ? 0.0 : abs(m), light) * 0x010101u;
    }
    return color;
}
