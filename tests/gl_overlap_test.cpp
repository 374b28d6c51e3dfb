#include <algorithm>
#include <optional>
#include <stdexcept>

#include "aeolic/renderer.h"
#include "engine/frame.h"
#include "gl_calls_testing.h"
#include "ranks/thread_communicator.h"
#include "render/lic/jump_plan.h"
#include "render_testing.h"

/// The GPU draws frame n + 1 while frame n is read back and used. The tests see that by the order of calls.
namespace aeolic {
namespace {

using namespace testkit;

/// What was asked of the device, in order.
struct Call {
    enum Kind { work, fence, wait, allocation } kind;
    GLsync sync = nullptr;  // For fences, and for waits for them.
};
thread_local std::vector<Call> calls;  // Ranks are threads here, and each has a context of its own.

/// Writes down calls for as long as it lives.
class Recording {
public:
    Recording()
    {
        calls.clear();
        now_ = this;
    }
    ~Recording() { now_ = nullptr; }

    /// The calls of one kind, from `first` on.
    static long count(Call::Kind kind, std::size_t first = 0)
    {
        return std::count_if(calls.begin() + long(first), calls.end(), [&](const Call& c) { return c.kind == kind; });
    }

    static bool isWaitedFor(GLsync sync, std::size_t first)
    {
        return std::any_of(calls.begin() + long(first), calls.end(),
                           [&](const Call& c) { return c.kind == Call::wait && c.sync == sync; });
    }

    static bool isSetBefore(GLsync sync, std::size_t last)
    {
        return std::any_of(calls.begin(), calls.begin() + long(last),
                           [&](const Call& c) { return c.kind == Call::fence && c.sync == sync; });
    }

private:
    static inline Recording* now_ = nullptr;
    static void add(Call::Kind kind, GLsync sync = nullptr) { calls.push_back({kind, sync}); }

    Replaced<decltype(glDispatchCompute)> dispatch_{glDispatchCompute, [](GLuint x, GLuint y, GLuint z) {
                                                        add(Call::work);
                                                        now_->dispatch_.original()(x, y, z);
                                                    }};
    Replaced<decltype(glDispatchComputeIndirect)> indirect_{glDispatchComputeIndirect, [](GLintptr at) {
                                                                add(Call::work);
                                                                now_->indirect_.original()(at);
                                                            }};
    Replaced<decltype(glFenceSync)> fence_{glFenceSync, [](GLenum condition, GLbitfield flags) {
                                               const GLsync sync = now_->fence_.original()(condition, flags);
                                               add(Call::fence, sync);
                                               return sync;
                                           }};
    Replaced<decltype(glClientWaitSync)> wait_{glClientWaitSync, [](GLsync sync, GLbitfield flags, GLuint64 ns) {
                                                   add(Call::wait, sync);
                                                   return now_->wait_.original()(sync, flags, ns);
                                               }};
    Replaced<decltype(glGetQueryObjectui64v)> query_{glGetQueryObjectui64v, [](GLuint id, GLenum name, GLuint64* out) {
                                                         add(Call::wait);
                                                         now_->query_.original()(id, name, out);
                                                     }};
    Replaced<decltype(glGetTextureSubImage)> image_{
        glGetTextureSubImage, [](GLuint id, GLint level, GLint x, GLint y, GLint z, GLsizei width, GLsizei height,
                                 GLsizei depth, GLenum format, GLenum type, GLsizei bytes, void* to) {
            GLint packBuffer = 0;
            glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &packBuffer);
            if (packBuffer == 0) add(Call::wait);  // Reads straight into this process's memory.
            now_->image_.original()(id, level, x, y, z, width, height, depth, format, type, bytes, to);
        }};
    Replaced<decltype(glNamedBufferStorage)> buffer_{
        glNamedBufferStorage, [](GLuint id, GLsizeiptr bytes, const void* data, GLbitfield flags) {
            add(Call::allocation);
            now_->buffer_.original()(id, bytes, data, flags);
        }};
    Replaced<decltype(glTextureStorage2D)> texture_{
        glTextureStorage2D, [](GLuint id, GLsizei levels, GLenum format, GLsizei width, GLsizei height) {
            add(Call::allocation);
            now_->texture_.original()(id, levels, format, width, height);
        }};
};

class GlOverlap : public ::testing::Test {
protected:
    void SetUp() override
    {
        skipWithout("gl");
        if (IsSkipped() || HasFatalFailure()) return;
        SceneDescription d;
        d.surface.spec = "teapot:2000";
        d.field.spec = "abc:8,8,8";
        d.output.width = 90;
        d.output.height = 70;
        d.output.frames = 6;
        d.lic.steps = 20;
        d.run.backend = BackendChoice::gl;
        renderer_.emplace(d);
        for (int frame = 0; frame < 6; ++frame) expected_.push_back(renderer_->render({AnimationFrame{frame}}));
    }

