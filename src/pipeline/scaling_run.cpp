#include "pipeline/scaling_run.h"

#include <tbb/task_arena.h>

#include <memory>
#include <mutex>

#include "cluster/thread_communicator.h"
#include "pipeline/frame.h"
#include "pipeline/load_together.h"
#include "pipeline/unify.h"
#include "render/backend.h"

namespace aeolic {
namespace {

/// One rank: a scene, a backend, and the animations they draw together with the others.
class RankDrawing {
public:
    RankDrawing(const SceneDescription& description, const Scene& scene, Communicator& communicator)
        : description_(description),
          scene_(scene),
          communicator_(communicator),
          radius_(reachOf(communicator, scene).radius),
          backend_(makeBackend(description.run.backend, scene, {description.run.device, 0}))
    {
    }

    void measure(const ScalingSetup& setup, const std::string& balancer, std::mutex& turn, bool alsoWall,
                 const std::function<void()>& onFrame, ScalingSamples& samples)
    {
        FrameGroup group = makeGroup(balancer, &turn);
        std::vector<std::vector<RanksOfFrame>> rotations(std::size_t(setup.repeats)), jumps(std::size_t(setup.repeats));
        const auto keepIn = [&](std::vector<RanksOfFrame>& frames) {
            if (!communicator_.isRoot()) return;
            frames.push_back(frame_.stats.ranks);
            onFrame();
        };
        for (auto& rotation : rotations) rotate(group, [&] { keepIn(rotation); });
        for (auto& jump : jumps) leap(group, [&] { keepIn(jump); });
        if (communicator_.isRoot()) {
            samples.rotation = medianFrames(rotations);
            samples.jumps = medianFrames(jumps);
        }
        if (!alsoWall) return;
        FrameGroup freeGroup = makeGroup(balancer, nullptr);
        rotate(freeGroup, [&] {
            if (communicator_.isRoot()) samples.wallMs.push_back(frame_.stats.totalMs);
        });
    }

private:
    FrameGroup makeGroup(const std::string& balancer, std::mutex* turn) const
    {
        RunOptions options = description_.run;
        options.balance = balancer;
        // A group shares its communicator; this one belongs to runRanks().
        return {std::shared_ptr<Communicator>(&communicator_, [](Communicator*) {}), options, turn};
    }

    double frameDeg() const { return orbitDegOf(description_) / description_.output.frames; }

    template <class Keep>
    void rotate(FrameGroup& group, const Keep& keep)
    {
        for (int i = -kWarmUpFrames; i < description_.output.frames; ++i) {
            draw(group, frameDeg() * i);
            if (i >= 0) keep();
        }
    }

    template <class Keep>
    void leap(FrameGroup& group, const Keep& keep)
    {
        double deg = orbitDegOf(description_);
        for (int jump = 0; jump < kJumps; ++jump) {
            for (int i = 0; i < kSettlingFrames; ++i, deg += frameDeg()) draw(group, deg);
            deg += 90 - frameDeg();
            draw(group, deg);
            keep();
            deg += frameDeg();
        }
    }

    void draw(FrameGroup& group, double turnedDeg)
    {
        const CameraOptions camera = orbited(description_.camera, turnedDeg, scene_.boundsWorld);
        const OutputOptions& output = description_.output;
        const FrameRequest request{makeCamera(camera, scene_.boundsWorld, radius_, output.width, output.height),
                                   description_.lic, description_.shading};
        renderFrame(request, scene_, *backend_, group, frame_);
    }

    const SceneDescription& description_;
    const Scene& scene_;
    Communicator& communicator_;
    double radius_;
    std::unique_ptr<Backend> backend_;
    Frame frame_;
};

}  // namespace

std::vector<ScalingSamples> drawOnRanks(const ScalingSetup& setup, const Scene* shared, int cores,
                                        const std::function<void()>& onFrame)
{
    std::vector<ScalingSamples> samples(setup.balancers.size());
    std::mutex turn;
    runRanks(setup.ranks, [&](Communicator& communicator) {
        tbb::task_arena arena(1);
        arena.execute([&] {
            Scene own;
            if (!shared) own = loadTogether(communicator, setup.scene, setup.ranks);
            RankDrawing rank(setup.scene, shared ? *shared : own, communicator);
            for (std::size_t b = 0; b < setup.balancers.size(); ++b)
                rank.measure(setup, setup.balancers[b], turn, setup.ranks <= cores, onFrame, samples[b]);
        });
    });
    return samples;
}

}  // namespace aeolic
