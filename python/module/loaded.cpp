#include "loaded.h"

#include <pybind11/stl.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "aeolic/error.h"
#include "aeolic/live.h"
#include "description/camera.h"
#include "description/idle_options.h"
#include "description/option_names.h"
#include "description/scene_json.h"
#include "description/scene_text.h"
#include "description/validate.h"
#include "errors.h"
#include "gil.h"
#include "memory.h"
#include "output/nothing_shown.h"
#include "output/picture_files.h"
#include "output/stats_json.h"
#include "pixels.h"

namespace aeolic::python {

namespace py = pybind11;

/// Says which thread is at work.
struct Loaded::Turn {
    explicit Turn(std::atomic<std::thread::id>& worker) : at(worker) { at = std::this_thread::get_id(); }
    ~Turn() { at = std::thread::id(); }
    std::atomic<std::thread::id>& at;
};

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
    requireFree();
    const WithoutGil free;
    const std::lock_guard lock(mutex_);
    const Turn turn(worker_);
    return work();
}

/// `work` gets a progress function. Exceptions on their way through the loader become others: what Python raised waits
/// here.
template <class Work>
void Loaded::reporting(const py::object& progress, const Work& work)
{
    std::exception_ptr raised;
    const auto report = [&](const char* what, double fraction) {
        const WithGil gil;
        if (raised) throw std::runtime_error("stopped");
        const bool goesOn = orSleep([&] {
            if (PyErr_CheckSignals() != 0) return false;
            if (progress.is_none()) return true;
            PyObject* const given = PyObject_CallFunction(progress.ptr(), "sd", what, fraction);
            Py_XDECREF(given);
            return given != nullptr;
        });
        if (goesOn) return;
        raised = std::make_exception_ptr(py::error_already_set());
        throw std::runtime_error("stopped");
    };
    try {
        alone([&] { work(ProgressFunction(std::ref(report))); });
    } catch (...) {
        if (!raised) throw;
    }
    if (raised) std::rethrow_exception(raised);
}

void Loaded::requireFree() const
{
    if (getpid() != process_)
        throw std::runtime_error(
            "this Renderer was made before the process was forked; make a new one in the new process");
    if (isAtWorkHere()) throw std::runtime_error("this Renderer is at work: its progress function cannot use it");
}

bool Loaded::isAtWorkHere() const
{
    return worker_ == std::this_thread::get_id();
}

Loaded::Loaded(const GivenScene& scene, const Texts& given, const Surfaces& surfaces, const py::object& surface,
               const py::object& field, const py::object& progress)
    : process_(getpid()), start_(startOf(scene)), given_(given)
{
    const Data memory = dataOf(surface, field);
    inMemory_ = memory.surface || memory.hasField();
    scene_ = sceneOf(start_, scene.file || scene.text, given, surfaces, memory);
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
    const WithoutGil free;
    shown_.reset();
    renderer_.reset();
}

Picture Loaded::render(const std::optional<std::string>& camera)
{
    return alone([&] {
        return renderer_->render({camera ? changed(scene_, {{"--camera", *camera}}).camera : scene_.camera});
    });
}

Picture Loaded::renderFrame(int index)
{
    return alone([&] { return renderer_->render({AnimationFrame{index}}); });
}

void Loaded::saveAnimation(const std::string& path, const py::object& progress)
{
    const std::string call = "save_animation";
    reporting(progress, [&](const ProgressFunction& report) {
        PictureFiles files(path, scene_, call);
        const int frames = drawnFor(path, scene_, call).output.frames;
        const bool asDescribed = frames == scene_.output.frames;
        if (!asDescribed && (orbitDegOf(scene_) != 0 || scene_.time.range))
            throw InputError(call, "found a cycle of streaks with orbit or time_range, and no frames",
                             "frames=, so many pictures");
        const auto draw = [&](int i, Picture kept) -> Picture {
            if (asDescribed) return renderer_->render({AnimationFrame{i}}, std::move(kept));
            LicOptions lic = scene_.lic;  // A cycle of another length: the camera stands.
            lic.phase += 2 * std::numbers::pi * i / frames;
            renderer_->setLic(lic);
            return renderer_->render({scene_.camera}, std::move(kept));
        };
        Picture picture;
        try {
            for (int i = 0; i < frames; ++i) {
                report("frames", double(i) / frames);
                picture = draw(i, std::move(picture));
                files.write(picture);
            }
        } catch (...) {
            renderer_->setLic(scene_.lic);
            throw;
        }
        renderer_->setLic(scene_.lic);
        files.complete();
    });
}

