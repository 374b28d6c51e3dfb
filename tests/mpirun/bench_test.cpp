#include <nlohmann/json.hpp>

#include "mpirun_testing.h"

/// `aeolic-bench` under a launcher: its ranks are threads of one process, and the other processes have nothing to do.
namespace aeolic {
namespace {

using namespace testkit;

class MpirunBench : public MpirunTest {};

TEST_F(MpirunBench, OneRankMeasuresAndPrints)
{
    const Ended ended = mpirun("-n 2 " + bench() +
                               "scaling --surface teapot:500 --field abc:8,8,8 --size 64x48 --steps 8 --frames 1 "
                               "--repeats 1 --ranks 2 --balance static --parts nodes --json -");
    ASSERT_EQ(ended.exitCode, 0) << ended.err;
    const auto json = nlohmann::json::parse(ended.out);
    ASSERT_EQ(json["rows"].size(), 2u);
    EXPECT_EQ(json["rows"][1]["ranks"], 2);
}

TEST_F(MpirunBench, WrongOptionsAreToldOnce)
{
    const std::string expected = "aeolic-bench: --nonsense: unknown option";
    const Ended ended = mpirun("-n 2 " + bench() + "stages --nonsense");
    EXPECT_EQ(ended.exitCode, 2) << ended.err;
    const std::size_t first = ended.err.find(expected);
    ASSERT_NE(first, std::string::npos) << ended.err;
    EXPECT_EQ(ended.err.find(expected, first + 1), std::string::npos) << ended.err;
}

TEST_F(MpirunBench, TheFormerCommandSaysOnceWhereItWent)
{
    const Ended ended = mpirun("-n 2 " + aeolic() + "bench scaling");
    EXPECT_EQ(ended.exitCode, 2) << ended.err;
    EXPECT_EQ(ended.ours(), std::vector<std::string>{
                                "aeolic: bench is a program of its own now: aeolic-bench scaling | stages | codecs"});
}

}  // namespace
}  // namespace aeolic
