#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/load/loaded_scene.h"
#include "data/vtk/testing/sample_files.h"

/// Cases of OpenFOAM, and what is said about them.
namespace aeolic::openfoam_testing {

using namespace test;

inline SceneDescription describe(const std::string& surface, const std::string& vectors = "wallShearStress")
{
    SceneDescription description;
    description.surface.spec = surface;
    description.field.vectors = vectors;
    description.shading.colorBy = vectors + ":mag";
    return description;
}

inline std::string messageOf(const SceneDescription& description)
{
    try {
        loadScene(description);
    } catch (const InputError& error) {
        return error.what();
    }
    return "(nothing was refused)";
}

inline void expectParts(const std::string& message, const std::vector<std::string>& parts)
{
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    for (const std::string& part : parts)
        EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is not in: " << message;
}

}  // namespace aeolic::openfoam_testing
