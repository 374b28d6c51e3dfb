#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "data/load/load_steps.h"
#include "data/load/scene_steps.h"
#include "data/load/step_store.h"
#include "data/load/track.h"
#include "description/surface_spec.h"

namespace aeolic {

/// What SceneSteps knows, for its two halves: reading the first moment (scene_steps.cpp), and going to others
/// (scene_moments.cpp).
struct SceneSteps::State {
    State(const SceneDescription& d, const FieldPart& p, const FieldPart& s)
        : description(d),
          part(p),
          pieces(s),
          spec(parseSurfaceSpec(d.surface.spec)),
          surfaces([this](double key, const ProgressReport& progress) {
              return std::make_shared<const LoadedSurface>(loadSurface(key, progress));
          }),
          fields([this](double key, const ProgressReport& progress) {
              return std::make_shared<const FieldStep>(loadField(key, progress));
          })
    {
    }

    LoadedSurface loadSurface(double key, const ProgressReport& progress) const;
    FieldStep loadField(double key, const ProgressReport& progress) const;
    [[noreturn]] void failColorBy(const std::string& arrays) const;
    void placeIn(const PieceFacts& ofAll, LoadedSurface& surface) const;
    void takeSurface(LoadedSurface&& surface, Scene& scene) const;
    void takeFirstField(const FieldStep& step, Scene& scene) const;
    std::pair<const LoadedSurface*, const LoadedSurface*> surfaceSteps() const;
    LoadedSurface surfaceBetween(bool meets);
    void showField(Scene& scene);
    void warnOnce(bool& warned, const Track& track, const char* what);

    std::vector<double> unplaced() const;  ///< Steps prepared whose pieces are not in their place.
    bool cutInPieces() const { return spec.kind == SurfaceSpec::Kind::isosurface && part.split(); }
    bool inPieces() const { return pieces.split() || cutInPieces(); }
    bool surfaceMoves() const { return spec.isCut() ? fieldTrack.moves() : surfaceTrack.moves(); }

    const SceneDescription description;
    const FieldPart part, pieces;
    const SurfaceSpec spec;
    Track surfaceTrack, fieldTrack;
    std::vector<double> times;

    std::optional<LoadedSurface> piece;  ///< Read, until first() takes it.
    std::vector<std::uint64_t> shares;   ///< Bytes by which the pieces of every step are dealt: the first one's.
    std::vector<double> placed;          ///< Keys of the steps in memory whose pieces are in their place.
    CutFacts firstCut;

    // Of the first moment, for all others.
    Bounds boundsWorld;
    glm::dvec3 originWorld{0};
    std::string surfaceScalar;    ///< Label of the array to colour by that the surface carries, or empty.
    bool colorsFromField = true;  ///< Unless a surface that is not cut out of it has them.
    std::string surfaceArrays = "none";

    std::optional<std::pair<Around, Around>> prepared, shown;  ///< Of surface and field.
    std::optional<LoadedSurface> made;        ///< The surface of the moment prepared, until it is shown …
    std::vector<std::string> warningsToShow;  ///< … with these.
    bool warnedSurface = false, warnedField = false;
    std::shared_ptr<GridField> vectorsBetween, scalarBetween;  ///< Memory used again from moment to moment.

    StepStore<LoadedSurface> surfaces;  // Last: their threads use the others.
    StepStore<FieldStep> fields;
};

}  // namespace aeolic
