#pragma once

#include <memory>
#include <vector>

#include "data/progress.h"
#include "data/scene.h"

namespace aeolic {

/// A scene whose surface, field or both change in time: which moments there are, which of their steps are in memory,
/// and the scene at any moment. Local. A scene that does not change is the case of one step.
///
/// In memory are, of surface and field each, the steps on either side of the moment shown, one read ahead, and what is
/// interpolated between the two (docs/file-formats.md).
class SceneSteps {
public:
    /// Says which series there are. Throws InputError for a series that makes no sense.
    SceneSteps(const SceneDescription& description, const FieldPart& part);
    ~SceneSteps();

    /// The scene at the first moment of all, with its largest vector and scalar range where this part can tell them.
    /// Camera fit, noise and built-in flows go by this moment's bounds at all others. Call first. Throws InputError.
    Scene first(const ProgressReport& progress);

    bool moves() const { return times().size() > 1; }

    /// All steps of surface and field, sorted; empty where nothing changes. Known once first() was called.
    const std::vector<double>& times() const;

    /// Brings the steps into memory that `moment` needs, and drops others. May fail (InputError), and then whatever is
    /// shown stays as it was. Returns whether any was loaded.
    bool prepare(double moment, const ProgressReport& progress);

    /// Makes `scene`, which first() gave, that of the moment prepared. Throws InputError where no triangle of a surface
    /// in between has an area: `scene` is then as it was.
    SceneChange show(Scene& scene);

    /// Begins to load, on another thread, one step that `moment` will need and that is not in memory, if there is room
    /// for it.
    void readAhead(double moment);

    /// Steps in memory, for tests: of the surface and of the field together, those being loaded included.
    std::size_t held() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Largest vector and scalar range of what `scene` shows.
void measure(Scene& scene);

/// Whether the ranges of a first moment are of no use for an animation, because nothing moves yet or all colours are
/// the same: those of the last moment are taken then.
bool atRest(const Scene& scene);

}  // namespace aeolic
