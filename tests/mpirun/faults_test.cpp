#include <chrono>
#include <cstdlib>
#include <fstream>

#include "mpirun_testing.h"
#include "pieces_testing.h"

/// One rank's fault ends the whole job, at once, with one line that says which and why, and with nothing half-written.
namespace aeolic {
namespace {

using namespace testkit;

class MpirunFault : public MpirunTest {
protected:
    /// The job fails, ends within 5 s of the fault, and leaves no process behind. A fault is made known by a complaint,
    /// or is one that the test makes. Starting a job and drawing is not counted: that may take long on a busy machine.
    void expectEnded(const Ended& ended) const
    {
        double seconds = ended.secondsSinceComplaint;
        if (seconds < 0 && std::filesystem::exists(path(kMark)))
            seconds = std::chrono::duration<double>(ended.end - std::filesystem::last_write_time(path(kMark))).count();
        std::filesystem::remove(path(kMark));
        EXPECT_NE(ended.exitCode, 0) << ended.err;
        EXPECT_LT(seconds < 0 ? ended.seconds : seconds, 5) << ended.err;
        EXPECT_EQ(strays(), std::vector<std::string>());
    }

    /// Like expectEnded(), and prints exactly this line of ours, and leaves no new file.
    void expectFault(const Ended& ended, const std::string& line) const
    {
        expectEnded(ended);
        EXPECT_EQ(ended.ours(), std::vector<std::string>{"aeolic: " + line}) << ended.err;
        EXPECT_EQ(files(), filesBefore_);
    }

    /// An animation too long to end by itself, in pictures that are quick to draw.
    std::string animation() const
    {
        return "render --surface teapot:2000 --field abc:8,8,8 --size 64x49 --steps 8 --frames 50000 -o '" +
               path("a.png") + "'";
    }

    /// For a rank that draws animation(): does so once `picture` is there.
    std::string onceDrawing(const std::string& action, const std::string& picture = "a-0003.png") const
    {
        return "(while [ ! -e \"" + path(picture) + "\" ]; do sleep 0.02; done; touch \"" + path(kMark) + "\"; " +
               action + ") >/dev/null 2>&1 &";
    }

    /// Every picture that is there is complete, and there is nothing but pictures.
    void expectWholePictures() const
    {
        for (const std::string& file : files()) {
            EXPECT_TRUE(file.ends_with(".png")) << file;
            EXPECT_TRUE(bytes(file).ends_with(std::string("IEND\xAE\x42\x60\x82"))) << file;
        }
    }

    void write(const std::string& file, const std::string& text)
    {
        std::ofstream(path(file)) << text;
        filesBefore_ = files();
    }