    std::optional<Renderer> renderer_;
    std::vector<Picture> expected_;  // Drawn one at a time.
};

TEST_F(GlOverlap, AFrameIsStartedWithoutWaiting)
{
    const Recording recording;
    renderer_->start({AnimationFrame{0}});
    renderer_->start({AnimationFrame{1}});
    EXPECT_EQ(Recording::count(Call::wait), 0);
    EXPECT_GT(Recording::count(Call::work), 0);
    renderer_->finish();
    renderer_->finish();
}

/// While frames follow each other, what is waited for is always older than work the device already has.
TEST_F(GlOverlap, TheNextFrameIsOnTheDeviceBeforeTheOneBeforeIsWaitedFor)
{
    const Recording recording;
    ASSERT_EQ(renderer_->framesInFlight(), 2);
    renderer_->start({AnimationFrame{0}});
    for (int frame = 0; frame < 5; ++frame) {
        const std::size_t before = calls.size();
        renderer_->start({AnimationFrame{frame + 1}});
        const std::size_t started = calls.size();
        ASSERT_GT(Recording::count(Call::work, before), 0);
        EXPECT_EQ(renderer_->finish().pixels, expected_[std::size_t(frame)].pixels) << frame;
        EXPECT_EQ(Recording::count(Call::work, started), 0) << "finishing gives the device nothing more to do";
        EXPECT_GT(Recording::count(Call::wait, started), 0);
        for (std::size_t i = before; i < started; ++i)
            if (calls[i].kind == Call::fence) {
                EXPECT_FALSE(Recording::isWaitedFor(calls[i].sync, started))
                    << "frame " << frame << " waits for the one after it";
            }
    }
    EXPECT_EQ(renderer_->finish().pixels, expected_[5].pixels);
}

TEST_F(GlOverlap, FramesOnceDrawnAllocateNothing)
{
    renderer_->start({AnimationFrame{0}}), renderer_->start({AnimationFrame{1}});
    renderer_->finish(), renderer_->finish();
    const Recording recording;
    renderer_->start({AnimationFrame{2}});
    for (int frame = 3; frame < 6; ++frame) renderer_->start({AnimationFrame{frame}}), renderer_->finish();
    renderer_->finish();
    EXPECT_EQ(Recording::count(Call::allocation), 0);
}

/// On each level of jumps the rows that other ranks read are computed first, and travel while the device computes the
/// rest. There is one wait a level, besides those for the plan of the exchange, for vectors and links, for the values
/// of the second convolution, and for those that the mean around is taken of.
TEST_F(GlOverlap, GuardRowsTravelWhileTheRestOfALevelIsComputed)
{
    const Scene scene = makeBuiltinScene("teapot:2000", "abc:8,8,8");
    LicOptions lic;
    lic.steps = 64;
    const FrameRequest request{fitCamera(scene, {}, 90, 700), lic, {}};
    RunOptions options;
    options.balance = Balance::equal;
    options.guardRows = GuardRowsChoice::receive;
    options.guard = GuardChoice::estimate;
    const auto drawTwice = [&](const Recording* recording) {
        runRanks(2, [&](Communicator& communicator) {
            FrameGroup group(std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}), options);
            const auto backend = makeBackend(BackendChoice::gl, scene, {-1, communicator.rank()});
            Frame frame;
            renderFrame(request, scene, *backend, group, frame);
            calls.clear();
            startFrame(request, scene, *backend, group, frame);
            long waits = 0, beside = 0;
            for (std::size_t i = 0; i < calls.size(); ++i) {
                if (calls[i].kind != Call::wait) continue;
                ++waits;
                beside += i > 0 && calls[i - 1].kind == Call::work && Recording::isSetBefore(calls[i].sync, i - 1);
            }
            finishFrame(*backend, group, frame);
            if (!recording) return;
            const long levels = long(planJumps(lic.steps).digits.size());
            EXPECT_EQ(waits, 4 + levels);
            EXPECT_GE(beside, levels) << "of the last level others may read all there is";
        });
    };
    drawTwice(nullptr);  // libepoxy has found its functions.
    const Recording recording;
    drawTwice(&recording);
}

