#pragma once

namespace aeolic::cpu {

/// Whether the SIMD target in use rounds a multiply-add once. All do but SSE4, on processors without AVX2: pictures of
/// those that do are the same bytes, of the others in a few pixels a level or two away.
bool fusesMultiplyAdds();

}  // namespace aeolic::cpu