    const std::string scene_ = "render --surface teapot:2000 --field abc:8,8,8 --size 64x49 --steps 8 ";
    std::string output() const { return "-o '" + path("a.png") + "' "; }

private:
    std::vector<std::string> filesBefore_;
};

/// A triangle with a vector at each corner.
std::string triangle(double z)
{
    return "# vtk DataFile Version 3.0\nmade for a test\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 " +
           std::to_string(z) + "\nPOLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nVECTORS u float\n1 0 0 1 0 0 1 0 0\n";
}

TEST_F(MpirunFault, InputThatNoRankCanReadIsToldOnce)
{
    const Ended ended = render(3, "--surface '" + path("none.vtk") + "' " + output());
    expectFault(ended, path("none.vtk") + ": no such file; expected a file that can be read");
    EXPECT_EQ(ended.exitCode, 2);
}

TEST_F(MpirunFault, APieceThatOneRankCannotFindNamesTheRank)
{
    testkit::writeTorusPieces(path(""), "wing", {});
    write("note", "");  // So that the files are those that there were before.
    const Ended ended =
        mpirun("-n 3 " + inRank(1, "cd /") + aeolic() + "render --surface wing.pvtp --size 64x48 " + output());
    expectFault(ended, "rank 1: wing.pvtp: no such file; expected a file that can be read");
    EXPECT_EQ(ended.exitCode, 2);
}

/// One rank reads what is whole. What lies where another rank was started does not matter.
TEST_F(MpirunFault, AFileThatOnlyTheFirstRankFindsIsEnough)
{
    write("wing.vtk", triangle(0));
    const Ended alone = mpirun("-n 1 " + aeolic() + "render --surface wing.vtk --size 64x48 " + output());
    EXPECT_EQ(alone.exitCode, 0) << alone.err;
    const std::string picture = bytes("a.png");
    const Ended ended =
        mpirun("-n 3 " + inRank(1, "cd /") + aeolic() + "render --surface wing.vtk --size 64x48 " + output());
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_EQ(bytes("a.png"), picture);
}

TEST_F(MpirunFault, RanksWithDifferentOptionsDrawNothing)
{
    const std::string command = "-n 1 " + aeolic() + scene_ + output();
    expectFault(mpirun(command + ": " + command + "--steps 9"),
                "the scene: rank 1 has '\"steps\": 9'; expected '\"steps\": 8' as on rank 0");
}

TEST_F(MpirunFault, AWrongOptionOnOneRankAlone)
{
    const std::string command = "-n 1 " + aeolic() + scene_ + output();
    expectFault(mpirun(command + ": " + command + "--nonsense"),
                "rank 1: --nonsense: unknown option; expected one of those in 'aeolic render --help'");
}

TEST_F(MpirunFault, AnotherCommandOnOneRankAlone)
{
    const std::string command = "-n 1 " + aeolic();
    expectFault(mpirun(command + scene_ + output() + ": " + command + "--version"),
                "the command: rank 1 has 'help'; expected 'aeolic render' as on rank 0");
}

#ifndef __SANITIZE_ADDRESS__  // The sanitizer's shadow memory takes more than any limit leaves.

TEST_F(MpirunFault, APictureThatOneRankHasNoMemoryFor)
{
    const Ended ended =
        mpirun("-n 3 " + inRank(1, "ulimit -v 400000") + aeolic() + scene_ + "--size 4000x4000 " + output());
    expectEnded(ended);
    ASSERT_EQ(ended.ours().size(), 1u) << ended.err;
    EXPECT_TRUE(ended.ours()[0].starts_with("aeolic: rank 1: --size: 4000x4000 needs ")) << ended.ours()[0];
    EXPECT_EQ(files(), std::vector<std::string>());
}

/// In the middle of a frame, with others waiting for that rank's rows. Memory for messages is taken from the system
/// each time, so that the limit is felt at once.
TEST_F(MpirunFault, ARankThatRunsOutOfMemory)
{
    const std::string shrink = "export MALLOC_MMAP_THRESHOLD_=65536; " + onceDrawing("prlimit --pid $$ --as=1000000");
    const Ended ended = mpirun("-n 3 " + inRank(1, shrink) + aeolic() + animation() +
                               " --size 640x480 --steps 64 --guard-rows receive");
    expectEnded(ended);
    EXPECT_EQ(ended.ours(), std::vector<std::string>{"aeolic: rank 1: out of memory"}) << ended.err;
    expectWholePictures();
}

#endif

#ifdef AEOLIC_GL_FAULTS

/// Devices that are not as they should be.
class MpirunGpuFault : public MpirunFault {
protected:
    void SetUp() override
    {
        if (std::getenv("AEOLIC_REQUIRE_GL")) return;
        if (renderAlone("--surface sphere:200 --field abc:8,8,8 --size 8x8 --backend gl -o '" + path("try.png") + "'")
                .exitCode == 2)
            GTEST_SKIP() << "no OpenGL on this machine";
        std::filesystem::remove(path("try.png"));
    }

    /// A shell command that gives the rank such a device.
    static std::string device(const std::string& variables)
    {
        return "export LD_PRELOAD=" AEOLIC_GL_FAULTS " " + variables;
    }