void Loaded::set(const Texts& given, const std::vector<std::string>& withdrawn)
{
    alone([&] {
        SceneDescription scene = changed(scene_, given, start_.scene, withdrawn);
        const bool resized = scene.output.width != scene_.output.width || scene.output.height != scene_.output.height;
        if (resized) renderer_->setSize(scene.output.width, scene.output.height);
        try {
            renderer_->setShading(scene.shading);
        } catch (...) {
            if (resized) renderer_->setSize(scene_.output.width, scene_.output.height);
            throw;
        }
        renderer_->setLic(scene.lic);
        scene_ = std::move(scene);
        for (const std::string& name : withdrawn) given_.erase(name);
        for (const auto& [name, text] : given) given_[name] = text;
        tellViewers();
    });
}

void Loaded::setTime(double moment)
{
    alone([&] {
        SceneDescription scene = scene_;
        scene.time = {moment, std::nullopt};
        validate(scene, commandLineName);
        renderer_->setTime(moment);
        scene_.time = renderer_->description().time;
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
    renderer.reload(scene, report);
    scene_ = scene;
}

std::string Loaded::show(int port, const std::string& title, const std::vector<ControlTuple>& controls)
{
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
        if (!shown_) {
            auto shown = std::make_unique<Shown>(Live(*renderer_, options));
            shown->thread = std::thread([this, it = shown.get()] { drawForViewers(*it); });
            shown_ = std::move(shown);
        }
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
            std::unique_lock lock(mutex_, kLookAgain);
            if (!lock)  // A progress function may end this, whose thread has the lock.
                shown.changed = true;
            else if (!shown.live.serve(*renderer_))
                return;
        }
    } catch (const std::exception& error) {  // A device failed: pictures that Python asks for raise the same.
        std::fprintf(stderr, "aeolic: the scene is no longer shown: %s\n", error.what());
    }
}

void Loaded::hide()
{
    if (getpid() != process_) return;
    const WithoutGil free;
    std::unique_ptr<Shown> gone;  // Its thread may wait for another one that draws.
    std::unique_lock lock(mutex_, std::defer_lock);
    if (!isAtWorkHere()) lock.lock();
    gone = std::move(shown_);
    if (lock) lock.unlock();
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

SceneInfo Loaded::infoWithIdle() const
{
    SceneInfo told = renderer_->info();
    for (std::string& idle : idleOptions(scene_, given_, !told.times.empty())) told.warnings.push_back(std::move(idle));
    return told;
}

py::dict Loaded::info()
{
    const SceneInfo info = alone([&] { return infoWithIdle(); });
    py::list warnings;
    for (const std::string& warning : info.warnings) warnings.append(textOf(inPythonsWords(warning)));
    py::dict told;
    told["backend"] = textOf(info.backend);
    told["device"] = textOf(info.device);
    told["simd"] = textOf(info.simd);
    told["unused_gpu"] = textOf(info.unusedGpu);
    told["threads"] = info.threads;
    told["load_ms"] = info.loadMs;
    told["field_bytes"] = info.fieldBytes;
    told["triangles"] = info.triangles;
    told["times"] = info.times;
    told["time"] = info.time;
    told["warnings"] = warnings;
    return told;
}

py::list Loaded::warnings()
{
    std::vector<std::string> all = alone([&] {
        std::vector<std::string> told = infoWithIdle().warnings;
        if (renderer_->lastFrame().coveredPixels == 0) told.push_back(nothingShown(1, 1));
        return told;
    });
    py::list texts;
    for (const std::string& warning : all) texts.append(textOf(inPythonsWords(warning)));
    return texts;
}

FlowTopology Loaded::topology()
{
    return alone([&] { return renderer_->topology(); });
}

FlowTopology Loaded::separation()
{
    return alone([&] { return renderer_->separation(); });
}

EvenSurfaceLines Loaded::streamlines()
{
    return alone([&] { return renderer_->streamlines(); });
}

py::dict Loaded::buffers(const std::optional<std::string>& camera)
{
    return arraysOf(alone([&] {
        return renderer_->buffers(camera ? changed(scene_, {{"--camera", *camera}}).camera : scene_.camera);
    }));
}

py::object Loaded::pick(int x, int y, const std::optional<std::string>& camera)
{
    return told(alone([&] {
        return renderer_->pick(x, y, camera ? changed(scene_, {{"--camera", *camera}}).camera : scene_.camera);
    }));
}

std::string Loaded::stats()
{
    return alone([&] {
        const RunStats stats{scene_, renderer_->info(), {renderer_->lastFrame()}, {std::int64_t(peakRssBytes())}};
        return statsToJson(stats);
    });
}

std::string Loaded::scene()
{
    return alone([&] { return sceneToJson(scene_); });
}

}  // namespace aeolic::python
