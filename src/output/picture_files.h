#pragma once

#include <memory>
#include <string>

#include "aeolic/scene_description.h"
#include "output/animation.h"

namespace aeolic {

/// The scene as it is drawn for a file of that name. Streaks that flow have a cycle of 48 frames where --frames does
/// not say how many, unless the file holds a single picture. A page takes eight pictures of any cycle.
SceneDescription drawnFor(const std::string& path, SceneDescription scene, const std::string& option = "-o");

/// Where the pictures of a scene go: one file, numbered files, or an animation in one file, by the end of the name.
class PictureFiles {
public:
    /// Checks before the work that they can be written. `scene`: as it was asked for. Throws InputError naming
    /// `option`: the ending, a size that the format has not, transparency that it has not, a missing ffmpeg, a page of
    /// pictures that are no cycle, or what checkWritable() finds.
    PictureFiles(const std::string& path, const SceneDescription& scene, const std::string& option = "-o");

    /// The next picture, in their order. Throws std::runtime_error naming the path.
    void write(const Picture& picture);

    /// After the last one.
    void complete();

    /// What was written: "a.png", or "a-0000.png to a-0029.png".
    std::string names() const;

private:
    bool inOneFile() const;
    std::string pathOf(int frame) const;

    std::string path_;
    NamedFormat named_;
    AnimationPlan plan_;
    std::unique_ptr<Animation> animation_;  // Null: a file for each picture.
    int written_ = 0;
};

}  // namespace aeolic
