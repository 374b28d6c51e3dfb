#include "output/picture_files.h"

#include <fmt/format.h>

#include "aeolic/error.h"
#include "description/camera.h"
#include "output/output_check.h"

namespace aeolic {
namespace {

NamedFormat checkedFormat(const std::string& path, const SceneDescription& scene, const std::string& option)
{
    if (path.empty()) throw InputError(option, "missing", "the file to write: .png, .jpg or .webp");
    const OutputOptions& output = scene.output;
    const bool flows = scene.lic.flow == FlowMotion::loop, animation = output.frames > 1 || flows;
    const NamedFormat named =
        pictureFormatOf(option, path, animation, animation ? "" : ", or with --frames also .apng or .mp4");
    checkFits(option, named.format, output.width, output.height, scene.shading.background == "transparent");
    if (named.format == PictureFormat::mp4 && !hasFfmpeg())
        throw InputError(option, "found a .mp4, and no ffmpeg in PATH", "an installed ffmpeg, or .webp or .apng");
    if (named.format == PictureFormat::html && (!flows || orbitDegOf(scene) != 0 || scene.time.range))
        throw InputError(option, "found a .html of pictures that are not one cycle",
                         "--flow loop, without --orbit and --time-range");
    return named;
}

std::unique_ptr<Animation> animationFor(PictureFormat format, const AnimationPlan& plan)
{
    if (format == PictureFormat::webp && plan.frames > 1) return makeWebpAnimation(plan);
    if (format == PictureFormat::html) return makeLoopPage(plan);
    if (format == PictureFormat::apng) return makeApng(plan);
    return format == PictureFormat::mp4 ? makeVideo(plan) : nullptr;
}

constexpr int kLoopFrames = 48, kPagePictures = 8;

/// Frames of the animation that is asked for.
int framesOf(const std::string& path, const SceneDescription& scene, const std::string& option)
{
    const PictureFormat format = pictureFormatOf(option, path, true).format;
    const bool isStill = format == PictureFormat::png || format == PictureFormat::jpeg;
    const bool isLoop = scene.lic.flow == FlowMotion::loop && !isStill;
    return isLoop && scene.output.frames == 1 ? kLoopFrames : scene.output.frames;
}

AnimationPlan planFor(const std::string& path, const SceneDescription& scene, const std::string& option)
{
    const int frames = drawnFor(path, scene, option).output.frames;
    // A page with fewer pictures takes as long.
    const double fps = scene.output.fps * frames / framesOf(path, scene, option);
    return {path, frames, fps, scene.shading.background, scene.shading.title.empty() ? "Flow" : scene.shading.title};
}

}  // namespace

SceneDescription drawnFor(const std::string& path, SceneDescription scene, const std::string& option)
{
    const bool isPage = pictureFormatOf(option, path, true).format == PictureFormat::html;
    scene.output.frames = isPage ? kPagePictures : framesOf(path, scene, option);
    return scene;
}

PictureFiles::PictureFiles(const std::string& path, const SceneDescription& scene, const std::string& option)
    : path_(path), named_(checkedFormat(path, scene, option)), plan_(planFor(path, scene, option))
{
    checkWritable(inOneFile() ? path_ : pathOf(0));
    if (!inOneFile()) checkWritable(pathOf(plan_.frames - 1));
}

bool PictureFiles::inOneFile() const
{
    return plan_.frames == 1 || (named_.format != PictureFormat::png && named_.format != PictureFormat::jpeg);
}

std::string PictureFiles::names() const
{
    return inOneFile() ? path_ : pathOf(0) + " to " + pathOf(plan_.frames - 1);
}

/// "a.png" of frame 7 is "a-0007.png"; a single picture keeps its name.
std::string PictureFiles::pathOf(int frame) const
{
    if (plan_.frames == 1) return path_;
    return fmt::format("{}-{:04}{}", path_.substr(0, named_.ending), frame, path_.substr(named_.ending));
}

void PictureFiles::write(const Picture& picture)
{
    if (written_ == 0) animation_ = animationFor(named_.format, plan_);
    if (animation_)
        animation_->add(picture);
    else
        writePicture(picture, pathOf(written_));
    ++written_;
}

void PictureFiles::complete()
{
    if (animation_) animation_->complete();
}

}  // namespace aeolic
