#include "render/cpu/simd/arithmetic.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cpu/simd/arithmetic.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/cpu/simd/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace aeolic::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

bool losesNothing()
{
    const DF d;
    const VF x = hn::Set(d, 1 + 0x1p-12f);  // Its square ends in 2^-24, which a float does not hold.
    const VF lost = hn::MulSub(x, x, hn::Mul(x, x));
    return hn::AllTrue(d, hn::Eq(lost, hn::Set(d, 0x1p-24f)));
}

}  // namespace aeolic::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace aeolic::cpu {

HWY_EXPORT(losesNothing);

bool fusesMultiplyAdds()
{
    return HWY_DYNAMIC_DISPATCH(losesNothing)();
}

}  // namespace aeolic::cpu
#endif
