#pragma once

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "aeolic/renderer.h"
#include "base/start_folder.h"
#include "cluster/composite/communicator_agreement.h"
#include "data/load/loaded_scene.h"
#include "engine/backend_together.h"
#include "engine/frame_group.h"
#include "engine/started_frames.h"

namespace aeolic {

/// What a renderer holds: the scene, who draws it by what, and the frames that are being drawn. Everything is
/// Collective.
struct Renderer::State {
    SceneDescription description;
    std::optional<tbb::global_control> allowed;  // More threads than cores, where asked for.
    tbb::task_arena arena;
    GpuChoice gpu;
    BackendPlan plan;
    SceneInfo info;
    FrameStats last;
    std::uint64_t revision = 0;  // Of the data.
    double stepMs = 0;           // Since the frame before, for another moment.
    FrameGroup group;
    CommunicatorAgreement agreement;
    std::optional<LoadedScene> loaded;
    std::unique_ptr<Backend> backend;  // Draws the scene that is loaded.
    StartedFrames frames;
    StartFolder folder;  // Where files are named from.
    std::optional<std::size_t> legendPlace;
    std::map<std::string, std::shared_ptr<const ColorMap>> colorMaps;  // By their names; files are read once.

    /// `cores`: this rank's share of its host's.
    State(SceneDescription description, std::shared_ptr<Communicator> ranks, int cores);

    const Scene& scene() const { return loaded->scene(); }

    /// Names of files, colour maps' too, mean from now on what they mean to `other`.
    void nameAs(const State& other);

    /// The scene and what draws it. `ranksOnHost`: with which this one shares its memory.
    void load(int ranksOnHost, const Data& memory, ProgressFunction progress);

    /// Another moment, and which is likely to be next.
    void moveTo(double moment, double next);

    /// Others of several surfaces.
    void setShown(const std::vector<bool>& shown);

    /// Other data in memory.
    void setData(const Data& memory, ProgressFunction progress);

    /// Starts a frame, to be gathered or not; finish() waits for the oldest, for the caller's `call`.
    void start(const CameraOptions& camera, bool gather);
    const StartedFrame& finish(const char* call);

    /// The view of an animation's frame; of the only one, the description's.
    CameraOptions viewOfFrame(int index) const;

    /// Takes over what the scene and the options tell of themselves, after either has changed.
    void tell();

    /// In an animation the legend must not jump: finds the corner for all of it, unless that is known. It is to be
    /// known before the scene moves on from its first moment, so that it is the same whichever frame is drawn first.
    void placeLegend();
    /// The options changed, or the data.
    void forgetLegend() { legendPlace.reset(); }

    /// What the description's shading names. Throws InputError on all ranks where it is a file that is none.
    std::shared_ptr<const ColorMap> colorMap() { return colorMap(description.shading.colorMap); }
    std::shared_ptr<const ColorMap> colorMap(const std::string& name);

    /// [Scene::colors] Those of several surfaces.
    std::vector<std::shared_ptr<const ColorMap>> surfaceColorMaps();

private:
    Camera cameraOf(const CameraOptions& options) const;
    /// What the options say now.
    void setLook(StartedFrame& frame);
    void makeBackend();
    void moveBackend(const SceneChange& change);

    void namingAsGiven(const std::function<void()>& action);
    void takeWarnings();
};

/// Throws InputError where there is no memory for a picture of that size.
void checkImageMemory(int width, int height);

}  // namespace aeolic
