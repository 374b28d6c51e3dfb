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
#include "engine/scene_overlay.h"
#include "engine/started_frames.h"

namespace aeolic {

/// The content of a renderer: the scene, its backend and ranks, and the frames that are being drawn. Everything is
/// Collective.
struct Renderer::State {
    SceneDescription description;
    std::optional<tbb::global_control> allowed;  // More threads than cores, where asked for.
    tbb::task_arena arena;
    BackendPlan plan;
    int ranksOnHost = 1;  // With which this one shares its memory.
    SceneInfo info;
    FrameStats last;
    double now = 0;              // The moment that the scene is at: an animation's, or info.time.
    std::uint64_t revision = 0;  // Of the data.
    double stepMs = 0;           // Since the frame before, for another moment.
    FrameGroup group;
    CommunicatorAgreement agreement;
    std::optional<LoadedScene> loaded;
    std::unique_ptr<Backend> backend;  // Draws the scene that is loaded.
    SceneOverlay overlay;
    StartedFrames frames;
    StartFolder folder;  // Where files are named from.
    /// The corner in which an animation's legend stays. It holds for these places in a picture of that size.
    struct SteadyLegend {
        Corner corner;
        std::vector<Box> places;
        int width, height;
    };
    std::optional<SteadyLegend> legend;
    std::map<std::string, std::shared_ptr<const ColorMap>> colorMaps;  // By their names; files are read once.

    /// `cores`: this rank's share of its host's.
    State(SceneDescription description, std::shared_ptr<Communicator> ranks, int cores);

    const Scene& scene() const { return loaded->scene(); }
    WholeScene whole() { return {scene(), group.communicator()}; }

    /// The scene and what draws it.
    void load(const Data& memory, ProgressFunction progress);

    /// Another moment, and which is likely to be next.
    void moveTo(double moment, double next);

    /// Others of several surfaces.
    void setShown(const std::vector<bool>& shown);

    /// Other data in memory.
    void setData(const Data& memory, ProgressFunction progress);

    /// Starts a frame, and waits for the oldest one that was started.
    void start(const FrameSpec& spec);
    const StartedFrame& finish();

    Camera cameraOf(const CameraOptions& options) const;

    /// The view of an animation's frame; of the only one, the description's.
    CameraOptions viewOfFrame(int index) const;
    /// LicOptions::phase in an animation's frame. Where streaks flow it makes one turn over all frames.
    double phaseOfFrame(int index) const;

    /// Takes over what the scene and the options tell of themselves, after either has changed. Where it throws, nothing
    /// has changed. Cost: the layout of a figure.
    void tell();

    /// Takes over another look or size. Where it throws, nothing has changed.
    void setLookOf(SceneDescription changed);
    /// Collective. The same, if the group of options `key` is another than before: a view sets it for each frame. All
    /// ranks give the same, for the caller's `call`.
    void setGroup(SceneDescription changed, const char* key, const char* call);

    /// Where the legend stays in the frames of the description's animation, in which it must not jump; nothing for a
    /// still. It goes by the surface at the animation's first moment, so that it is the same whichever frame is drawn
    /// first. Where the corner is not known and the scene is at another moment, it is moved to the first one; `next` is
    /// the one that is drawn then. Cost where it is known: a layout; else that of steadyLegendPlace().
    std::optional<Corner> steadyCorner(double next);
    /// The colour map that the description names. Throws InputError on all ranks where its file is not a colour map.
    std::shared_ptr<const ColorMap> colorMap() { return colorMap(description.shading.colormap); }
    std::shared_ptr<const ColorMap> colorMap(const std::string& name);

    /// [Scene::colors] Those of several surfaces.
    std::vector<std::shared_ptr<const ColorMap>> surfaceColorMaps();

private:
    /// Throws on all ranks where they ask for different frames, or for one that there is not.
    void requireFrame(const FrameSpec& spec);
    /// Starts a frame of that moment. `legend`: the corner that it has in an animation; else where this picture has
    /// room for it.
    void startView(const CameraOptions& camera, double phase, bool gather, double moment, std::optional<Corner> legend);
    /// What the options say now.
    void setLook(StartedFrame& frame);
    void makeBackend();
    void moveBackend(const SceneChange& change);

    void requireRoomForOverlay();
    void namingAsGiven(const std::function<void()>& action);
    std::vector<std::string> sceneWarnings() const;
};

/// Throws InputError where there is no memory for a picture of that size.
void checkImageMemory(int width, int height);

}  // namespace aeolic
