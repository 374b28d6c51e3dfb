#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "data/load/loaded_surface.h"
#include "data/load/progress.h"
#include "data/scene.h"

namespace aeolic {

/// A piece of an isosurface.
struct CutFacts {
    std::array<double, 2> range{0, 0};  ///< Of the finite values around it; lo > hi: there is none.
    std::uint64_t triangles = 0;
};

/// A scene whose surface, field or both change in time: which moments there are, which of their steps are in memory,
/// and the scene at any moment. Local. A scene that does not change is the case of one step.
///
/// In memory are, of surface and field each, the steps on either side of the moment shown, one read ahead, and what is
/// interpolated between the two (docs/file-formats.md).
///
/// Of a scene that several ranks share this may hold a part: of the field its brick, and of the surface a piece. What
/// only all parts together tell, the caller finds out (pipeline/load_together.h).
class SceneSteps {
public:
    /// Says which series there are. `part`: of the field, and of an isosurface of it; `pieces`: of a surface from a
    /// file. Throws InputError for a series that makes no sense.
    SceneSteps(const SceneDescription& description, const FieldPart& part, const FieldPart& pieces = {});
    ~SceneSteps();

    /// Reads this part's pieces of a surface from a file, if it has such; to be called before first(), which wants the
    /// same of all parts. Throws InputError.
    PieceFacts readPieces(const ProgressReport& progress);

    /// The scene at the first moment of all, with its largest vector and scalar range where this part can tell them.
    /// Camera fit, noise and built-in flows go by this moment's bounds at all others. Call first. Throws InputError.
    Scene first(const ProgressReport& progress, const PieceFacts& ofAllPieces = {});

    /// Of the isosurfaces of the steps last read, where this holds but pieces of them.
    std::vector<CutFacts> cuts() const;

    /// Throws InputError unless all pieces of each of these have triangles, and what is left of the surface has
    /// `drawn`.
    void requireTriangles(const std::vector<CutFacts>& ofAllPieces, std::uint64_t drawn) const;

    /// Throws InputError unless `meets`, the surface and the field's box.
    void requireOverlap(const Scene& scene, bool meets) const;

    bool moves() const { return times().size() > 1; }

    /// All steps of surface and field, sorted; empty where nothing changes. Known once first() was called.
    const std::vector<double>& times() const;

    /// Brings the steps into memory that `moment` needs, and drops others. May fail (InputError), and then whatever is
    /// shown stays as it was. Returns whether any was loaded.
    bool prepare(double moment, const ProgressReport& progress);

    /// Of the steps of a surface from a file that prepare() has loaded where this holds but a piece of them: what this
    /// part tells of each, to be told placePieces() of all parts together, in the same order, before make(). The same
    /// number on all parts.
    std::vector<PieceFacts> unplacedPieces() const;
    void placePieces(const std::vector<PieceFacts>& ofAllPieces);

    /// Whether this part of the surface can be interpolated at the moment prepared, or need not be.
    bool surfaceMeets() const;

    /// Makes the surface of the moment prepared, for show(). `meets`: surfaceMeets() of all parts. Returns how many
    /// triangles this part of it has; nothing where it is the one shown. Throws InputError where none is left of a
    /// surface that is no piece.
    std::optional<std::size_t> make(bool meets);

    /// Makes `scene`, which first() gave, that of the moment prepared; make() before, unless it was. Throws as that:
    /// `scene` is then as it was.
    SceneChange show(Scene& scene);

    /// Whether the surface's pieces are to be dealt to the bricks they reach into.
    bool dealsToBricks() const;

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
