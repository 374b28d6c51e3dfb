#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "aeolic/picture.h"
#include "aeolic/scene_description.h"

namespace aeolic {

/// Where one frame's time went. Milliseconds of wall time, without loading and without writing files.
struct FrameStats {
    double totalMs = 0;
    double projectMs = 0, compositeMs = 0, convolveMs = 0, shadeMs = 0, gatherMs = 0;
    double busyMs = 0;  ///< This process's own CPU time in the compute stages, all threads.
    std::int64_t coveredPixels = 0;
};

/// What is known once the scene is loaded.
struct SceneInfo {
    std::string backend;  ///< cpu | gl
    std::string device;   ///< Processor or GPU name.
    std::string simd;     ///< SIMD target chosen at run time, e.g. AVX3.
    int threads = 1;
    double loadMs = 0;
    std::uint64_t fieldBytes = 0;
    std::uint64_t triangles = 0;
    std::vector<std::string> warnings;  ///< One line each, for the user.
};

/// Called while loading with what is being done and how far it is, 0 to 1.
using ProgressFunction = std::function<void(const char* what, double fraction)>;

/// Draws flow on a surface: load once, then any number of frames. State that does not depend on the camera is kept
/// between frames. Not thread-safe; uses all threads `description.run.threads` allows.
class Renderer {
public:
    /// Loads what the description names. Throws aeolic::InputError (a std::runtime_error) with one line for wrong
    /// input.
    explicit Renderer(SceneDescription description, ProgressFunction progress = {});
    ~Renderer();
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;

    /// One picture from `camera`, everything else as described. Same description, same bytes, whatever the machine's
    /// load and number of threads.
    Picture render(const CameraOptions& camera);

    /// Frame `index` of the described animation: the description's camera turned by its share of the orbit.
    Picture renderFrame(int index);

    /// New LIC or shading options for the frames to come; nothing is loaded again (colorBy stays what was loaded).
    void setLic(const LicOptions& lic);
    void setShading(const ShadingOptions& shading);
    void setSize(int width, int height);

    const SceneInfo& info() const;
    const FrameStats& lastFrame() const;
    const SceneDescription& description() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace aeolic
