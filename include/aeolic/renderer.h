#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "aeolic/picture.h"
#include "aeolic/scene_description.h"

namespace aeolic {

/// What one stage of a frame took one rank.
struct StageStats {
    double busyMs = 0;  ///< CPU time, all threads, waiting not counted.
    std::int64_t sentBytes = 0, sentMessages = 0;
    std::int64_t receivedBytes = 0, receivedMessages = 0;
};

/// One rank's part of a frame.
struct RankStats {
    int rank = 0;
    int firstRow = 0, rows = 0;          ///< Its stripe.
    int guardAbove = 0, guardBelow = 0;  ///< Rows beyond it that its traces may read.
    std::int64_t pixels = 0;             ///< Covered, of the stripe.
    std::int64_t guardPixels = 0;        ///< Covered, of the guard, where that is drawn again.
    StageStats balance, project, composite, convolve, shade, gather;
    double busyMs = 0;  ///< Of all stages together, and so on.
    std::int64_t sentBytes = 0, sentMessages = 0;
};

/// Where one frame's time went. Milliseconds of wall time, without loading and without writing files.
struct FrameStats {
    double totalMs = 0;  ///< The sum of those below. Of a GPU they are its own times where it drew while this
                         ///< process did something else.
    double balanceMs = 0, projectMs = 0, compositeMs = 0, convolveMs = 0, shadeMs = 0, gatherMs = 0;
    double busyMs = 0;  ///< This process's own CPU time in the compute stages, all threads.
    std::int64_t coveredPixels = 0;
    std::vector<RankStats> ranks;  ///< By rank.
    double time = 0;               ///< The moment shown, where the scene changes in time.
    double stepMs = 0;             ///< What it took beforehand to bring that moment about; not part of totalMs.
};

/// What is known once the scene is loaded.
struct SceneInfo {
    std::string backend;    ///< cpu | gl
    std::string device;     ///< Processor or GPU name.
    std::string simd;       ///< SIMD target chosen at run time, e.g. AVX3.
    std::string unusedGpu;  ///< Why `auto` draws on the processor, one line; else empty.
    int threads = 1;        ///< Of this rank.
    int ranks = 1;
    double loadMs = 0;
    std::uint64_t fieldBytes = 0;                ///< Of this rank.
    std::vector<std::int64_t> fieldBytesOfRank;  ///< Of every rank.
    std::uint64_t triangles = 0;
    std::vector<double> times;  ///< Of all steps of surface and field, sorted; for built-ins that change, moments over
                                ///< a period. Empty where nothing changes in time.
    double time = 0;            ///< The moment shown.
    std::vector<std::string> warnings;  ///< One line each, for the user. setTime() may add some.
};

/// Rows of a picture, as the rank that finished them holds them.
struct PictureStripe {
    Picture rows;
    int firstRow = 0;
    int height = 0;  ///< Of the whole picture.
};

/// Called while loading with what is being done and how far it is, 0 to 1.
using ProgressFunction = std::function<void(const char* what, double fraction)>;

class Communicator;
struct Scene;

/// Collective. Joins the ranks this process was started with by an MPI launcher (mpirun, srun …); alone it is rank 0 of
/// 1, and no MPI is started. Throws aeolic::InputError where launcher and build do not fit each other.
std::shared_ptr<Communicator> joinRanks();

/// Draws flow on a surface: load once, then any number of frames. State that does not depend on the camera is kept
/// between frames. Not thread-safe; uses all threads `description.run.threads` allows.
///
/// With several ranks everything but info(), lastFrame() and description() is Collective: every rank makes the same
/// calls with the same arguments. Pictures come out on rank 0; elsewhere they are empty.
class Renderer {
public:
    /// Loads what the description names. Throws aeolic::InputError (a std::runtime_error) with one line for wrong
    /// input.
    explicit Renderer(SceneDescription description, ProgressFunction progress = {});

    /// The same, drawing together with other ranks.
    Renderer(SceneDescription description, std::shared_ptr<Communicator> ranks, ProgressFunction progress = {});
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// One picture from `camera`, everything else as described. Same description, same bytes, whatever the machine's
    /// load and number of threads.
    Picture render(const CameraOptions& camera);

    /// The same picture without gathering it: every rank gets the rows it finished, which may be none.
    PictureStripe renderStripe(const CameraOptions& camera);

    /// The same in two halves, for frames that follow each other. On a GPU as many as framesInFlight() may be started
    /// before the first of them is finished, which draws the next while the pixels of the one before are on their way
    /// and are dealt with; a processor draws in start(), and has one. finish() gives the oldest, as everything was when
    /// it was started, and lastFrame() is of that one. Throws std::logic_error where too many are started, or none.
    int framesInFlight() const;
    void start(const CameraOptions& camera);
    void startFrame(int index);  ///< See renderFrame().
    /// `kept`: a picture no longer needed, the last one for instance, for its memory; new memory for a large picture
    /// takes longer than to fill it.
    Picture finish(Picture kept = {});
    /// … as renderStripe().
    void startStripe(const CameraOptions& camera);
    PictureStripe finishStripe(PictureStripe kept = {});

    /// Another moment, in the data's own unit of time, for the frames to come: between two steps the data are
    /// interpolated linearly where grid and mesh allow, else the earlier step is shown; outside of info().times the
    /// nearest end. Camera fit, noise, colour range and largest vector stay those of the first moment (of the last,
    /// where the first is at rest), so a moment's picture has the same bytes however it was come by. Only what depends
    /// on time is loaded: nothing where its steps are in memory; the one likely to be next is read on another thread.
    /// Nothing happens where nothing changes in time. Takes the place of the description's moment or range. Throws
    /// aeolic::InputError as the constructor does, and the moment stays as it was.
    void setTime(double moment);

    /// Frame `index` of the described animation: the description's camera turned by its share of the orbit, at its
    /// share of the described range in time.
    Picture renderFrame(int index);

    /// New LIC or shading options for the frames to come; nothing is loaded again (colorBy stays what was loaded).
    void setLic(const LicOptions& lic);
    void setShading(const ShadingOptions& shading);
    void setSize(int width, int height);

    const SceneInfo& info() const;
    const FrameStats& lastFrame() const;
    const SceneDescription& description() const;

    /// What was loaded: for the parts of Aeolic itself.
    const Scene& scene() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace aeolic
