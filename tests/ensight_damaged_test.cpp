#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/load/file_info.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"
#include "part_formats_testing.h"
#include "reader/ensight/testing/sample_ensight.h"

namespace aeolic {
namespace {

using namespace test;
using namespace testkit;

constexpr EnSightFormat binary{EnSightEncoding::binary, false}, fortran{EnSightEncoding::fortran, true};

class EnSightDamaged : public testing::Test {
protected:
    void SetUp() override { write({}); }

    void write(const SampleEnSight& sample) const { writeSampleEnSight(folder_.path().string(), sample); }

    /// Loads the walls with all they have, and the field. What is refused is one line; empty where nothing is.
    std::string complaint(const std::string& surface = ":walls") const
    {
        SceneDescription description;
        description.surface.spec = case_ + surface;
        description.field.vectors = "U";
        description.shading.colorBy = "p";
        return complaintOf([&] {
            loadScene(description);
            description.field.spec = case_;
            loadScene(description);
        });
    }

    void expectComplaint(const std::vector<std::string>& parts, const std::string& surface = ":walls") const
    {
        expectSays(complaint(surface), parts);
    }

    std::string replaced(const std::string& file, const std::string& was, const std::string& with) const
    {
        std::string text = readBytes(folder_.file(file));
        const std::size_t at = text.find(was);
        EXPECT_NE(at, std::string::npos) << was;
        return at == std::string::npos ? text : text.replace(at, was.size(), with);
    }

    void replace(const std::string& file, const std::string& was, const std::string& with) const
    {
        writeBytes(folder_.file(file), replaced(file, was, with));
    }

    void expectChange(const std::string& file, const std::string& was, const std::string& with,
                      const std::vector<std::string>& parts) const
    {
        const std::string sound = readBytes(folder_.file(file));
        replace(file, was, with);
        expectComplaint(parts);
        writeBytes(folder_.file(file), sound);
        EXPECT_EQ(complaint(), "");
    }

