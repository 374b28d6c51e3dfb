#pragma once

#include <memory>
#include <string>

#include "aeolic/picture.h"
#include "output/picture_formats.h"

namespace aeolic {

/// An animation in one file, made of pictures of one size that come one after the other. It plays for ever. The file is
/// there when complete() has returned; before, or where anything fails, `path` is what it was.
class Animation {
public:
    virtual ~Animation() = default;

    /// The next picture. Throws std::runtime_error naming the path.
    virtual void add(const Picture& picture) = 0;

    /// After the last picture. Throws std::runtime_error naming the path.
    virtual void complete() = 0;
};

struct AnimationPlan {
    std::string path;
    int frames = 1;
    double framesPerSecond = 25;
    std::string background = "ffffff";  ///< RRGGBB, of what a video of odd size gets at its edge, or transparent.
    std::string title = "Flow";         ///< UTF-8. A page has it.
};

std::unique_ptr<Animation> makeApng(const AnimationPlan& plan);
std::unique_ptr<Animation> makeWebpAnimation(const AnimationPlan& plan);

/// A page for browsers that plays by itself, of the few pictures of one cycle: it draws those between them.
std::unique_ptr<Animation> makeLoopPage(const AnimationPlan& plan);

/// By the first `ffmpeg` in PATH. Throws InputError where there is none.
std::unique_ptr<Animation> makeVideo(const AnimationPlan& plan);

/// Whether there is one.
bool hasFfmpeg();

}  // namespace aeolic
