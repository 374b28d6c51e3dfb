#include "render/cpu/simd/arithmetic.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <map>
#include <string>

#include "render/backend.h"
#include "render_testing.h"
#include "same_bytes_testing.h"

namespace aeolic::cpu {
namespace {

using namespace testkit;

/// A node without AVX2 among others that have it would show as its stripe: ranks that draw together are of one kind.
TEST(Arithmetic, SimdTargetsOfOneKindDrawTheSameBytes)
{
    const Case cases[] = {makeCase("hierarchical", 160, 131, licOf(LicMethod::hierarchical, 40)),
                          makeCase("hann", 120, 97, licOf(LicMethod::hierarchical, 77, Kernel::hann)),
                          makeCase("direct", 120, 101, licOf(LicMethod::direct, 30), "torus:3000", "tornado:24,24,24")};
    for (const Case& c : cases) {
        SCOPED_TRACE(c.name);
        std::map<std::string, std::vector<Picture>> ofKind;
        int targets = 0;
        forEachSimdTarget([&] {
            const std::vector<Picture> pictures = draw("cpu", c, {}, 1, 2);
            const std::string kind = makeBackend(BackendChoice::cpu, Scene())->kind();
            EXPECT_EQ(kind == "cpu", fusesMultiplyAdds()) << kind;
            const auto known = ofKind.emplace(kind, pictures);
            for (std::size_t i = 0; i < pictures.size(); ++i)
                EXPECT_EQ(known.first->second[i].pixels, pictures[i].pixels);
            ++targets;
        });
        EXPECT_LE(int(ofKind.size()), 2);
        EXPECT_GE(targets, 1);
    }
}

}  // namespace
}  // namespace aeolic::cpu
