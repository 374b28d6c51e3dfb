#include "same_bytes_testing.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <functional>
#include <mutex>

#include "aeolic/error.h"
#include "aeolic/renderer.h"
#include "description/camera.h"
#include "description/choices.h"
#include "engine/frame.h"
#include "engine/tile_picture.h"
#include "load_testing.h"

namespace aeolic::testkit {

LicOptions licOf(LicMethod method, int steps, Kernel kernel, bool normalize)
{
    LicOptions lic;
    lic.method = method;
    lic.steps = steps;
    lic.kernel = kernel;
    lic.phase = 0.7;
    lic.normalize = normalize;
    return lic;
}

Case makeCase(const std::string& name, int width, int height, const LicOptions& lic, const std::string& surface,
              const std::string& field)
{
    SceneDescription description;
    description.surface.spec = surface;
    description.field.spec = field;
    description.shading.colorBy = field.substr(0, field.find(':')) + ":mag";
    description.lic = lic;
    description.output.width = width;
    description.output.height = height;
    CameraOptions close;
    close.zoom = 1.5;
    return {name, description, close, nullptr, std::nullopt};
}

namespace {

using CameraOf = std::function<CameraOptions(int frame, const Scene& scene)>;

std::vector<Picture> drawFrames(const std::string& backendName, const Case& c, const RunOptions& options, int ranks,
                                int frames, const CameraOf& cameraOf)
{
    std::vector<Picture> pictures;
    runRanks(ranks, [&](Communicator& communicator) {
        // A group shares its communicator; this one belongs to runRanks.
        FrameGroup group(std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}), options);
        SceneDescription description = c.description;
        description.run = options;
        tbb::task_arena arena(1);
        arena.execute([&] {
            CommunicatorAgreement agreement(communicator);
            const Split split = c.split && ranks > 1 ? *c.split : splitOf(description, agreement, ranks);
            const Scene scene = loadScene(description, split, agreement);
            const auto backend = makeBackend(*choiceNamed<BackendChoice>(backendName), scene);
            Frame drawn;
            for (int frame = 0; frame < frames; ++frame) {
                FrameRequest request{makeCamera(cameraOf(frame, scene), scene.boundsWorld, scene.fitRadius,
                                                description.output.width, description.output.height, scene.reach),
                                     description.lic, description.shading};
                request.overlay = c.overlay;
                if (description.lic.flow == FlowMotion::loop) {
                    request.inCycle = true;
                    request.lic.phase = frame;
                }
                renderFrame(request, scene, *backend, group, drawn);
                if (communicator.isRoot()) pictures.push_back(gatheredPicture(drawn.tiles, description.output.height));
            }
        });
    });
    return pictures;
}

}  // namespace

std::vector<Picture> draw(const std::string& backendName, const Case& c, const RunOptions& options, int ranks,
                          int frames)
{
    return drawFrames(backendName, c, options, ranks, frames, [&](int frame, const Scene& scene) {
        return orbited(c.camera, 25.0 * frame, scene.boundsWorld);
    });
}

std::vector<Picture> draw(const std::string& backendName, const Case& c, const RunOptions& options, int ranks,
                          const std::vector<CameraOptions>& cameras)
{
    return drawFrames(backendName, c, options, ranks, int(cameras.size()),
                      [&](int frame, const Scene&) { return cameras[std::size_t(frame)]; });
}

RunOptions runOptions(const std::string& balance, const std::string& guard, const std::string& guardRows,
                      const std::string& bricks)
{
    RunOptions options;
    options.balance = choiceNamed<Balance>(balance).value();
    options.guard = choiceNamed<GuardChoice>(guard).value();
    options.guardRows = choiceNamed<GuardRowsChoice>(guardRows).value();
    options.bricks = choiceNamed<BrickChoice>(bricks).value();
    return options;
}

void expectSameBytes(const std::string& backendName, const Case& c, const std::vector<Picture>& expected,
                     const RunOptions& options, int ranks)
{
    const std::vector<Picture> pictures = draw(backendName, c, options, ranks, int(expected.size()));
    ASSERT_EQ(pictures.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(pictures[i].pixels.size(), expected[i].pixels.size());
        std::size_t differing = 0;
        for (std::size_t k = 0; k < expected[i].pixels.size(); ++k)
            differing += pictures[i].pixels[k] != expected[i].pixels[k];
        EXPECT_EQ(differing, 0u) << c.name << ", " << ranks << " ranks, " << nameOf(options.balance) << ", guard "
                                 << nameOf(options.guard) << " " << nameOf(options.guardRows) << ", bricks "
                                 << nameOf(options.bricks) << ", frame " << i;
    }
}

std::string complaintOf(const SceneDescription& description, int ranks)
{
    std::string complaint;
    std::mutex mutex;
    try {
        runRanks(ranks, [&](Communicator& communicator) {
            try {
                const Renderer renderer(description,
                                        std::shared_ptr<Communicator>(&communicator, [](Communicator*) {}));
            } catch (const InputError& error) {
                const std::lock_guard lock(mutex);
                if (!complaint.empty()) {
                    EXPECT_EQ(complaint, error.what()) << "every rank says the same";
                }
                complaint = error.what();
            }
        });
    } catch (const std::exception& error) {
        return std::string("not an InputError: ") + error.what();
    }
    return complaint;
}

}  // namespace aeolic::testkit
