#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "aeolic/renderer.h"
#include "options.h"

namespace aeolic::python {

/// A Renderer for Python: any thread may call it, one after the other, and others run Python meanwhile. The progress
/// function is called with a name of the work and how much of it is done. An exception of the function or of a signal
/// ends the work. Raises RuntimeError if it is called from its own progress function, or in another process than the
/// one it was made in: the threads that draw are not there after a fork.
class Loaded {
public:
    Loaded(const GivenScene& scene, const Texts& given, const Surfaces& surfaces, const pybind11::object& surface,
           const pybind11::object& field, const pybind11::object& progress);
    ~Loaded();
    Loaded(const Loaded&) = delete;
    Loaded& operator=(const Loaded&) = delete;

    void requireFree() const;                                  ///< Raises where no other method can be called.
    Picture render(const std::optional<std::string>& camera);  ///< "azimuth=50": over the scene's own camera.
    Picture renderFrame(int index);
    void saveAnimation(const std::string& path, const pybind11::object& progress);
    void set(const Texts& given, const std::vector<std::string>& withdrawn);  ///< As changed() says.
    void setTime(double moment);
    void setShown(const std::vector<bool>& shown);
    void setData(const pybind11::object& surface, const pybind11::object& field, const pybind11::object& progress);

    using ControlTuple = std::tuple<std::string, std::string, double, double, double>;  ///< Name, kind, lo, hi, value.
    /// Shows the scene from a server in this process, drawn by a thread of its own. Returns its address.
    std::string show(int port, const std::string& title, const std::vector<ControlTuple>& controls);
    void hide();
    double control(const std::string& name);
    void setControl(const std::string& name, double value);

    pybind11::dict info();
    pybind11::list warnings();  ///< What the command line would warn of after the last picture.
    FlowTopology topology();    ///< Of what is shown now.
    FlowTopology separation();  ///< The same.
    EvenSurfaceLines streamlines();
    pybind11::dict buffers(const std::optional<std::string>& camera);
    pybind11::object pick(int x, int y, const std::optional<std::string>& camera);  ///< A dict, or None.
    std::string stats();  ///< JSON, as --stats writes it, of the last picture.
    std::string scene();  ///< JSON, as a scene file.

private:
    struct Shown;
    struct Turn;
    bool isAtWorkHere() const;       ///< In a progress function of this thread.
    SceneInfo infoWithIdle() const;  ///< The renderer's, with what idleOptions() warns of.
    void drawForViewers(Shown& shown);
    void tellViewers();
    void reload(Renderer& renderer, const SceneDescription& scene, const ProgressFunction& report);

    template <class Work>
    auto alone(const Work& work);
    template <class Work>
    void reporting(const pybind11::object& progress, const Work& work);

    const int process_;
    std::timed_mutex mutex_;
    std::atomic<std::thread::id> worker_;  ///< That holds the lock for Python.
    SceneInFile start_;                    ///< Without any option.
    SceneDescription scene_;
    Texts given_;  ///< The options that Python gave, as they are typed.
    std::unique_ptr<Renderer> renderer_;
    bool inMemory_ = false;
    std::unique_ptr<Shown> shown_;
};

}  // namespace aeolic::python