    TempFolder folder_;
    std::string case_ = folder_.file("box.case");
};

TEST_F(EnSightDamaged, CaseFiles)
{
    expectChange("box.case", "box.geo", "box.gee", {"box.case", "box.gee", "not there"});
    expectChange("box.case", "U.****", "V.****", {"box.case", "V.0000", "not there"});
    expectChange("box.case", "steps: 2", "steps: 3", {"box.case", "2 time values", "3"});
    expectChange("box.case", "steps: 2", "steps: 99999999999", {"box.case", "line 15", "no whole number"});
    expectChange("box.case", "steps: 2", "steps: 999999999", {"box.case", "2 time values", "999999999"});
    expectChange("box.case", "values: 0\n1.5", "values: 1.5\n0", {"box.case", "0 after 1.5", "increase"});
    expectChange("box.case", "values: 0\n1.5", "values: 0\nnan", {"box.case", "'nan'", "finite"});
    expectChange("box.case", "number: 0\nfilename increment: 1", "number: -1\nfilename increment: 1",
                 {"box.case", "'-1'", "from 0"});
    expectChange("box.case", "ensight gold", "ensight 5", {"box.case", "ensight gold"});
    expectChange("box.case", "model: box.geo", "model: \"", {"box.case", "names no file"});
    expectChange("box.case", "model: box.geo", "", {"box.case", "no geometry"});
    expectChange("box.case", "1 U U.****", "7 U U.****", {"box.case", "time set 7"});
    expectChange("box.case", "1 U U.****", "1 q q.****", {"box.case", "'q' once more"});
    expectChange("box.case", "FORMAT", std::string("\0\1", 2), {"box.case", "not text"});
    expectChange("box.case", "time set: 1", "\"", {"box.case", "no time set"});
    std::filesystem::remove(folder_.file("p.0001"));
    expectComplaint({"box.case", "p.0001", "not there"});
}

TEST_F(EnSightDamaged, Geometries)
{
    expectChange("box.geo", "node id off", "BEGIN TIME STEP", {"box.geo", "BEGIN TIME STEP", "node id"});
    expectChange("box.geo", "hexa8", "hexa9", {"box.geo", "part 1", "'hexa9'"});
    expectChange("box.geo", "quad4", "nsided", {"box.geo", "a polygon has 1 corners"});
    expectChange("box.geo", "       125", "1999999999", {"box.geo"});
    expectChange("box.geo", "       125", "        -1", {"box.geo", "number of points is -1"});
    expectChange("box.geo", "        64", "2147483647", {"box.geo"});
    expectChange("box.geo", "hexa8\n        64\n         1", "hexa8\n        64\n       126",
                 {"box.geo", "part 1 has the corner 126", "1 to 125"});
    expectChange("box.geo", "hexa8\n        64\n         1", "hexa8\n        64\n         0", {"the corner 0"});
    expectChange("box.geo", "4.000000000e+00", "4.000000000e+33", {"box.geo", "a coordinate is 4e+33", "1e30"});
    expectChange("box.geo", "4.000000000e+00", "nan            ", {"box.geo", "a coordinate is nan"});
    expectChange("box.geo", "4.000000000e+00", "four", {"box.geo", "'four'", "a number"});
    expectChange("box.geo", "part\n         2", "part\n         1", {"box.geo", "part 1 comes once more"});
    expectChange("box.geo", "coordinates", "block iblanked", {"box.geo", "part 1", "blanked"});
    expectComplaint({"box.case", "no part 'wals'", "fluid, walls", "walls?"}, ":wals");
    writeBytes(folder_.file("box.geo"), "");
    expectComplaint({"box.geo", "empty"});
}

TEST_F(EnSightDamaged, Polygons)
{
    write({.mixed = true});
    const auto expectSizes = [&](const std::string& with, const std::vector<std::string>& parts) {
        expectChange("box.geo", "nsided\n         2\n         3\n         4", "nsided\n         2\n" + with, parts);
    };
    expectSizes("         3\n2000000000", {"box.geo", "corners of elements"});
    expectSizes("         3\n        -4", {"box.geo", "a polygon has -4"});
    expectSizes("         3\n         1", {"box.geo", "a polygon has 1"});
    expectChange("box.geo", "nfaced\n         1\n         5", "nfaced\n         1\n2000000000",
                 {"box.geo", "sizes of faces"});
    expectChange("box.geo", "nfaced\n         1\n         5\n         3", "nfaced\n         1\n         5\n2000000000",
                 {"box.geo", "corners of elements"});
}

TEST_F(EnSightDamaged, Blocks)
{
    write({.blocks = true});
    expectChange("box.geo", "         3\n         1\n         4", "         3\n         1\n2000000000",
                 {"box.geo", "a block has 3 x 1 x 2000000000 points"});
    expectChange("box.geo", "block uniform\n         3\n         3\n         3",
                 "block uniform\n      1000\n      1000\n      1000",
                 {"box.geo", "1000 x 1000 x 1000 points", "memory"});
    expectChange("box.geo", "block uniform\n         3", "block uniform\n        -3", {"box.geo", "0 x 3 x 3"});
}

TEST_F(EnSightDamaged, Values)
{
    expectChange("U.0000", "part\n         2", "part\n         9", {"U.0000", "part 9 is not in the geometry"});
    expectChange("U.0000", "part\n         2", "part\n         1", {"U.0000", "part 1 comes once more"});
    expectChange("U.0000", "coordinates", "block", {"U.0000", "'block'", "coordinates"});
    expectChange("U.0000", "a variable", "BEGIN TIME STEP", {"U.0000", "several steps"});
    expectChange("p.0000", "quad4", "tria3", {"p.0000", "part 2 has no 'tria3'"});
    expectChange("p.0000", "quad4", "quad4 some", {"p.0000", "'some'"});
    expectChange("p.0000", "quad4", "quad4 partial\n2000000000", {"p.0000", "places of values"});
    expectChange("p.0000", "quad4", "quad4 partial\n1\n17\n", {"p.0000", "17", "1 to 16"});
    std::filesystem::resize_file(folder_.file("U.0001"), 200);
    SceneDescription later;
    later.surface.spec = case_;
    later.field.vectors = "U";
    later.time.moment = 1.5;
    try {
        loadScene(later);
        ADD_FAILURE() << "not refused";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("U.0001"), std::string::npos) << error.what();
    }
}

TEST_F(EnSightDamaged, ByteOrderOfAVariableIsAnother)
{
    for (const EnSightEncoding encoding : {EnSightEncoding::binary, EnSightEncoding::fortran}) {
        write({.format = {encoding, true}});
        const std::string values = readBytes(folder_.file("U.0000"));
        write({.format = {encoding, false}});
        EXPECT_EQ(complaint(), "");
        writeBytes(folder_.file("U.0000"), values);
        expectComplaint({"U.0000", encoding == EnSightEncoding::binary ? "byte order" : "record"});
    }
    writeBytes(folder_.file("U.0000"), "text\npart\n         1\n");
    expectComplaint({"U.0000"});
}

/// A file of binary numbers that ends within a part is refused wherever it ends.
TEST_F(EnSightDamaged, CutOffAnywhere)
{
    for (const EnSightFormat& format : {binary, fortran}) {
        write({.format = format, .ids = true, .extents = true});
        for (const char* name : {"box.geo", "U.0000", "p.0000"}) {
            const std::string sound = readBytes(folder_.file(name));
            const std::size_t begin = sound.find("part"), marker = format.encoding == fortran.encoding ? 4 : 0;
            for (std::size_t size = 0; size < sound.size(); size += 1 + size / 40) {
                // A whole number of parts, or a part without values, is a sound file.
                const bool values = std::string(name) != "box.geo";
                const std::size_t second = sound.find("part  ", begin + 1);
                const bool whole = values && (size + marker == begin || size + marker == second ||
                                              size == begin + 84 + 3 * marker || size == second + 84 + 3 * marker);
                writeBytes(folder_.file(name), sound.substr(0, size));
                EXPECT_TRUE(whole || !complaint().empty()) << name << ": " << size << " bytes of " << sound.size();
            }
            writeBytes(folder_.file(name), sound);
            EXPECT_EQ(complaint(), "");
        }
    }
}

TEST_F(EnSightDamaged, MutantsNeverCrash)
{
    std::mt19937 random(1);
    const char* words[] = {"-1",          "2147483647", "4294967296", "nan",     "1e38",  "part", "block uniform",
                           "coordinates", "nsided",     "nfaced",     "partial", "undef", "\n",   "\"",
                           "*",           "hexa8",      "g_hexa8",    "0"};
    int refused = 0;
    for (const EnSightFormat& format : {EnSightFormat{}, binary, fortran}) {
        write({format, true, true, true, true, true});
        for (int i = 0; i < 150; ++i) {
            const char* names[] = {"box.geo", "box.geo", "U.0000", "p.0000", "box.case"};
            const std::string name = folder_.file(names[random() % 5]), sound = readBytes(name);
            std::string mutant = sound;
            for (unsigned change = 0; change <= random() % 3; ++change) {
                const std::size_t at =
                    random() % (random() % 2 ? mutant.size() : std::min<std::size_t>(mutant.size(), 900));
                const std::string word = words[random() % std::size(words)];
                if (random() % 4 == 0)
                    mutant[at] = char(random());
                else if (random() % 3 == 0)
                    mutant.erase(at, 1 + random() % 40);
                else if (random() % 2 == 0)
                    mutant.replace(at, std::min(word.size(), mutant.size() - at), word);
                else
                    mutant.insert(at, word);
            }
            writeBytes(name, mutant);
            refused += !complaint(random() % 2 ? ":walls" : ":mixed,cube").empty();
            try {
                describeFile(case_);
            } catch (const InputError&) {
            }
            writeBytes(name, sound);
        }
    }
    EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace aeolic
