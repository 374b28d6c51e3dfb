#include "output/picture_files.h"

#include <fmt/format.h>

#include "aeolic/error.h"
#include "output/output_check.h"

namespace aeolic {
namespace {

NamedFormat checkedFormat(const std::string& path, const SceneDescription& scene)
{
    if (path.empty()) throw InputError("-o", "missing", "the file to write: .png, .jpg or .webp");
    const OutputOptions& output = scene.output;
    const bool animation = output.frames > 1;
    const NamedFormat named =
        pictureFormatOf("-o", path, animation, animation ? "" : ", or with --frames also .apng or .mp4");
    checkFits("-o", named.format, output.width, output.height, scene.shading.background == "transparent");
    if (named.format == PictureFormat::mp4 && !hasFfmpeg())
        throw InputError("-o", "found a .mp4, and no ffmpeg in PATH", "an installed ffmpeg, or .webp or .apng");
    return named;
}

std::unique_ptr<Animation> animationFor(PictureFormat format, const AnimationPlan& plan)
{
    switch (format) {
        case PictureFormat::webp:
            return plan.frames > 1 ? makeWebpAnimation(plan) : nullptr;
        case PictureFormat::apng:
            return makeApng(plan);
        case PictureFormat::mp4:
            return makeVideo(plan);
        case PictureFormat::png:
        case PictureFormat::jpeg:
            break;
    }
    return nullptr;
}

}  // namespace

PictureFiles::PictureFiles(const std::string& path, const SceneDescription& scene)
    : path_(path),
      named_(checkedFormat(path, scene)),
      plan_{path, scene.output.frames, scene.output.fps, scene.shading.background}
{
    const bool inOneFile =
        plan_.frames == 1 || (named_.format != PictureFormat::png && named_.format != PictureFormat::jpeg);
    checkWritable(inOneFile ? path_ : pathOf(0));
    if (!inOneFile) checkWritable(pathOf(plan_.frames - 1));
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
