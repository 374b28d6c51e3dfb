#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "aeolic/buffers.h"
#include "aeolic/data.h"
#include "aeolic/pick.h"
#include "aeolic/picture.h"
#include "aeolic/scene_description.h"
#include "aeolic/streamlines.h"
#include "aeolic/topology.h"

namespace aeolic {

/// The cost of one stage of a frame, on one rank.
struct StageStats {
    double busyMs = 0;  ///< CPU time of all threads. Waiting for other ranks is not counted.
    double workMs = 0;  ///< Wall time without waiting for other ranks: with more threads it is less. Balancing uses it.
    std::int64_t sentBytes = 0, sentMessages = 0;
    std::int64_t receivedBytes = 0, receivedMessages = 0;
};

/// One rank's part of a frame.
struct RankStats {
    int rank = 0;
    int firstRow = 0, rows = 0;          ///< Its stripe.
    int guardAbove = 0, guardBelow = 0;  ///< Rows beyond the stripe that the stripe's traces may read.
    std::int64_t pixels = 0;             ///< Pixels of the stripe that the surface covers.
    std::int64_t guardPixels = 0;        ///< Covered guard pixels that this rank drew itself.
    StageStats balance, project, composite, convolve, shade, gather;
    double busyMs = 0;                             ///< The sum over all stages.
    std::int64_t sentBytes = 0, sentMessages = 0;  ///< The sums over all stages.
};

/// Where one frame's time went. Milliseconds of wall time, without loading and without writing files.
struct FrameStats {
    /// The sum of the stages below. A GPU draws while this process does something else: its stages are then measured by
    /// its own clock.
    double totalMs = 0;
    double balanceMs = 0, projectMs = 0, compositeMs = 0, convolveMs = 0, shadeMs = 0, gatherMs = 0;
    double busyMs = 0;  ///< CPU time of all threads of this process in the compute stages.
    std::int64_t coveredPixels = 0;
    std::vector<RankStats> ranks;  ///< One entry a rank, in their order.
    double time = 0;               ///< The moment shown, where the scene changes in time.
    double stepMs = 0;  ///< The time for loading and interpolating that moment, before the frame; not part of totalMs.
};

/// What is known once the scene is loaded.
struct SceneInfo {
    std::string backend;    ///< cpu | gl
    std::string device;     ///< Processor or GPU name.
    std::string simd;       ///< SIMD target chosen at run time, e.g. AVX3.
    std::string unusedGpu;  ///< Why `auto` draws on the processor, one line; else empty.
    int threads = 1;        ///< Threads of this rank.
    int ranks = 1;
    std::vector<int> threadsOfRank;  ///< Those of every rank, which may differ.
    double loadMs = 0;
    std::uint64_t fieldBytes = 0;                ///< Memory of the field on this rank.
    std::vector<std::int64_t> fieldBytesOfRank;  ///< The same number for every rank.
    std::uint64_t triangles = 0;
    /// The moments of all steps of surface and field, sorted. A built-in that changes gives moments over one period.
    /// Empty where nothing changes in time.
    std::vector<double> times;
    double time = 0;                    ///< The moment of frames whose spec has a camera.
    std::vector<std::string> warnings;  ///< One line each, for the user. setTime() may add some, setData() renews them.
    /// How many of them, the first ones, are about the data; the others are about what a picture's options and size ask
    /// for.
    std::size_t dataWarnings = 0;
};

/// One frame of the animation that a description tells of: [0, output.frames). Its camera is the description's, turned
/// by this frame's share of the orbit. Its moment is this frame's share of `time.range`, whatever setTime() has set, or
/// that of setTime() where there is no range. A still is an animation of one frame.
struct AnimationFrame {
    int index = 0;
};

/// What a frame is: `{}` is the picture that the description tells of, or the first one of its animation; `{camera}`
/// the scene from another place, at the moment that info().time tells; `{AnimationFrame{3}}` a part of the animation.
struct FrameSpec {
    std::variant<AnimationFrame, CameraOptions> view = AnimationFrame{};
    /// With several ranks: true: rank 0 gets the whole picture, and the others an empty one. false: every rank keeps
    /// the rows that it finished, perhaps none. The bytes are the same.
    bool gather = true;
};

/// A finished frame, or the rows of it that this rank has.
struct DrawnFrame : Picture {
    int firstRow = 0;     ///< Where the rows begin in the whole picture; 0 where that is gathered.
    int wholeHeight = 0;  ///< Rows of the whole picture.
    /// Where the legends stand, in pixels of the whole picture: x, y, width, height. Nothing where there is none. On
    /// all ranks the same, where the picture is not gathered.
    std::optional<std::array<int, 4>> legend;
};

/// Is called while the scene loads, with a name of the work and how much of it is done (0 to 1).
using ProgressFunction = std::function<void(const char* what, double fraction)>;

class Communicator;
class RendererInternals;

/// Collective. Joins the ranks that an MPI launcher (mpirun, srun …) started together with this process. A process that
/// was started alone is rank 0 of 1, and MPI is not started. Throws aeolic::InputError if the launcher does not fit
/// this build.
std::shared_ptr<Communicator> joinRanks();

/// Collective. The ranks of the caller's own communicator: `mpiCommunicator` is the address of an MPI_Comm, of which a
/// duplicate is made, so that messages never meet. It is freed with the last holder, before MPI_Finalize. Throws
/// aeolic::InputError where MPI was not started or has ended, for MPI_COMM_NULL and an intercommunicator, or for fewer
/// threads than MPI_THREAD_SERIALIZED: stages run on several threads, of which one at a time calls MPI.
std::shared_ptr<Communicator> joinRanks(const void* mpiCommunicator);

/// Draws flow on a surface. It loads once and then draws any number of frames. Work independent of the camera is
/// kept between frames. Not thread-safe. It uses as many threads as `description.run.threads` allows.
///
/// With several ranks every method is Collective, except info(), lastFrame(), description() and framesInFlight(): every
/// rank makes the same calls with the same arguments. Rank 0 gets the pictures that are gathered; on other ranks they
/// are empty. Where ranks make different calls, or give them different options, all throw the same aeolic::InputError,
/// which says what differs; nothing has changed then, and all can go on. A rank that makes a call while another makes
/// none waits for it forever: that cannot be told.
///
/// A renderer that was moved into another one can be destroyed and assigned to; everything else throws
/// std::logic_error.
class Renderer {
public:
    /// Loads what the description names. Throws aeolic::InputError (a std::runtime_error) with one line for wrong
    /// input.
    explicit Renderer(SceneDescription description, ProgressFunction progress = {});

