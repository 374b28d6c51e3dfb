// Trilinear look-ups of a grid, in fp32 and in global grid coordinates: the same values whatever brick is held.
struct FieldLookup {
    vec4 scale, offset;   // Grid coordinate = local * scale + offset.
    vec4 top;             // dims - 1
    vec4 cellLo, cellHi;  // Cells held here, half-open.
    ivec4 firstSample;    // The texture's first.
};
layout(std140, binding = 1) uniform FieldBlock { FieldLookup vectorLookup, scalarLookup; };

struct Cell {
    ivec3 at;  // In the texture.
    vec3 weight;
    bool inside;
};

Cell findCell(FieldLookup f, vec3 local)
{
    const float slack = 1e-3;  // A surface that ends exactly where the field ends must not lose its rim to rounding.
    precise vec3 grid = vec3(fma(local.x, f.scale.x, f.offset.x), fma(local.y, f.scale.y, f.offset.y), fma(local.z, f.scale.z, f.offset.z));
    vec3 top = f.top.xyz;
    Cell cell;
    cell.inside = all(greaterThanEqual(grid, vec3(-slack))) && all(lessThanEqual(grid, top + slack));
    vec3 within = cell.inside ? clamp(grid, vec3(0.0), top) : vec3(0.0);
    vec3 lower = min(floor(within), top - 1.0);
    precise vec3 weight = within - lower;
    cell.weight = weight;
    cell.inside = cell.inside && all(greaterThanEqual(lower, f.cellLo.xyz)) && all(lessThan(lower, f.cellHi.xyz));
    cell.at = ivec3(cell.inside ? lower : f.cellLo.xyz) - f.firstSample.xyz;
    return cell;
}

// NaN where masked; unspecified outside `inside`.
vec3 sampleField(sampler3D samples, Cell cell)
{
    vec3 row[4];
    for (int k = 0; k < 4; ++k) {
        ivec3 at = cell.at + ivec3(0, k & 1, k >> 1);
        row[k] = lerp3(texelFetch(samples, at, 0).xyz, texelFetch(samples, at + ivec3(1, 0, 0), 0).xyz, cell.weight.x);
    }
    return lerp3(lerp3(row[0], row[1], cell.weight.y), lerp3(row[2], row[3], cell.weight.y), cell.weight.z);
}
