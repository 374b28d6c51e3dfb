#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "gl_calls_testing.h"
#include "render_testing.h"
#include "test_paths.h"

/// Devices that are reset, hang or run out of memory: one line that says which device and what, and nothing hangs.
namespace aeolic {
namespace {

namespace fs = std::filesystem;
using namespace testkit;

class GlFaults : public ::testing::Test {
protected:
    void SetUp() override
    {
        skipWithout("gl");
        if (IsSkipped() || HasFatalFailure()) return;
        renderer_.emplace(description());
        before_ = renderer_->render({});
    }

    static SceneDescription description()
    {
        SceneDescription d;
        d.surface.spec = "teapot:2000";
        d.field.spec = "abc:8,8,8";
        d.output.width = 90;
        d.output.height = 70;
        d.run.backend = BackendChoice::gl;
        return d;
    }

    /// The message of a frame that must fail. Afterwards the renderer is destroyed, and a new one must draw as usual.
    std::string messageOfAFrame()
    {
        std::string message = "nothing failed";
        try {
            renderer_->render({});
        } catch (const DeviceError& error) {
            message = error.what();
        }
        renderer_.reset();
        return message;
    }
    void expectTheNextDraws() { EXPECT_EQ(Renderer(description()).render({}).pixels, before_.pixels); }
    std::string device() const { return renderer_->info().device; }

    std::optional<Renderer> renderer_;
    Picture before_;
};

TEST_F(GlFaults, AResetEndsTheFrameAndItsContextIsNotUsedAgain)
{
    const std::string name = device();
    {
        const Replaced<decltype(glGetGraphicsResetStatus)> reset(glGetGraphicsResetStatus,
                                                                 []() -> GLenum { return GL_INNOCENT_CONTEXT_RESET; });
        EXPECT_EQ(messageOfAFrame(),
                  "gl: " + name + ": it was reset for what another program did, and its context is lost");
    }
    expectTheNextDraws();
}

TEST_F(GlFaults, ADeviceThatHangsIsNotWaitedForForEver)
{
    const std::string name = device();
    {
        const Replaced<decltype(glClientWaitSync)> hang(
            glClientWaitSync, [](GLsync, GLbitfield, GLuint64) -> GLenum { return GL_TIMEOUT_EXPIRED; });
        EXPECT_EQ(messageOfAFrame(), "gl: " + name + ": it does not finish its frame: it hangs, or was reset");
    }
    expectTheNextDraws();
}

/// A glGetError() that reports lack of memory at every second call.
GLenum noMemory()
{
    static bool told = true;
    return (told = !told) ? GL_NO_ERROR : GL_OUT_OF_MEMORY;
}

TEST_F(GlFaults, AFrameThatTheDeviceHasNoMemoryForSaysHowMuchItWas)
{
    const std::string name = device();
    renderer_->setSize(1024, 1024);
    {
        const Replaced<decltype(glGetError)> exhausted(glGetError, noMemory);
        const std::string message = messageOfAFrame();
        EXPECT_EQ(message.find("gl: " + name + ": out of memory allocating a texture of 1024x1024 of 4 MB"), 0u)
            << message;
        EXPECT_NE(message.find("fewer ranks on this GPU, or a smaller picture"), std::string::npos) << message;
    }
    expectTheNextDraws();
}

/// Such a device is wrong input and no failure: `auto` then takes the processor.
TEST_F(GlFaults, ASceneThatTheDeviceHasNoMemoryForIsWrongInput)
{
    const Scene scene = makeBuiltinScene("sphere:200", "abc:64,64,64");
    const Replaced<decltype(glGetError)> exhausted(glGetError, noMemory);
    try {
        makeBackend(BackendChoice::gl, scene);
        ADD_FAILURE() << "nothing failed";
    } catch (const InputError& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("64x64x64 samples take 4 MB of GPU memory; expected "), std::string::npos) << message;
        EXPECT_NE(message.find("GPUs with --bricks on, --field-precision half, or --backend cpu"), std::string::npos)
            << message;
    }
}

TEST_F(GlFaults, WhatTheDriverHasToSayIsAnErrorWhileDebugging)
{
    const Scene scene = makeBuiltinScene("sphere:200", "abc:8,8,8");
    const auto backend = makeBackend(BackendChoice::gl, scene);
    const View view = makeView(fitCamera(scene, {}, 40, 30), scene, {});
    backend->project(view, {0, 0, 40, 30});
    glDebugMessageInsert(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_ERROR, 1, GL_DEBUG_SEVERITY_HIGH, -1, "no, not so");
    try {
        backend->convolve({}, {0, 0, 40, 30});
        ADD_FAILURE() << "nothing was said";
    } catch (const DeviceError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "gl: " + backend->device() + ": while convolving its driver says: no, not so");
    }
}

