#include "scaling/samples.h"
#include "description/choices.h"

#include <tbb/task_arena.h>

#include <memory>
#include <mutex>
#include <optional>

#include "cluster/comm/communicator.h"
#include "cluster/composite/communicator_agreement.h"
#include "data/load/loaded_scene.h"
#include "engine/frame.h"
#include "ranks/thread_communicator.h"
#include "render/backend.h"

namespace aeolic {
namespace {

/// A group shares its communicator; this communicator belongs to somebody else.
std::shared_ptr<Communicator> borrowed(Communicator& communicator)
{
    return {&communicator, [](Communicator*) {}};
}

/// A place of the camera.
struct Turn {
    double deg = 0;  ///< Along its orbit.
    bool counts = false;
};

double frameDeg(const SceneDescription& scene)
{
    return orbitDegOf(scene) / scene.output.frames;
}

std::vector<Turn> rotation(const SceneDescription& scene)
{
    std::vector<Turn> turns;
    for (int i = -kWarmUpFrames; i < scene.output.frames; ++i) turns.push_back({frameDeg(scene) * i, i >= 0});
    return turns;
}

std::vector<Turn> leaps(const SceneDescription& scene)
{
    std::vector<Turn> turns;
    double deg = orbitDegOf(scene);
    for (int jump = 0; jump < kJumps; ++jump) {
        for (int i = 0; i < kSettlingFrames; ++i, deg += frameDeg(scene)) turns.push_back({deg, false});
        deg += 90 - frameDeg(scene);
        turns.push_back({deg, true});
        deg += frameDeg(scene);
    }
    return turns;
}

/// The camera's way, the same for all who draw.
class CameraPath {
public:
    CameraPath(const SceneDescription& description, const Bounds& boundsWorld, double radius)
        : description_(description), boundsWorld_(boundsWorld), radius_(radius)
    {
    }

