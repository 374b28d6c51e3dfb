#include "loaded.h"

#include <pybind11/stl.h>
#include <unistd.h>

#include <stdexcept>

#include "description/scene_json.h"
#include "description/scene_text.h"
#include "description/validate.h"
#include "memory.h"
#include "output/stats_json.h"

namespace aeolic::python {

namespace py = pybind11;

namespace {

/// What Python raised while C++ was at work. Exceptions on their way through the loader become others, so it waits
/// here.
class Raised {
public:
    void keep() { error_ = std::current_exception(); }
    void rethrow() const
    {
        if (error_) std::rethrow_exception(error_);
    }
    bool any() const { return error_ != nullptr; }

private:
    std::exception_ptr error_;
};

thread_local const Loaded* reportingFor = nullptr;  ///< Whose progress function this thread is calling.

struct Reporting {
    explicit Reporting(const Loaded* loaded) { reportingFor = loaded; }
    ~Reporting() { reportingFor = nullptr; }
};

}  // namespace

/// Runs `work` without the GIL, by one thread at a time.
template <class Work>
auto Loaded::alone(const Work& work)
{
    if (getpid() != process_)
        throw std::runtime_error(
            "this Renderer was made before the process was forked; make a new one in the new process");
    if (reportingFor == this) throw std::runtime_error("this Renderer is at work: its progress function cannot use it");
    const py::gil_scoped_release free;
    const std::lock_guard lock(mutex_);
    return work();
}

/// `work` gets a progress function.
template <class Work>
void Loaded::reporting(const py::object& progress, const Work& work)
{
    Raised raised;
    const auto report = [&](const char* what, double fraction) {
        const py::gil_scoped_acquire gil;
        if (raised.any()) throw std::runtime_error("stopped");
        try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            const Reporting reporting(this);
            if (!progress.is_none()) progress(what, fraction);
        } catch (const py::error_already_set&) {
            raised.keep();
            throw std::runtime_error("stopped");
        }
    };
    try {
        alone([&] { work(ProgressFunction(std::ref(report))); });
    } catch (...) {
        raised.rethrow();
        throw;
    }
    raised.rethrow();
}

Loaded::Loaded(const std::string& sceneFile, const Texts& given, const py::object& surface, const py::object& grid,
               const py::object& progress)
    : process_(getpid())
{
    const Data memory = dataOf(surface, grid);
    scene_ = sceneOf(sceneFile, given, memory);
    reporting(progress, [&](const ProgressFunction& report) {
        report("loading", 0);
        renderer_ = std::make_unique<Renderer>(scene_, memory, report);
    });
}

Loaded::~Loaded()
{
    if (getpid() != process_) {  // Its threads are not there: nobody could wait for them.
        static_cast<void>(renderer_.release());
        return;
    }
    const py::gil_scoped_release free;
    renderer_.reset();
}

Picture Loaded::render(const std::optional<std::string>& camera)
{
    SceneDescription scene = scene_;
    if (camera) scene = changed(std::move(scene), {{"--camera", *camera}});
    return alone([&] { return renderer_->render(scene.camera); });
}

Picture Loaded::renderFrame(int index)
{
    return alone([&] { return renderer_->renderFrame(index); });
}

void Loaded::set(const Texts& given)
{
    const SceneDescription scene = changed(scene_, given);
    alone([&] {
        if (scene.output.width != scene_.output.width || scene.output.height != scene_.output.height)
            renderer_->setSize(scene.output.width, scene.output.height);
        renderer_->setLic(scene.lic);
        renderer_->setShading(scene.shading);
    });
    scene_ = scene;
}

void Loaded::setTime(double moment)
{
    SceneDescription scene = scene_;
    scene.time = {moment, std::nullopt};
    validate(scene, commandLineName);
    alone([&] { renderer_->setTime(moment); });
    scene_ = scene;
}

void Loaded::setData(const py::object& surface, const py::object& grid, const py::object& progress)
{
    const Data memory = dataOf(surface, grid);
    reporting(progress, [&](const ProgressFunction& report) {
        report("loading", 0);
        renderer_->setData(memory, report);
    });
}

py::dict Loaded::info()
{
    const SceneInfo info = alone([&] { return renderer_->info(); });
    py::dict told;
    told["backend"] = info.backend;
    told["device"] = info.device;
    told["simd"] = info.simd;
    told["unused_gpu"] = info.unusedGpu;
    told["threads"] = info.threads;
    told["load_ms"] = info.loadMs;
    told["field_bytes"] = info.fieldBytes;
    told["triangles"] = info.triangles;
    told["times"] = info.times;
    told["time"] = info.time;
    told["warnings"] = info.warnings;
    return told;
}

std::string Loaded::stats()
{
    const SceneDescription scene = scene_;
    return alone([&] {
        RunStats stats{scene, renderer_->info(), {renderer_->lastFrame()}, {std::int64_t(peakRssBytes())}};
        return statsToJson(stats);
    });
}

std::string Loaded::scene()
{
    return sceneToJson(scene_);
}

}  // namespace aeolic::python
