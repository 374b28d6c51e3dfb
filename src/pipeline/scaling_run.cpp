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

    void measure(const ScalingSetup& setup, const std::string& balancer, std::mutex& alone, bool alsoWall,
                 const std::function<void()>& onFrame, ScalingSamples& samples)
    {
        RunOptions options = description_.run;
        options.balance = balancer;
        MeasuredFrames frames(scene_, *backend_, communicator_, options, alone);
        const auto keepIn = [&](std::vector<RanksOfFrame>& kept, int repeats) {
            return [&, repeats](const FrameRequest& request, bool counts) {
                RanksOfFrame ranks = frames.draw(request, counts ? repeats : 1);
                if (!counts || !communicator_.isRoot()) return;
                kept.push_back(std::move(ranks));
                onFrame();
            };
        };
        rotate(keepIn(samples.rotation, setup.repeats));
        leap(keepIn(samples.jumps, kJumpRepeats * setup.repeats));
        if (!alsoWall) return;
        // A group shares its communicator; this one belongs to runRanks().
        FrameGroup group(std::shared_ptr<Communicator>(&communicator_, [](Communicator*) {}), options);
        Frame frame;
        rotate([&](const FrameRequest& request, bool counts) {
            renderFrame(request, scene_, *backend_, group, frame);
            if (counts && communicator_.isRoot()) samples.wallMs.push_back(frame.stats.totalMs);
        });
    }

private:
    double frameDeg() const { return orbitDegOf(description_) / description_.output.frames; }

    /// `draw(request, whether the frame counts)`.
    template <class Draw>
    void rotate(const Draw& draw) const
    {
        for (int i = -kWarmUpFrames; i < description_.output.frames; ++i) draw(turned(frameDeg() * i), i >= 0);
    }

    template <class Draw>
    void leap(const Draw& draw) const
    {
        double deg = orbitDegOf(description_);
        for (int jump = 0; jump < kJumps; ++jump) {
            for (int i = 0; i < kSettlingFrames; ++i, deg += frameDeg()) draw(turned(deg), false);
            deg += 90 - frameDeg();
            draw(turned(deg), true);
            deg += frameDeg();
        }
    }

    FrameRequest turned(double deg) const
    {
        const CameraOptions camera = orbited(description_.camera, deg, scene_.boundsWorld);
        const OutputOptions& output = description_.output;
        return {makeCamera(camera, scene_.boundsWorld, radius_, output.width, output.height), description_.lic,
                description_.shading};
    }

    const SceneDescription& description_;
    const Scene& scene_;
    Communicator& communicator_;
    double radius_;
    std::unique_ptr<Backend> backend_;
};

}  // namespace

std::vector<ScalingSamples> drawOnRanks(const ScalingSetup& setup, const Scene* shared, int cores,
                                        const std::function<void()>& onFrame)
{
    std::vector<ScalingSamples> samples(setup.balancers.size());
    std::mutex alone;
    runRanks(setup.ranks, [&](Communicator& communicator) {
        tbb::task_arena arena(1);
        arena.execute([&] {
            Scene own;
            if (!shared) own = loadTogether(communicator, setup.scene, setup.ranks);
            RankDrawing rank(setup.scene, shared ? *shared : own, communicator);
            for (std::size_t b = 0; b < setup.balancers.size(); ++b)
                rank.measure(setup, setup.balancers[b], alone, setup.ranks <= cores, onFrame, samples[b]);
        });
    });
    return samples;
}

}  // namespace aeolic
