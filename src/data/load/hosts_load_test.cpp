#include <gtest/gtest.h>

#include <mutex>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "load_testing.h"
#include "pieces_testing.h"

/// Ranks of several hosts, each of which may have files of its own.
namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

/// Every rank is a host by itself.
class OneHostEach : public CommunicatorAgreement {
public:
    using CommunicatorAgreement::CommunicatorAgreement;
    bool isFirstOnHost() const override { return true; }
    std::shared_ptr<const void> shareOnHost(std::shared_ptr<const void> mine, std::size_t) override { return mine; }
};

class HostsLoad : public testing::Test {
protected:
    /// What all ranks say when rank i samples fields[i]; empty: it was loaded.
    static std::vector<std::string> said(const std::vector<std::string>& fields)
    {
        std::mutex mutex;
        std::vector<std::string> errors;
        runRanks(int(fields.size()), [&](Communicator& communicator) {
            OneHostEach agreement(communicator);
            SceneDescription description;
            description.surface.spec = "sphere:40";
            description.field.spec = fields[std::size_t(communicator.rank())];
            std::string error;
            try {
                const LoadedScene loaded(description, {}, agreement);
            } catch (const InputError& wrong) {
                error = wrong.what();
            }
            const std::lock_guard lock(mutex);
            errors.push_back(error);
        });
        return errors;
    }

    std::string write(const std::string& name, const GridSample& sample = {}) const
    {
        writeGridFile(folder_.file(name), sample);
        return folder_.file(name);
    }

    TempFolder folder_;
};

TEST_F(HostsLoad, EachHostReadsTheFile)
{
    const std::string file = write("a.vti");
    EXPECT_EQ(said({file, file, file}), std::vector<std::string>(3));
}

TEST_F(HostsLoad, OtherValuesAreFoundOut)
{
    GridSample other;
    other.scale = 2;
    for (const std::string& error : said({write("a.vti"), write("a.vti"), write("b.vti", other)}))
        EXPECT_TRUE(error.starts_with("the scene's data: rank 2 has '")) << error;
}

TEST_F(HostsLoad, AnotherGridIsFoundOut)
{
    GridSample other;
    other.dims = {5, 4, 3};
    const std::string file = write("a.vti");
    for (const std::string& second : {write("b.vti", other), write("c.vtu")})
        for (const std::string& error : said({file, second}))
            EXPECT_EQ(error, "rank 1: " + file +
                                 ": it holds another grid than on the first host; expected the same "
                                 "file on every host");
}

}  // namespace
}  // namespace aeolic