    /// Loads and draws together with other ranks. Throws as the constructor above, on all ranks.
    Renderer(SceneDescription description, std::shared_ptr<Communicator> ranks, ProgressFunction progress = {});

    /// Draws data in the caller's memory: `data` stands in the place of `description.surface.spec` and
    /// `description.field.spec`. aeolic/data.h says how long the memory has to stay. With several ranks every rank
    /// gives its own piece of the surface, and the whole grid. Throws as the other constructors do: for wrong sizes,
    /// for indices that point nowhere, and where no triangle is left, with the text that a file would get.
    Renderer(SceneDescription description, const Data& data, ProgressFunction progress = {});
    Renderer(SceneDescription description, const Data& data, std::shared_ptr<Communicator> ranks,
             ProgressFunction progress = {});
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// Draws one frame: start() and finish(). The same description gives the same bytes, on any number of threads and
    /// ranks.
    DrawnFrame render(const FrameSpec& spec = {}, Picture kept = {});

    /// The two halves of a frame, for frames that follow each other. Up to framesInFlight() frames may be started
    /// before the first of them is finished. A GPU then draws the next frame while the pixels of the one before are on
    /// their way. A processor draws in start(), and has one frame in flight. Throws InputError for a camera that no
    /// description could have, for a frame that the animation has not, and where a moment cannot be loaded;
    /// std::logic_error if too many frames are started.
    void start(const FrameSpec& spec = {});
    /// Gives the oldest frame that was started, as everything was then; lastFrame() then tells of that frame. `kept`: a
    /// picture that is no longer needed, for instance the last one. Its memory is used again: to get new memory for a
    /// large picture takes longer than to fill it. Throws std::logic_error if no frame is started.
    DrawnFrame finish(Picture kept = {});
    int framesInFlight() const;  ///< How many frames may be started and not finished: 1 on processors, 2 on GPUs.

