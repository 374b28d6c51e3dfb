#include "loaded.h"

#include <pybind11/stl.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "aeolic/error.h"
#include "aeolic/live.h"
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

/// The server of a scene that is shown, and the thread that draws for it.
struct Loaded::Shown {
    explicit Shown(Live served) : live(std::move(served)) {}
    ~Shown()
    {
        ends = true;
        if (thread.joinable()) thread.join();
    }

    Live live;
    std::atomic<bool> ends{false}, changed{false};  ///< Python has changed something: viewers do not know yet.
    std::thread thread;
};

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

Loaded::Loaded(const std::string& sceneFile, const Texts& given, const Surfaces& surfaces, const py::object& surface,
               const py::object& field, const py::object& progress)
    : process_(getpid())
{
    const Data memory = dataOf(surface, field);
    inMemory_ = memory.surface || memory.hasField();
    scene_ = sceneOf(sceneFile, given, surfaces, memory);
    reporting(progress, [&](const ProgressFunction& report) {
        report("loading", 0);
        renderer_ = std::make_unique<Renderer>(scene_, memory, report);
    });
}

Loaded::~Loaded()
{
    if (getpid() != process_) {  // Its threads are not there: nobody could wait for them.
        static_cast<void>(shown_.release());
        static_cast<void>(renderer_.release());
        return;
    }
    const py::gil_scoped_release free;
    shown_.reset();
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
        scene_ = scene;
        tellViewers();
    });
}

void Loaded::setTime(double moment)
{
    SceneDescription scene = scene_;
    scene.time = {moment, std::nullopt};
    validate(scene, commandLineName);
    alone([&] {
        renderer_->setTime(moment);
        scene_ = scene;
        tellViewers();
    });
}

void Loaded::setShown(const std::vector<bool>& shown)
{
    alone([&] {
        renderer_->setShown(shown);
        for (std::size_t i = 0; i < shown.size(); ++i) scene_.surfaces[i].shown = shown[i];
        tellViewers();
    });
}

void Loaded::setData(const py::object& surface, const py::object& field, const py::object& progress)
{
    const Data memory = dataOf(surface, field);
    reporting(progress, [&](const ProgressFunction& report) {
        report("loading", 0);
        renderer_->setData(memory, report);
        tellViewers();
    });
}

void Loaded::tellViewers()
{
    if (shown_) shown_->changed = true;
}

/// Viewers choose surface, vectors and colours of files. Data in memory are what the program gave.
void Loaded::reload(Renderer& renderer, const SceneDescription& scene, const ProgressFunction& report)
{
    renderer = Renderer(scene, report);
    scene_ = scene;
}

std::string Loaded::show(int port, const std::string& title, const std::vector<ControlTuple>& controls)
{
    if (port < 0 || port > 65535) throw InputError("port", "found " + std::to_string(port), "0 to 65535");
    LiveOptions options;
    options.port = std::uint16_t(port);
    options.title = title;
    options.embedded = true;
    for (const auto& [name, kind, lo, hi, value] : controls)
        options.controls.push_back({name,
                                    kind == "number"   ? Control::Kind::number
                                    : kind == "toggle" ? Control::Kind::toggle
                                                       : Control::Kind::button,
                                    value, lo, hi, ""});
    if (!inMemory_)
        options.reload = [this](Renderer& renderer, const SceneDescription& scene, const ProgressFunction& report) {
            reload(renderer, scene, report);
        };
    return alone([&] {
        shown_ = std::make_unique<Shown>(Live(*renderer_, options));
        shown_->thread = std::thread([this, shown = shown_.get()] { drawForViewers(*shown); });
        return shown_->live.address();
    });
}

/// A viewer waits for 20 ms at most until it sees what Python has changed.
void Loaded::drawForViewers(Shown& shown)
{
    constexpr auto kLookAgain = std::chrono::milliseconds(20);
    try {
        while (!shown.ends) {
            const bool asked = shown.live.waitForRequest(kLookAgain);
            if (!shown.changed.exchange(false) && !asked) continue;
            const std::lock_guard lock(mutex_);
            if (!shown.live.serve(*renderer_)) return;
        }
    } catch (const std::exception& error) {  // A device failed: pictures that Python asks for raise the same.
        std::fprintf(stderr, "aeolic: the scene is no longer shown: %s\n", error.what());
    }
}

void Loaded::hide()
{
    if (getpid() != process_) return;
    const py::gil_scoped_release free;  // Its thread may wait for another one that draws.
    shown_.reset();
}

double Loaded::control(const std::string& name)
{
    return alone([&] {
        if (!shown_) throw std::runtime_error("the viewer is closed");
        return shown_->live.value(name);
    });
}

void Loaded::setControl(const std::string& name, double value)
{
    alone([&] {
        if (!shown_) throw std::runtime_error("the viewer is closed");
        shown_->live.setValue(name, value);
        tellViewers();
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