    /// The ranks each on a device of their own kind, and what they are to draw.
    Ended renderOn(const std::string& first, const std::string& second, const std::string& arguments) const
    {
        const std::string rest =
            aeolic() + "render --surface sphere:2000 --field abc:64,64,64 --size 64x48 --steps 8 " + arguments + " ";
        return mpirun("-n 1 env LD_PRELOAD=" AEOLIC_GL_FAULTS " " + first + " " + rest +
                      ": -n 1 env LD_PRELOAD=" AEOLIC_GL_FAULTS " " + second + " " + rest);
    }
};

/// Found out before anything is read, and all ranks choose the same backend.
TEST_F(MpirunGpuFault, AGpuTooSmallOnOneRankAlone)
{
    const std::string line =
        "rank 1: abc: 64x64x64 samples, more than a texture of this GPU takes; expected at most 40 along each side: 8 "
        "ranks or more with --bricks on, or --backend cpu";
    const std::string real = "AEOLIC_TEST_REAL=1", small = "AEOLIC_TEST_SIDE=40";
    const Ended gl = renderOn(real, real + " " + small, "--backend gl " + output());
    expectFault(gl, line);
    EXPECT_EQ(gl.exitCode, 2);
    const Ended any = renderOn(real, real + " " + small, "--backend auto " + output());
    EXPECT_EQ(any.exitCode, 0) << any.err;
    EXPECT_EQ(any.ours(), std::vector<std::string>{"aeolic: warning: the GPU is not used: " + line});
    EXPECT_EQ(renderOn(real, real, "--backend cpu -o '" + path("cpu.png") + "'").exitCode, 0);
    EXPECT_EQ(bytes("a.png"), bytes("cpu.png"));
}

/// With nothing but the processor everywhere nobody is warned, and the reason is all ranks' own.
TEST_F(MpirunGpuFault, NoGpuOnAnyRankIsTheProcessorWithoutAWord)
{
    const Ended ended = renderOn("AEOLIC_TEST_NOTHING=1", "AEOLIC_TEST_NOTHING=1",
                                 "--backend auto " + output() + " --stats '" + path("a.json") + "'");
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_EQ(ended.ours(), std::vector<std::string>());
    EXPECT_NE(bytes("a.json").find("\"unused_gpu\": \"--backend: gl, but "), std::string::npos) << bytes("a.json");
}

TEST_F(MpirunGpuFault, NoGpuOnOneRankAloneIsTheProcessorOnAllUnderAuto)
{
    const Ended ended = renderOn("AEOLIC_TEST_REAL=1", "AEOLIC_TEST_NOTHING=1", "--backend auto " + output());
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    ASSERT_EQ(ended.ours().size(), 1u) << ended.err;
    EXPECT_EQ(ended.ours()[0].find("aeolic: warning: the GPU is not used: rank 1: --backend: gl, but "), 0u)
        << ended.ours()[0];
}

TEST_F(MpirunGpuFault, RanksOnOneGpuHaveItsMemoryTogether)
{
    const std::string enough = "AEOLIC_TEST_REAL=1 AEOLIC_TEST_FREE=9500000",
                      tight = "AEOLIC_TEST_REAL=1 AEOLIC_TEST_FREE=7500000";
    EXPECT_EQ(renderOn(enough, enough, "--backend gl -o '" + path("whole.png") + "'").exitCode, 0);
    const Ended ended = renderOn(tight, tight, "--backend gl " + output());
    EXPECT_EQ(ended.exitCode, 2);
    ASSERT_EQ(ended.ours().size(), 1u) << ended.err;
    EXPECT_NE(ended.ours()[0].find("at most the 3 MB that are free for each of the 2 ranks on this GPU: "),
              std::string::npos)
        << ended.ours()[0];
    EXPECT_EQ(renderOn(tight, tight, "--backend gl --bricks on " + output()).exitCode, 0);
    EXPECT_EQ(bytes("a.png"), bytes("whole.png"));
}

/// The other ranks wait for the rows of this one.
TEST_F(MpirunGpuFault, ARankWhoseGpuIsReset)
{
    const std::string reset = device("AEOLIC_TEST_RESET=\"" + path("a-0003.png") + "\"");
    const Ended ended =
        mpirun("-n 2 " + inRank(1, reset) + aeolic() + animation() + " --backend gl --guard-rows receive");
    EXPECT_NE(ended.exitCode, 0);
    EXPECT_EQ(strays(), std::vector<std::string>());
    ASSERT_EQ(ended.ours().size(), 1u) << ended.err;
    EXPECT_TRUE(ended.ours()[0].starts_with("aeolic: rank 1: gl: ")) << ended.ours()[0];
    EXPECT_TRUE(ended.ours()[0].ends_with(": it was reset for what this rank drew, and its context is lost"))
        << ended.ours()[0];
    expectWholePictures();
}

#endif

/// OpenMPI's launcher says which rank it was, MPICH's only what happened, and that on standard output.
TEST_F(MpirunFault, ARankThatIsKilledIsToldByTheLauncher)
{
    const Ended ended = mpirun("-n 3 " + inRank(1, onceDrawing("kill -KILL $$")) + aeolic() + animation());
    expectEnded(ended);
    EXPECT_EQ(ended.ours(), std::vector<std::string>()) << ended.err;
    const std::string said = ended.out + ended.err;
    EXPECT_NE(said.find("signal 9"), std::string::npos) << said;
    if (said.find("mpirun noticed") != std::string::npos) {
        EXPECT_NE(said.find("process rank 1 "), std::string::npos) << said;
    }
    expectWholePictures();
}

TEST_F(MpirunFault, RankZeroThatCannotWriteOn)
{
    const std::string folder = path("out"), loseIt = "mv \"" + folder + "\" \"" + path("lost") + "\"";
    std::filesystem::create_directories(folder);
    const Ended ended = mpirun("-n 2 " + inRank(0, onceDrawing(loseIt, "out/a-0003.png")) + aeolic() + animation() +
                               " -o '" + folder + "/a.png'");
    expectEnded(ended);
    ASSERT_EQ(ended.ours().size(), 1u) << ended.err;
    EXPECT_TRUE(ended.ours()[0].starts_with("aeolic: rank 0: " + folder + "/a-")) << ended.ours()[0];
    EXPECT_TRUE(ended.ours()[0].ends_with("cannot be written: No such file or directory")) << ended.ours()[0];
}

/// A batch system does so at the time limit.
TEST_F(MpirunFault, AnEndFromOutsideLeavesNoProcessAndWholePictures)
{
    const Ended ended = mpirunUntil("a-0003.png", "-n 3 " + aeolic() + animation());
    expectEnded(ended);
    expectWholePictures();
}

}  // namespace
}  // namespace aeolic
