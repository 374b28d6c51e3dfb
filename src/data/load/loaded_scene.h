#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/data.h"
#include "aeolic/scene_description.h"
#include "data/load/agreement.h"
#include "data/load/split.h"
#include "data/progress.h"
#include "data/scene.h"

namespace aeolic {

/// A scene in memory, at one moment, that can go to others. A scene that does not change is the case of one step.
///
/// Every rank holds all of it, or its own brick of the field, or its own pieces of the surface, or both. What is said
/// of the whole scene, ranges, bounds and warnings, is the same either way, on all ranks.
///
/// For the surface and for the field, memory holds the steps on either side of the moment shown, one step that is read
/// ahead, and the moment between the two (docs/file-formats.md).
class LoadedScene {
public:
    /// Collective. Loads what `description` names, at its moment. What is in `memory` is named as by nameMemory(), and
    /// is no longer read when this returns, but for the samples of a grid that are borrowed (aeolic/data.h). `split`:
    /// the same on all ranks. `agreement` has to last as long as this. Every rank throws what any of them throws;
    /// InputError with one line for anything wrong in the user's files or options.
    LoadedScene(const SceneDescription& description, const Split& split, Agreement& agreement,
                const ProgressReport& progress = {}, const Data& memory = {});
    ~LoadedScene();

    /// Local. It stays where it is in memory. Camera fit, noise and the boxes of built-in flows go by the first moment
    /// of all.
    const Scene& scene() const;

    /// Collective. Goes to another moment. Every rank throws what any of them throws; the scene is then as it was.
    SceneChange moveTo(double moment, const ProgressReport& progress = {});

    /// Collective. Takes other data in memory, as another step of a series: camera fit, noise and ranges stay those of
    /// the first. What is not given stays. `moment`: the one shown. Every rank throws what any of them throws; the
    /// scene is then as it was.
    SceneChange replace(const Data& memory, double moment, const ProgressReport& progress = {});

    /// Local. Which of several surfaces are drawn; as many as there are. Ranges and camera fit go by them, as if it had
    /// been loaded so. Cost: a copy of all that is drawn.
    SceneChange setShown(const std::vector<bool>& shown);

    /// Local. Begins to read, on another thread, one step that `moment` will need and that is not in memory, if there
    /// is room for it.
    void readAhead(double moment);

    /// Local. All steps of surface and field, sorted; empty where nothing changes.
    const std::vector<double>& times() const;
    bool moves() const { return times().size() > 1; }

    /// Local. The first and the last moment that can be shown; nothing where any can, or nothing changes.
    std::optional<std::array<double, 2>> span() const;
    /// Local. The moment that is shown for `moment`.
    double shownFor(double moment) const;

    /// Local. Adds to the scene's warnings.
    void warn(std::string warning);

    /// Local. How many steps are in memory, for tests: those of surface and field, with those that are being read.
    std::size_t held() const;

    /// Local. The scene alone, without a way to other moments. Only once, as the last thing.
    Scene take() &&;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Gives data in memory names, in the place of files.
void nameMemory(SceneDescription& description, const Data& memory);

/// Collective. A scene that stays at its moment; throws as LoadedScene does.
Scene loadScene(const SceneDescription& description, const Split& split, Agreement& agreement,
                const ProgressReport& progress = {});

/// Local. The whole of it, by one rank. Throws InputError.
Scene loadScene(const SceneDescription& description, const ProgressReport& progress = {});

}  // namespace aeolic