    FrameRequest at(const Turn& turn) const
    {
        const CameraOptions camera = orbited(description_.camera, turn.deg, boundsWorld_);
        const OutputOptions& output = description_.output;
        return {makeCamera(camera, boundsWorld_, radius_, output.width, output.height), description_.lic,
                description_.shading};
    }

private:
    const SceneDescription& description_;
    const Bounds& boundsWorld_;
    double radius_;
};

RunOptions balancedBy(RunOptions options, const std::string& balancer)
{
    options.balance = choiceNamed<Balance>(balancer).value();
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
    FrameGroup group_;  // For frames that all ranks draw at once.
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

/// One of the ranks: a scene, a backend, and the frames that it draws together with the others. All of it is
/// collective.
class RankDrawing {
public:
    /// `kept`: where one of the ranks puts the measurements; null for the others.
    RankDrawing(const ScalingSetup& setup, const SceneDescription& description, const Scene& scene,
                Communicator& communicator, std::mutex& alone, ScalingSamples* kept)
        : repeats_(setup.repeats),
          communicator_(communicator),
          camera_(description, scene.boundsWorld, scene.reach.radius),
          backend_(makeBackend(description.run.backend, scene, {description.run.device, 0})),
          kept_(kept)
    {
        for (const std::string& balancer : setup.balancers)
            drawings_.push_back(std::make_unique<Drawing>(scene, *backend_, communicator,
                                                          balancedBy(description.run, balancer), alone));
        if (kept && setup.besideOne && setup.ranks > 1) one_.emplace(description, scene);
    }

    /// One picture of the rotation. `onFrame` is called after each frame that counts.
    template <class OnFrame>
    void rotate(const Turn& turn, const OnFrame& onFrame)
    {
        draw(turn, repeats_, &BalancerSamples::rotation, onFrame);
        byOneRank([&](Drawing& one) {
            RanksOfFrame alone = one.measure(camera_.at(turn), turn.counts ? repeats_ : 1);
            if (turn.counts) kept_->alone.push_back(std::move(alone));
        });
    }

    template <class OnFrame>
    void leap(const Turn& turn, const OnFrame& onFrame)
    {
        draw(turn, kJumpRepeats * repeats_, &BalancerSamples::jumps, onFrame);
    }

    /// One picture of the rotation, drawn by all ranks at once.
    void measureWall(const Turn& turn)
    {
        const FrameRequest request = camera_.at(turn);
        for (std::size_t b = 0; b < drawings_.size(); ++b) {
            const double wallMs = drawings_[b]->wallMs(request);
            if (turn.counts && kept_) kept_->of[b].wallMs.push_back(wallMs);
        }
        byOneRank([&](Drawing& one) {
            const double wallMs = one.wallMs(request);
            if (turn.counts) kept_->aloneWallMs.push_back(wallMs);
        });
    }

private:
    template <class OnFrame>
    void draw(const Turn& turn, int repeats, std::vector<RanksOfFrame> BalancerSamples::*kept, const OnFrame& onFrame)
    {
        const FrameRequest request = camera_.at(turn);
        for (std::size_t b = 0; b < drawings_.size(); ++b) {
            RanksOfFrame ranks = drawings_[b]->measure(request, turn.counts ? repeats : 1);
            if (!turn.counts || !kept_) continue;
            (kept_->of[b].*kept).push_back(std::move(ranks));
            onFrame();
        }
    }

    /// Nobody else computes meanwhile.
    template <class Body>
    void byOneRank(const Body& body)
    {
        communicator_.barrier();
        if (one_) body(one_->drawing());
        communicator_.barrier();
    }

    int repeats_;
    Communicator& communicator_;
    CameraPath camera_;
    std::unique_ptr<Backend> backend_;
    std::vector<std::unique_ptr<Drawing>> drawings_;  // By balancer.
    std::optional<OneRank> one_;
    ScalingSamples* kept_;
};

}  // namespace

std::vector<ScalingSamples> drawOnRanks(const ScalingSetup& setup, const Scene& shared, int cores,
                                        const std::function<void(std::size_t)>& onFrame)
{
    std::vector<ScalingSamples> samples(setup.scenes.size());
    for (ScalingSamples& of : samples) of.of.resize(setup.balancers.size());
    std::mutex alone;
    runRanks(setup.ranks, [&](Communicator& communicator) {
        tbb::task_arena arena(1);
        arena.execute([&] {
            std::vector<Scene> own(setup.scenes.size());
            std::vector<std::unique_ptr<RankDrawing>> drawings;
            for (std::size_t i = 0; i < own.size(); ++i) {
                const SceneDescription& description = setup.scenes[i];
                const bool bricked = description.run.bricks == BrickChoice::on;
                if (bricked) {
                    CommunicatorAgreement agreement(communicator);
                    own[i] = loadScene(description, splitOf(description, agreement, setup.ranks), agreement);
                }
                drawings.push_back(std::make_unique<RankDrawing>(setup, description, bricked ? own[i] : shared,
                                                                 communicator, alone,
                                                                 communicator.isRoot() ? &samples[i] : nullptr));
            }
            const auto inTurn = [&](const std::vector<Turn>& turns, const auto& draw) {
                for (const Turn& turn : turns)
                    for (std::size_t i = 0; i < drawings.size(); ++i) draw(*drawings[i], turn, [&] { onFrame(i); });
            };
            const std::vector<Turn> around = rotation(setup.scenes.front()), jumps = leaps(setup.scenes.front());
            inTurn(around, [](auto& drawing, const Turn& turn, const auto& told) { drawing.rotate(turn, told); });
            inTurn(jumps, [](auto& drawing, const Turn& turn, const auto& told) { drawing.leap(turn, told); });
            if (setup.ranks > cores) return;
            inTurn(around, [](auto& drawing, const Turn& turn, const auto&) { drawing.measureWall(turn); });
        });
    });
    return samples;
}

}  // namespace aeolic
