#pragma once

#include <string>

#include "aeolic/scene_description.h"

namespace aeolic::testkit {

/// A scene of one surface in a field, and what it is coloured by.
inline SceneDescription describe(const std::string& surface, const std::string& field, const std::string& colorBy = "")
{
    SceneDescription description;
    description.surface.spec = surface;
    description.field.spec = field;
    description.shading.colorBy = colorBy;
    return description;
}

}  // namespace aeolic::testkit
