// Counts the covered pixels of each row, a row a workgroup.
layout(local_size_x = 256) in;
layout(binding = 0) uniform usampler2D visible;
layout(std430, binding = 0) writeonly buffer RowCounts { uint covered[]; };
layout(location = 0) uniform ivec3 rows;  // First row, how many, columns.

shared uint total;

void main()
{
    if (gl_LocalInvocationIndex == 0u) total = 0u;
    barrier();
    int row = int(gl_WorkGroupID.x);
    uint count = 0u;
    for (int x = int(gl_LocalInvocationIndex); x < rows.z; x += 256)
        count += uint(texelFetch(visible, ivec2(x, rows.x + row), 0).r != 0u);
    if (count > 0u) atomicAdd(total, count);
    barrier();
    if (gl_LocalInvocationIndex == 0u) covered[row] = total;
}