    /// Sets the moment of the frames to come, in the data's own unit of time. Between two steps the data are
    /// interpolated linearly if grid and mesh are the same at both; otherwise the earlier step is shown. Outside of
    /// info().times the nearest end is shown. Camera fit, noise, colour range and largest vector stay those of the
    /// first moment, or of the last one if nothing moves at the first. So the picture of a moment has the same bytes,
    /// whatever was shown before. Only what depends on time is loaded, and only if it is not in memory; another thread
    /// reads the step that is likely to be next. Nothing happens if nothing changes in time. This moment replaces the
    /// description's. An animation keeps its range: a description cannot hold both, so description() goes on telling
    /// the range, and info().time the moment; reload() of it begins at the range's first. Throws aeolic::InputError
    /// like the constructor; the moment then stays as it was.
    void setTime(double moment);

    /// Which of several surfaces are drawn in the frames to come, one switch for each of `description.surfaces`. All
    /// stay loaded; camera fit and ranges stay. Throws aeolic::InputError for another number of switches. Cost: a copy
    /// of the drawn surfaces.
    void setShown(const std::vector<bool>& shown);

    /// Takes other data for the frames to come: what `data` holds, while all else stays and is not loaded again. Only
    /// data in memory from the start can be replaced; points, triangles, samples and the grid may all be others,
    /// but the arrays that are drawn have the same names. As after setTime(), camera fit, noise, colour range and
    /// largest vector stay those of the first data, so that nothing jumps: set `colorRange` where the first data are at
    /// rest. Throws aeolic::InputError like the constructor; everything then stays as it was.
    void setData(const Data& data, ProgressFunction progress = {});

    /// Loads another scene from files in the place of this one, on the same ranks, as a new renderer would. Names of
    /// files are still relative to the folder that the process was in when this one was made, and colour maps that were
    /// read stay. Throws aeolic::InputError like the constructor; everything then stays as it was.
    void reload(SceneDescription description, ProgressFunction progress = {});

    /// Sets the LIC options, shading options or size of the frames to come. Nothing is loaded again: colorBy stays what
    /// was loaded. A colour map's file is read once, from the folder that the process is in then. They throw
    /// aeolic::InputError, and change nothing, for options that no description could have, for a file that is not a
    /// colour map, and where there is no memory for a picture of that size.
    void setLic(const LicOptions& lic);
    void setShading(const ShadingOptions& shading);
    void setSize(int width, int height);

    /// The critical points of the flow along the surface that is shown now, and the lines that leave its saddles, by
    /// `shading.persistence`: what `shading.overlay` draws. The same on all ranks, and from any number of ranks and
    /// threads. A surface in pieces is gathered on every rank for that; InputError where it has no memory for it. Cost:
    /// O(triangles), parallel, each time.
    FlowTopology topology();

    /// The open lines of separation and attachment of the flow along the surface that is shown now, by
    /// `shading.persistence`: lines alone, without points. The rest is as for topology(). Cost: that of some 4,000
    /// streamlines, parallel, each time.
    FlowTopology separation();

    /// Streamlines on the whole surface that is shown now, as far apart in the world as `shading.overlay` says, else 24
    /// pixels, where the surface's middle is in the description's first view. The rest is as for topology(). Cost:
    /// O(triangles), parallel, and that of the lines, each time.
    EvenSurfaceLines streamlines();

    /// What the picture shows at pixel (x, y), counted from the upper left; nothing on the background. `camera`:
    /// another view than the description's first. The moment is the one that info().time tells. The same on all ranks,
    /// and from any number of them. Throws InputError for a pixel outside of the picture. Cost: O(triangles), parallel;
    /// nothing is drawn. Of a surface in pieces 8 bytes a triangle travel.
    std::optional<PickedPlace> pick(int x, int y, const std::optional<CameraOptions>& camera = {});

    /// What all pixels show, as numbers: those of the picture that render({*camera}) gives, or, without a camera,
    /// render(). Rank 0 gets them, and other ranks an empty picture. Throws as start() does; std::logic_error while a
    /// frame is started and not finished. Cost: that of a frame, and of 32 bytes a pixel on their way.
    PictureBuffers buffers(const std::optional<CameraOptions>& camera = {});

    const SceneInfo& info() const;
    const FrameStats& lastFrame() const;
    const SceneDescription& description() const;

private:
    friend class RendererInternals;  // For Aeolic's own programs: src/engine/renderer_internals.h.
    struct State;
    Renderer(SceneDescription description, const Data& data, std::shared_ptr<Communicator> ranks,
             ProgressFunction progress, const State* before);
    State& held() const;
    std::unique_ptr<State> state_;
};

}  // namespace aeolic
