#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "data/vtk/testing/sample_files.h"
#include "gl_calls_testing.h"
#include "render_testing.h"
#include "sparse_grid_testing.h"
#include "test_paths.h"

/// A device without room for a scene is found out before the scene is read.
namespace aeolic {
namespace {

namespace fs = std::filesystem;
using namespace testkit;

class GlRoom : public ::testing::Test {
protected:
    void SetUp() override { skipWithout("gl"); }

    SceneDescription description(const std::string& field) const
    {
        SceneDescription d;
        d.surface.spec = "sphere:200";
        d.field.spec = field;
        d.output.width = 32;
        d.output.height = 24;
        d.run.backend = BackendChoice::gl;
        return d;
    }

    /// The message, which must come before anything is read.
    std::string refusal(const SceneDescription& d) const
    {
        bool reads = false;
        std::string message;
        try {
            Renderer(d, [&](const char*, double) { reads = true; });
        } catch (const InputError& error) {
            message = error.what();
        }
        EXPECT_FALSE(reads);
        return message;
    }

    const test::TempFolder folder_;
};

/// A scene too large for this machine's memory gets another message when it is read or made.
TEST_F(GlRoom, ATerabyteIsRefusedByItsHeader)
{
    const std::string said = "32768x32768x256 samples, more than a texture of this GPU takes; expected at most ";
    writeSparseGrid(folder_.file("large.vti"), {32768, 32768, 256});
    const std::string message = refusal(description(folder_.file("large.vti")));
    EXPECT_EQ(message.find("U: " + said), 0u) << message;
    EXPECT_NE(message.find(" ranks or more with --bricks on, or --backend cpu"), std::string::npos) << message;
}

TEST_F(GlRoom, ABuiltinFlowIsRefusedBeforeItIsMade)
{
    static decltype(glGetInteger64v) real;
    real = glGetInteger64v;
    const Replaced<decltype(glGetInteger64v)> small(glGetInteger64v, [](GLenum name, GLint64* value) {
        real(name, value);
        if (name == GL_MAX_3D_TEXTURE_SIZE) *value = 100;
    });
    EXPECT_EQ(refusal(description("abc:4096,4096,4096")).find("abc: 4096x4096x4096 samples, more than a texture"), 0u);
}

/// For an animation the steps that its frames show count, for a still picture only its own.
TEST_F(GlRoom, ALaterStepIsRefusedByItsHeader)
{
    static decltype(glGetInteger64v) real;
    real = glGetInteger64v;
    const Replaced<decltype(glGetInteger64v)> small(glGetInteger64v, [](GLenum name, GLint64* value) {
        real(name, value);
        if (name == GL_MAX_3D_TEXTURE_SIZE) *value = 100;
    });
    test::GridSample sample;
    for (const char* file : {"f_0.vti", "f_1.vti", "f_2.vti"}) test::writeGridFile(folder_.file(file), sample);
    writeSparseGrid(folder_.file("f_3.vti"), {32768, 32768, 256});
    SceneDescription d = description(folder_.file("f_*.vti"));
    d.output.frames = 7;
    d.time.range = {0, 3};
    const std::string line = "U: 32768x32768x256 samples, more than a texture of this GPU takes; expected at most 100 ";
    EXPECT_EQ(refusal(d).find(line), 0u);
    d.time.range = {3, 0};
    EXPECT_EQ(refusal(d).find(line), 0u);
    d.time.range.reset();
    d.output.frames = 1;
    d.time.moment = 3;
    EXPECT_EQ(refusal(d).find(line), 0u) << "the first one's size says nothing";
    d.time.moment = 2;
    EXPECT_EQ(Renderer(d).info().backend, "gl") << "it does not show the large one";
    std::ofstream(folder_.file("f_2.vti")) << "no header";
    d.time.moment.reset();
    d.output.frames = 2;
    d.time.range = {1, 2};
    EXPECT_EQ(Renderer(d).info().backend, "gl") << "what is wrong with it is told by reading it";
}

/// Faults of the file are reported as on any device.
TEST_F(GlRoom, AFileThatCannotBeReadIsNoMatterOfTheGpu)
{
    const std::string none = folder_.file("none.vti");
    EXPECT_EQ(refusal(description(none)), none + ": no such file; expected a file that can be read");
}

#ifdef AEOLIC_GL_FAULTS  // Sanitizers must be loaded first, so nothing can be preloaded.

/// The program on a device with other limits.
class GlRoomOfTheProgram : public GlRoom {
protected:
    struct Ended {
        int exitCode;
        std::string err;
    };