#ifdef AEOLIC_GL_FAULTS  // Sanitizers must be loaded first, so nothing can be preloaded.

/// The program on a device that fails.
class GlFaultsOfTheProgram : public GlFaults {
protected:
    void SetUp() override
    {
        GlFaults::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    /// Exit code and standard error of `aeolic render` with that in its environment.
    std::pair<int, std::string> render(const std::string& environment, const std::string& size,
                                       const std::string& more = "") const
    {
        const std::string command = "cd '" + folder_.string() + "' && " + environment +
                                    " LD_PRELOAD=" AEOLIC_GL_FAULTS " '" AEOLIC_PROGRAM
                                    "' render --backend gl --surface teapot:2000 --field abc:8,8,8 "
                                    "--steps 8 --size " +
                                    size + " " + more + " -o a.png 2>.err >.out </dev/null";
        const int status = std::system(command.c_str());
        std::ifstream err(folder_ / ".err", std::ios::binary);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, {std::istreambuf_iterator<char>(err), {}}};
    }

    fs::path folder_ = fs::temp_directory_path() / ("aeolic_gl_faults_" + std::to_string(getpid()));
};

TEST_F(GlFaultsOfTheProgram, OneLineAndNothingHalfWritten)
{
    std::ofstream(folder_ / "reset").put('1');
    const std::string about = "aeolic: gl: " + device() + ": ";
    const auto [resetCode, reset] = render("AEOLIC_TEST_RESET=reset", "64x48");
    EXPECT_EQ(resetCode, 1);
    EXPECT_EQ(reset, about + "it was reset for what this rank drew, and its context is lost\n");
    const auto [memoryCode, memory] = render("AEOLIC_TEST_MEMORY=1000000", "640x480");
    EXPECT_EQ(memoryCode, 1);
    EXPECT_EQ(memory.find(about + "out of memory allocating a texture of 640x480 of 1 MB"), 0u) << memory;
    EXPECT_EQ(std::count(memory.begin(), memory.end(), '\n'), 1) << memory;
    EXPECT_FALSE(fs::exists(folder_ / "a.png"));
    EXPECT_EQ(render("AEOLIC_TEST_RESET=none", "64x48").first, 0);
    EXPECT_TRUE(fs::exists(folder_ / "a.png"));
}

TEST_F(GlFaultsOfTheProgram, AnAnimationBeginsTheNextFrameBeforeItWaits)
{
    EXPECT_EQ(render("AEOLIC_TEST_OVERLAP=one", "64x48").first, 0);
    EXPECT_FALSE(fs::exists(folder_ / "one")) << "a picture alone";
    EXPECT_EQ(render("AEOLIC_TEST_OVERLAP=three", "64x48", "--frames 3").first, 0);
    EXPECT_TRUE(fs::exists(folder_ / "three"));
    EXPECT_TRUE(fs::exists(folder_ / "a-0002.png"));
}

#endif

}  // namespace
}  // namespace aeolic
