#include "pipeline/scaling_run.h"

#include <tbb/task_arena.h>

#include <memory>
#include <mutex>
#include <optional>

#include "cluster/serial_communicator.h"
#include "cluster/thread_communicator.h"
#include "pipeline/frame.h"
#include "pipeline/load_together.h"
#include "pipeline/unify.h"
#include "render/backend.h"

namespace aeolic {
namespace {

/// A group shares its communicator; this one belongs to somebody else.
std::shared_ptr<Communicator> borrowed(Communicator& communicator)
{
    return {&communicator, [](Communicator*) {}};
}

/// The camera's way, the same for all who draw.
class Camera {
public:
    Camera(const SceneDescription& description, const Bounds& boundsWorld, double radius)
        : description_(description), boundsWorld_(boundsWorld), radius_(radius)
    {
    }

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

private:
    double frameDeg() const { return orbitDegOf(description_) / description_.output.frames; }

    FrameRequest turned(double deg) const
    {
        const CameraOptions camera = orbited(description_.camera, deg, boundsWorld_);
        const OutputOptions& output = description_.output;
        return {makeCamera(camera, boundsWorld_, radius_, output.width, output.height), description_.lic,
                description_.shading};
    }

    const SceneDescription& description_;
    const Bounds& boundsWorld_;
    double radius_;
};

RunOptions balancedBy(RunOptions options, const std::string& balancer)
{
    options.balance = balancer;
    return options;
}

/// A rank under one balancer.
class Drawing {
public:
    Drawing(const Scene& scene, Backend& backend, Communicator& communicator, const RunOptions& options,
            std::mutex& alone)
        : scene_(scene),
          backend_(backend),
          measured_(scene, backend, communicator, options, alone),
          group_(borrowed(communicator), options)
    {
    }

    RanksOfFrame measure(const FrameRequest& request, int repeats) { return measured_.draw(request, repeats); }

    double wallMs(const FrameRequest& request)
    {
        renderFrame(request, scene_, backend_, group_, frame_);
        return frame_.stats.totalMs;
    }

private:
    const Scene& scene_;
    Backend& backend_;
    MeasuredFrames measured_;
    FrameGroup group_;  // Of frames that all ranks draw at once.
    Frame frame_;
};

/// One rank that draws whole pictures while the others wait.
class OneRank {
public:
    OneRank(const SceneDescription& description, const Scene& scene)
        : backend_(makeBackend(description.run.backend, scene, {description.run.device, 0})),
          drawing_(scene, *backend_, *communicator_, balancedBy(description.run, "static"), alone_)
    {
    }

    Drawing& drawing() { return drawing_; }

private:
    std::unique_ptr<Communicator> communicator_ = makeSerialCommunicator();
    std::mutex alone_;
    std::unique_ptr<Backend> backend_;
    Drawing drawing_;
};

/// One of the ranks: a scene, a backend, and the frames they draw together with the others.
class RankDrawing {
public:
    /// `isShared`: the scene is every rank's, so that one could draw it alone.
    RankDrawing(const ScalingSetup& setup, const Scene& scene, bool isShared, Communicator& communicator,
                std::mutex& alone)
        : setup_(setup),
          communicator_(communicator),
          camera_(setup.scene, scene.boundsWorld, reachOf(communicator, scene).radius),
          backend_(makeBackend(setup.scene.run.backend, scene, {setup.scene.run.device, 0}))
    {
        for (const std::string& balancer : setup.balancers)
            drawings_.push_back(std::make_unique<Drawing>(scene, *backend_, communicator,
                                                          balancedBy(setup.scene.run, balancer), alone));
        if (isShared && communicator.isRoot() && communicator.size() > 1) one_.emplace(setup.scene, scene);
    }

    void measure(bool alsoWall, const std::function<void()>& onFrame, ScalingSamples& samples)
    {
        const auto keep = [&](std::vector<RanksOfFrame>& kept, RanksOfFrame ranks) {
            if (!communicator_.isRoot()) return;
            kept.push_back(std::move(ranks));
            onFrame();
        };
        camera_.rotate([&](const FrameRequest& request, bool counts) {
            for (std::size_t b = 0; b < drawings_.size(); ++b) {
                RanksOfFrame ranks = drawings_[b]->measure(request, counts ? setup_.repeats : 1);
                if (counts) keep(samples.of[b].rotation, std::move(ranks));
            }
            byOneRank([&](Drawing& one) {
                RanksOfFrame alone = one.measure(request, counts ? setup_.repeats : 1);
                if (counts) samples.alone.push_back(std::move(alone));
            });
        });
        camera_.leap([&](const FrameRequest& request, bool counts) {
            for (std::size_t b = 0; b < drawings_.size(); ++b) {
                RanksOfFrame ranks = drawings_[b]->measure(request, counts ? kJumpRepeats * setup_.repeats : 1);
                if (counts) keep(samples.of[b].jumps, std::move(ranks));
            }
        });
        if (alsoWall) measureWall(samples);
    }

private:
    void measureWall(ScalingSamples& samples)
    {
        camera_.rotate([&](const FrameRequest& request, bool counts) {
            for (std::size_t b = 0; b < drawings_.size(); ++b) {
                const double wallMs = drawings_[b]->wallMs(request);
                if (counts && communicator_.isRoot()) samples.of[b].wallMs.push_back(wallMs);
            }
            byOneRank([&](Drawing& one) {
                const double wallMs = one.wallMs(request);
                if (counts) samples.aloneWallMs.push_back(wallMs);
            });
        });
    }

    /// Collective. Nobody else computes meanwhile.
    template <class Body>
    void byOneRank(const Body& body)
    {
        communicator_.barrier();
        if (one_) body(one_->drawing());
        communicator_.barrier();
    }

    const ScalingSetup& setup_;
    Communicator& communicator_;
    Camera camera_;
    std::unique_ptr<Backend> backend_;
    std::vector<std::unique_ptr<Drawing>> drawings_;  // By balancer.
    std::optional<OneRank> one_;
};

}  // namespace

ScalingSamples drawOnRanks(const ScalingSetup& setup, const Scene* shared, int cores,
                           const std::function<void()>& onFrame)
{
    ScalingSamples samples;
    samples.of.resize(setup.balancers.size());
    std::mutex alone;
    runRanks(setup.ranks, [&](Communicator& communicator) {
        tbb::task_arena arena(1);
        arena.execute([&] {
            Scene own;
            if (!shared) own = loadTogether(communicator, setup.scene, setup.ranks);
            RankDrawing rank(setup, shared ? *shared : own, shared != nullptr, communicator, alone);
            rank.measure(setup.ranks <= cores, onFrame, samples);
        });
    });
    return samples;
}

}  // namespace aeolic