    Ended render(const std::string& environment, const std::string& arguments) const
    {
        const std::string command = "cd '" + folder_.path().string() + "' && " + environment +
                                    " LD_PRELOAD=" AEOLIC_GL_FAULTS " '" AEOLIC_PROGRAM
                                    "' render --size 48x40 --steps 8 " +
                                    arguments + " 2>.err >.out </dev/null";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes(".err")};
    }

    std::string bytes(const std::string& file) const
    {
        std::ifstream stream(folder_.file(file), std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    bool exists(const std::string& file) const { return fs::exists(folder_.file(file)); }
};

/// A GPU that is there and cannot be used is mentioned without being asked. A device that is no GPU is not.
TEST_F(GlRoomOfTheProgram, AGpuThatCannotDrawIsAWarningUnderAuto)
{
    const std::string scene = "--surface sphere:200 --field abc:4,4,4 ";
    const bool hasGpu = render("", scene + "-o any.png --stats any.json").exitCode == 0 &&
                        bytes("any.json").find("\"backend\": \"gl\"") != std::string::npos;
    const std::string closed = "EGL could open none of its devices (is /dev/dri or /dev/nvidia* readable?)",
                      old = "makes no OpenGL 4.5 core context without a window";
    for (const auto& [variable, line] : {std::pair{"AEOLIC_TEST_CLOSED=1", closed}, {"AEOLIC_TEST_OLD=1", old}}) {
        const std::string fault = variable;
        const Ended any = render("AEOLIC_TEST_REAL=1 " + fault, scene + "-o auto.png --stats auto.json");
        EXPECT_EQ(any.exitCode, 0);
        EXPECT_EQ(any.err.find("aeolic: warning: the GPU is not used: --backend: gl, but "), 0u) << any.err;
        EXPECT_NE(any.err.find(line), std::string::npos) << any.err;
        EXPECT_NE(bytes("auto.json").find("\"backend\": \"cpu\""), std::string::npos);
        const Ended plain = render(fault, scene + "-o auto.png");
        EXPECT_EQ(plain.err, hasGpu ? any.err : "") << "a program alone";
        const Ended gl = render(fault, scene + "--backend gl -o gl.png");
        EXPECT_EQ(gl.exitCode, 2);
        EXPECT_NE(gl.err.find(line), std::string::npos) << gl.err;
    }
}

TEST_F(GlRoomOfTheProgram, TooLittleMemoryIsAnErrorUnderGlAndTheProcessorUnderAuto)
{
    const std::string scene = "--surface sphere:200 --field abc:64,64,64 ";
    const std::string line =
        "abc: 64x64x64 samples take 4 MB of GPU memory; expected at most the 2 MB that are free: 2 or more GPUs with "
        "--bricks on, --field-precision half, or --backend cpu\n";
    const Ended gl = render("AEOLIC_TEST_REAL=1 AEOLIC_TEST_FREE=2500000", scene + "--backend gl -o gl.png");
    EXPECT_EQ(gl.exitCode, 2);
    EXPECT_EQ(gl.err, "aeolic: " + line);
    EXPECT_FALSE(exists("gl.png"));
    const Ended any = render("AEOLIC_TEST_REAL=1 AEOLIC_TEST_FREE=2500000", scene + "-o auto.png --stats auto.json");
    EXPECT_EQ(any.exitCode, 0);
    EXPECT_EQ(any.err, "aeolic: warning: the GPU is not used: " + line);
    EXPECT_NE(bytes("auto.json").find("\"backend\": \"cpu\""), std::string::npos);
    EXPECT_EQ(render("", scene + "--backend cpu -o cpu.png").exitCode, 0);
    EXPECT_EQ(bytes("auto.png"), bytes("cpu.png"));
    EXPECT_EQ(render("AEOLIC_TEST_REAL=1 AEOLIC_TEST_FREE=25000000", scene + "-o a.png --stats a.json").exitCode, 0);
    EXPECT_NE(bytes("a.json").find("\"backend\": \"gl\""), std::string::npos) << "the same with room";
}

/// A step on a larger grid after two on a small one. The headers of .vtk files are not read beforehand.
class GlRoomOfSteps : public GlRoomOfTheProgram {
protected:
    std::string scene(const std::string& extension) const
    {
        test::GridSample small, large;
        small.dims = {5, 5, 5};
        small.spacing = {0.5, 0.5, 0.5};
        large.dims = {17, 17, 17};
        large.spacing = {0.125, 0.125, 0.125};
        test::writeGridFile(folder_.file("f_0" + extension), small);
        test::writeGridFile(folder_.file("f_1" + extension), small);
        test::writeGridFile(folder_.file("f_2" + extension), large);
        return "--surface sphere:500 --field 'f_*" + extension + "' --frames 5 --time-range 0,2 ";
    }

    const std::string line_ = "U: 17x17x17 samples, more than a texture of this GPU takes; expected at most 8 along ";
};

TEST_F(GlRoomOfSteps, OneThatDoesNotFitByItsHeaderIsAnErrorUnderGlAndTheProcessorUnderAutoFromTheStart)
{
    const std::string steps = scene(".vti");
    const Ended gl = render("AEOLIC_TEST_SIDE=8", steps + "--backend gl -o gl.png");
    EXPECT_EQ(gl.exitCode, 2);
    EXPECT_EQ(gl.err.find("aeolic: " + line_), 0u) << gl.err;
    EXPECT_EQ(std::count(gl.err.begin(), gl.err.end(), '\n'), 1) << gl.err;
    EXPECT_FALSE(exists("gl-0000.png"));
    const Ended any = render("AEOLIC_TEST_REAL=1 AEOLIC_TEST_SIDE=8", steps + "-o auto.png --stats auto.json");
    EXPECT_EQ(any.exitCode, 0);
    EXPECT_NE(any.err.find("aeolic: warning: the GPU is not used: " + line_), std::string::npos) << any.err;
    EXPECT_EQ(render("", steps + "--backend cpu -o cpu.png").exitCode, 0);
    for (const std::string frame : {"-0000.png", "-0003.png", "-0004.png"})
        EXPECT_EQ(bytes("auto" + frame), bytes("cpu" + frame)) << frame;
    const Ended few = render("AEOLIC_TEST_SIDE=8", steps + "--time-range 0,1 --backend gl -o few.png");
    EXPECT_EQ(few.exitCode, 0) << "no frame shows it: " << few.err;
}

/// Each has the device to itself.
TEST_F(GlRoomOfSteps, OneThatTakesTooMuchMemory)
{
    const std::string steps = scene(".vti");
    const Ended gl = render("AEOLIC_TEST_REAL=1 AEOLIC_TEST_FREE=60000", steps + "--backend gl -o gl.png");
    EXPECT_EQ(gl.exitCode, 2);
    EXPECT_EQ(gl.err.find("aeolic: U: 17x17x17 samples take "), 0u) << gl.err;
    EXPECT_EQ(render("AEOLIC_TEST_REAL=1 AEOLIC_TEST_FREE=60000", steps + "--time-range 0,1 --backend gl -o few.png")
                  .err.find("aeolic: U: "),
              std::string::npos);
}

TEST_F(GlRoomOfSteps, OneFoundOutWhenItIsReadIsAnErrorUnderGlAndTheProcessorUnderAutoFromThere)
{
    const std::string steps = scene(".vtk");
    const Ended gl = render("AEOLIC_TEST_SIDE=8", steps + "--backend gl -o gl.png");
    EXPECT_EQ(gl.exitCode, 2);
    EXPECT_NE(gl.err.find("aeolic: " + line_), std::string::npos) << gl.err;
    const Ended any = render("AEOLIC_TEST_REAL=1 AEOLIC_TEST_SIDE=8", steps + "-o auto.png --stats auto.json");
    EXPECT_EQ(any.exitCode, 0);
    EXPECT_NE(any.err.find("aeolic: warning: the GPU is not used: " + line_), std::string::npos) << any.err;
    EXPECT_NE(bytes("auto.json").find("\"backend\": \"cpu\""), std::string::npos) << "as it was in the end";
    EXPECT_EQ(render("", steps + "--backend cpu -o cpu.png").exitCode, 0);
    EXPECT_EQ(render("", steps + "--backend gl -o gl.png").exitCode, 0);
    EXPECT_EQ(bytes("auto-0000.png"), bytes("gl-0000.png")) << "in flight when the processor took over";
    EXPECT_EQ(bytes("auto-0003.png"), bytes("gl-0003.png"));
    EXPECT_EQ(bytes("auto-0004.png"), bytes("cpu-0004.png"));
}

#endif

}  // namespace
}  // namespace aeolic