/// Other ranks wait for the pixels of this rank's brick. They are drawn first, and travel while the device draws the
/// rank's own rows.
TEST_F(GlOverlap, TheRowsAreDrawnWhileABricksPixelsAreOnTheirWay)
{
    SceneDescription d = renderer_->description();
    d.run.bricks = BrickChoice::on;
    d.run.balance = Balance::equal;
    const auto makeRenderer = [&](Communicator& communicator) {
        return Renderer(d, std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
    };
    // What bricks alone call is called once before it is replaced (gl_calls_testing.h).
    runRanks(2, [&](Communicator& communicator) { makeRenderer(communicator).render({AnimationFrame{0}}); });
    const Recording recording;
    runRanks(2, [&](Communicator& communicator) {
        Renderer renderer = makeRenderer(communicator);
        renderer.render({AnimationFrame{0}});
        calls.clear();
        renderer.start({AnimationFrame{1}});
        std::size_t fence = calls.size(), wait = calls.size();
        for (std::size_t i = calls.size(); i-- > 0;)
            if (calls[i].kind == Call::wait) wait = i;
        ASSERT_LT(wait, calls.size());
        for (std::size_t i = 0; i < wait; ++i)
            if (calls[i].kind == Call::fence && calls[i].sync == calls[wait].sync) fence = i;
        ASSERT_LT(fence, wait);
        const auto rowsOfIt = std::count_if(calls.begin() + long(fence), calls.begin() + long(wait),
                                            [](const Call& call) { return call.kind == Call::work; });
        EXPECT_EQ(rowsOfIt, 2) << "their coverage, and what they show";
        const Picture picture = renderer.finish();
        if (communicator.isRoot()) {
            EXPECT_EQ(picture.pixels, expected_[1].pixels);
        }
    });
}

/// What is changed between start and finish counts for later frames.
TEST_F(GlOverlap, AFrameIsWhatWasAskedForWhenItWasStarted)
{
    renderer_->start({AnimationFrame{0}});
    ShadingOptions shading;
    shading.background = "transparent";
    renderer_->setShading(shading);
    renderer_->setSize(31, 17);
    renderer_->start({AnimationFrame{0}});
    EXPECT_EQ(renderer_->finish().pixels, expected_[0].pixels);
    const Picture other = renderer_->finish();
    EXPECT_EQ(other.width, 31);
    EXPECT_EQ(other.channels, 4);
}

TEST_F(GlOverlap, NoMoreThanFitAndNoneThatAreNot)
{
    EXPECT_THROW(renderer_->finish(), std::logic_error);
    renderer_->start({AnimationFrame{0}}), renderer_->start({AnimationFrame{1}});
    EXPECT_THROW(renderer_->start({AnimationFrame{2}}), std::logic_error);
    EXPECT_EQ(renderer_->finish().pixels, expected_[0].pixels);
    EXPECT_EQ(renderer_->finish().pixels, expected_[1].pixels);
}

/// On processors too the two halves are the whole, and only one frame fits.
TEST(FrameHalves, OnAProcessor)
{
    SceneDescription d;
    d.surface.spec = "teapot:2000";
    d.field.spec = "abc:8,8,8";
    d.output.width = d.output.height = 40;
    d.run.backend = BackendChoice::cpu;
    Renderer renderer(d);
    const Picture whole = renderer.render({});
    EXPECT_EQ(renderer.framesInFlight(), 1);
    renderer.start({});
    EXPECT_THROW(renderer.start({}), std::logic_error);
    EXPECT_EQ(renderer.finish().pixels, whole.pixels);
    renderer.start({{}, false});
    EXPECT_EQ(renderer.finish().pixels, whole.pixels);
}

}  // namespace
}  // namespace aeolic
