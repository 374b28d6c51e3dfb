#include <filesystem>
#include <random>

#include "openfoam_testing.h"
#include "reader/openfoam/testing/sample_case.h"

/// Cases of OpenFOAM that somebody or something has damaged.
namespace aeolic {
namespace {

using namespace openfoam_testing;
namespace fs = std::filesystem;

void replaceIn(const std::string& path, const std::string& from, const std::string& to)
{
    std::string text = readBytes(path);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from << " is not in " << path;
    writeBytes(path, text.replace(at, from.size(), to));
}

/// What somebody does to a sound case of two processors, and what the message must name.
struct Fault {
    const char* name;
    void (*spoil)(const std::string& folder);
    std::vector<std::string> parts;
    SampleCase sample = {.processors = 2};
};

void moveLastCorner(const std::string& path, const std::string& point)
{
    std::string text = readBytes(path);
    const std::size_t begin = text.rfind("4(") + 2, end = text.find(' ', begin);
    writeBytes(path, text.replace(begin, end - begin, point));
}

std::string mesh(const std::string& folder, const char* file)
{
    return folder + "/constant/polyMesh/" + file;
}

TEST(OpenFoam, BadCasesAreRefusedInOneLine)
{
    const SampleCase one{}, binary{.binary = true}, gzip{.gzip = true};
    const Fault faults[] = {
        {"a processor is missing",
         [](const std::string& f) { fs::remove_all(f + "/processor0"); },
         {"processor1", "no processor0"}},
        {"the last processor is missing",
         [](const std::string& f) { fs::remove_all(f + "/processor1"); },
         {"no processor1", "procBoundary0to1"}},
        {"times differ",
         [](const std::string& f) { fs::remove_all(f + "/processor1/1"); },
         {"processor0 has time 1, processor1 has not"}},
        {"a field is missing",
         [](const std::string& f) { fs::remove(f + "/1/wallShearStress"); },
         {"wallShearStress", "U"},
         one},
        {"a processor's field is missing",
         [](const std::string& f) { fs::remove(f + "/processor1/1/wallShearStress"); },
         {"processor1/1/wallShearStress"}},
        {"gzip is cut off",
         [](const std::string& f) {
             const std::string path = mesh(f, "points.gz"), bytes = readBytes(path);
             writeBytes(path, bytes.substr(0, bytes.size() / 2));
         },
         {"points.gz", "gzip file is cut off"},
         gzip},
        {"no header",
         [](const std::string& f) { writeBytes(mesh(f, "points"), "4 ((0 0 0))"); },
         {"points", "FoamFile"},
         one},
        {"longer labels than it says",
         [](const std::string& f) { replaceIn(mesh(f, "owner"), "label=32", "label=64"); },
         {"owner"},
         binary},
        {"a corner beyond the points",
         [](const std::string& f) { moveLastCorner(mesh(f, "faces"), "77777"); },
         {"points", "77777"},
         one},
        {"a negative corner",
         [](const std::string& f) { moveLastCorner(mesh(f, "faces"), "-1"); },
         {"faces", "-1"},
         one},
        {"a negative count",
         [](const std::string& f) { replaceIn(mesh(f, "boundary"), "nFaces 12", "nFaces -12"); },
         {"boundary", "nFaces", "-12"},
         one},
        {"more faces than there are",
         [](const std::string& f) { replaceIn(mesh(f, "boundary"), "nFaces 64", "nFaces 999"); },
         {"faces", "999"},
         one},
        {"an absurd count",
         [](const std::string& f) { replaceIn(mesh(f, "points"), "180\n(", "99999999999999\n("); },
         {"points"},
         one},
        {"an absurd count of binary values",
         [](const std::string& f) { replaceIn(mesh(f, "points"), "180\n(", "99999999999999\n("); },
         {"points", "cut off"},
         binary},
        {"too few values",
         [](const std::string& f) {
             replaceIn(f + "/1/wallShearStress", "value nonuniform List<vector> 24\n(",
                       "value nonuniform List<vector> 24\n((0 0 0)\n");
         },
         {"wallShearStress", "24"},
         one},
        {"no entry for a patch",
         [](const std::string& f) { replaceIn(f + "/1/wallShearStress", "floor", "flour"); },
         {"wallShearStress", "no entry for patch 'floor'"},
         one},
        {"no mesh", [](const std::string& f) { fs::remove_all(f + "/constant"); }, {"polyMesh/boundary"}, one},
        {"an empty folder",
         [](const std::string& f) {
             fs::remove_all(f);
             fs::create_directory(f);
         },
         {"polyMesh/boundary"},
         one},
    };
    for (const Fault& fault : faults) {
        SCOPED_TRACE(fault.name);
        const TempFolder folder;
        SampleCase sample = fault.sample;
        sample.times = {"1"};
        writeSampleCase(folder.file("case"), sample);
        const bool onlyCells = std::string(fault.name) == "longer labels than it says";
        const SceneDescription description = describe(folder.file("case:*"), onlyCells ? "U" : "wallShearStress");
        ASSERT_EQ(messageOf(description), "(nothing was refused)");
        fault.spoil(folder.file("case"));
        expectParts(messageOf(description), fault.parts);
        EXPECT_NE(messageOf(description).find("expected"), std::string::npos);
    }
}

TEST(OpenFoam, AnEmptyPatchIsRefused)
{
    const TempFolder folder;
    writeSampleCase(folder.file("case"));
    replaceIn(folder.file("case/constant/polyMesh/boundary"), "nFaces 12", "nFaces 0");
    expectParts(messageOf(describe(folder.file("case:inlet"))), {"inlet", "no faces"});
}

TEST(OpenFoam, APatchIsReadWithoutTheVolume)
{
    const TempFolder folder;
    writeSampleCase(folder.file("case"), {.times = {"1"}});
    fs::remove(folder.path() / "case/constant/polyMesh/neighbour");
    fs::remove(folder.path() / "case/constant/polyMesh/owner");
    fs::remove(folder.path() / "case/1/p");
    EXPECT_EQ(messageOf(describe(folder.file("case:floor"))), "(nothing was refused)");
}

TEST(OpenFoam, EveryPlaceWhereAFileMayEndIsSafe)
{
    const TempFolder folder;
    writeSampleCase(folder.file("case"), {.binary = true, .times = {"1"}});
    for (const char* file :
         {"constant/polyMesh/faces", "constant/polyMesh/points", "constant/polyMesh/boundary", "1/wallShearStress"}) {
        const std::string path = folder.file("case/" + std::string(file)), bytes = readBytes(path);
        for (std::size_t end = 0; end + 4 < bytes.size(); end += 1 + bytes.size() / 40) {
            writeBytes(path, bytes.substr(0, end));
            EXPECT_NE(messageOf(describe(folder.file("case:floor"))), "(nothing was refused)") << file << " " << end;
        }
        writeBytes(path, bytes);
    }
}

/// Whatever a few wrong bytes do, it ends in a surface or in one line.
TEST(OpenFoam, DamageAtRandomIsSafe)
{
    const TempFolder folder;
    std::mt19937 random(7);
    for (const bool binary : {false, true}) {
        writeSampleCase(folder.file("case"), {.binary = binary, .processors = 2, .times = {"1"}});
        for (const char* file : {"constant/polyMesh/faces", "constant/polyMesh/points", "constant/polyMesh/boundary",
                                 "constant/polyMesh/faceProcAddressing", "constant/polyMesh/owner", "1/U"}) {
            const std::string path = folder.file("case/processor1/" + std::string(file)), bytes = readBytes(path);
            int refused = 0;
            for (int i = 0; i < 60; ++i) {
                std::string damaged = bytes;
                for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = char(random());
                writeBytes(path, damaged);
                const std::string message = messageOf(describe(folder.file("case:*"), "U"));
                EXPECT_EQ(message.find('\n'), std::string::npos) << message;
                refused += message != "(nothing was refused)";
            }
            EXPECT_GT(refused, 0) << file;
            writeBytes(path, bytes);
        }
    }
}

}  // namespace
}  // namespace aeolic
