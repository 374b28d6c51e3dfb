#include "data/load/ask_once.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "cluster/composite/communicator_agreement.h"
#include "data/reading/file_questions.h"
#include "data/reading/known_answers.h"
#include "data/vtk/testing/sample_files.h"
#include "ranks/thread_communicator.h"

namespace aeolic {
namespace {

using test::TempFolder;

class AskOnce : public testing::Test {
protected:
    std::string writeList() const
    {
        std::string path = folder_.file("list.pvd");
        std::ofstream(path) << "<VTKFile type=\"Collection\"><Collection>"
                               "<DataSet timestep=\"2\" file=\"a.vtp\"/></Collection></VTKFile>";
        return path;
    }

    TempFolder folder_;
};

TEST_F(AskOnce, WhatIsKnownIsNotAskedAgain)
{
    const std::string list = writeList();
    {
        const KnownAnswers known;
        EXPECT_EQ(listedFiles(list).size(), 1u);
        std::filesystem::remove(list);
        EXPECT_EQ(listedFiles(list).size(), 1u);
        EXPECT_THROW(surfaceCountsOf(folder_.file("a.vtp")), InputError);  // Another question.
        {
            const KnownAnswers inner;
            EXPECT_THROW(listedFiles(list), InputError);
        }
        EXPECT_EQ(listedFiles(list).size(), 1u);
    }
    EXPECT_THROW(listedFiles(list), InputError);
}

TEST_F(AskOnce, AMessageThatIsCutOffIsRefused)
{
    KnownAnswers known, other;
    const Bytes request(3, std::byte{1});
    known.keep(request, Bytes(5, std::byte{2}));
    const Bytes message = known.message();
    for (std::size_t length = 0; length < message.size(); ++length) {
        ByteReader reader({message.data(), length});
        EXPECT_THROW(other.take(reader), std::runtime_error) << length;
    }
    ByteReader reader(message);
    other.take(reader);
    EXPECT_TRUE(other.find(request));
    EXPECT_FALSE(other.find(Bytes(2, std::byte{1})));
}

TEST_F(AskOnce, OneRankOfAHostAsksForAll)
{
    const std::string list = writeList();
    std::vector<std::size_t> listed(4, 0);
    runRanks(4, [&](Communicator& communicator) {
        CommunicatorAgreement agreement(communicator);
        askOncePerHost(agreement, [&] {
            listed[std::size_t(communicator.rank())] = listedFiles(list).size();
            std::filesystem::remove(list);  // So nobody can ask after the first.
        });
    });
    EXPECT_EQ(listed, std::vector<std::size_t>(4, 1));
}

TEST_F(AskOnce, ARefusalReachesAllRanks)
{
    const std::string missing = folder_.file("missing.pvd");
    std::vector<std::string> said(3);
    runRanks(3, [&](Communicator& communicator) {
        CommunicatorAgreement agreement(communicator);
        try {
            askOncePerHost(agreement, [&] { listedFiles(missing); });
        } catch (const InputError& error) {
            said[std::size_t(communicator.rank())] = error.what();
        }
    });
    for (const std::string& each : said) EXPECT_TRUE(each.starts_with(missing)) << each;
}

}  // namespace
}  // namespace aeolic
