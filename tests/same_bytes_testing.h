#pragma once

/// Pictures of the same scene drawn by any number of ranks, each a thread of its own, compared byte for byte.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/picture.h"
#include "aeolic/scene_description.h"
#include "data/load/split.h"
#include "render/surface_overlay.h"

namespace aeolic::testkit {

struct Case {
    std::string name;
    SceneDescription description;
    CameraOptions camera;
    std::shared_ptr<const SurfaceOverlay> overlay = nullptr;
    std::optional<Split> split = std::nullopt;  ///< Instead of what the options say, where there are several ranks.
};

LicOptions licOf(LicMethod method, int steps, Kernel kernel = Kernel::box, bool normalize = true);

/// Coloured by the field's length, a little closer than the whole.
Case makeCase(const std::string& name, int width, int height, const LicOptions& lic,
              const std::string& surface = "teapot:6000", const std::string& field = "abc:32,32,32");

RunOptions runOptions(const std::string& balance, const std::string& guard, const std::string& guardRows,
                      const std::string& bricks = "off");

/// Frames of a turning camera, so that balancers that look back have something to look at.
std::vector<Picture> draw(const std::string& backendName, const Case& c, const RunOptions& options, int ranks,
                          int frames);

/// From one camera after the other.
std::vector<Picture> draw(const std::string& backendName, const Case& c, const RunOptions& options, int ranks,
                          const std::vector<CameraOptions>& cameras);

/// `expected`: as drawn by one rank, as many frames.
void expectSameBytes(const std::string& backendName, const Case& c, const std::vector<Picture>& expected,
                     const RunOptions& options, int ranks);

/// What so many ranks all say who cannot load the scene; empty where they can.
std::string complaintOf(const SceneDescription& description, int ranks);

}  // namespace aeolic::testkit
