#pragma once

/// What the tests of formats with parts ask of what was loaded.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "aeolic/error.h"
#include "data/scene.h"

namespace aeolic::testkit {

/// What load() complains of, which is one line; empty where it does not.
template <class Load>
std::string complaintOf(const Load& load)
{
    try {
        load();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
    return {};
}

inline void expectSays(const std::string& said, const std::vector<std::string>& texts)
{
    for (const std::string& text : texts)
        EXPECT_NE(said.find(text), std::string::npos) << "'" << text << "' is not in: " << said;
}

/// In the mesh's own units, squared.
inline double areaOf(const SurfaceMesh& mesh)
{
    double area = 0;
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

/// Whether each point of the surface carries the vector that flow(world position) gives.
template <class Flow>
void expectVectors(const Scene& scene, const Flow& flow)
{
    const SurfaceMesh& mesh = scene.surface;
    ASSERT_EQ(mesh.pointVectors.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 expected = flow(glm::dvec3(mesh.positions[i]) + mesh.originWorld);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(double(mesh.pointVectors[i][c]), expected[c], 1e-5);
    }
}

}  // namespace aeolic::testkit
