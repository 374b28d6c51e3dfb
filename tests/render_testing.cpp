#include "render_testing.h"

#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "aeolic/error.h"
#include "data/builtin/flows.h"
#include "data/builtin/surfaces.h"
#include "description/choices.h"

namespace aeolic::testkit {
namespace {

double radiusOf(const Scene& scene)
{
    double radius = 0;
    for (const glm::vec3& p : scene.surface.positions)
        radius = std::max(radius, glm::length(glm::dvec3(p) + scene.surface.originWorld - scene.boundsWorld.center()));
    return radius;
}

}  // namespace

SurfaceMesh makeRectangle(const glm::dvec3& centerWorld, const glm::dvec3& halfU, const glm::dvec3& halfV, int cells)
{
    SurfaceMesh mesh;
    mesh.name = "rectangle";
    const glm::vec3 normal(glm::normalize(glm::cross(halfU, halfV)));
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            mesh.positions.emplace_back(centerWorld + (2.0 * i / cells - 1) * halfU + (2.0 * j / cells - 1) * halfV);
            mesh.normals.push_back(normal);
        }
    const auto at = [&](int i, int j) { return std::uint32_t(j * (cells + 1) + i); };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

SurfaceMesh makeCube(const glm::dvec3& centerWorld, double halfSide)
{
    SurfaceMesh mesh;
    mesh.name = "cube";
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 normal(0), u(0), v(0);
            normal[axis] = side * halfSide;
            u[(axis + 1) % 3] = side * halfSide;
            v[(axis + 2) % 3] = halfSide;
            append(mesh, makeRectangle(centerWorld + normal, u, v));
        }
    return mesh;
}

void append(SurfaceMesh& mesh, const SurfaceMesh& other)
{
    const auto offset = std::uint32_t(mesh.positions.size());
    const auto join = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    join(mesh.positions, other.positions);
    join(mesh.normals, other.normals);
    join(mesh.pointVectors, other.pointVectors);
    join(mesh.cellVectors, other.cellVectors);
    for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

void setPointVectors(SurfaceMesh& mesh, const VectorAt& vectorAt)
{
    mesh.pointVectors.clear();
    for (const glm::vec3& p : mesh.positions) mesh.pointVectors.push_back(vectorAt(glm::dvec3(p) + mesh.originWorld));
}

void setCellVectors(SurfaceMesh& mesh, const VectorAt& vectorAtCentroid)
{
    mesh.cellVectors.clear();
    for (const auto& t : mesh.triangles) {
        const glm::dvec3 sum =
            glm::dvec3(mesh.positions[t[0]]) + glm::dvec3(mesh.positions[t[1]]) + glm::dvec3(mesh.positions[t[2]]);
        mesh.cellVectors.push_back(vectorAtCentroid(sum / 3.0 + mesh.originWorld));
    }
}

std::shared_ptr<const GridField> makeField(const Bounds& bounds, const std::array<std::int64_t, 3>& dims,
                                           const VectorAt& vectorAt)
{
    auto field = std::make_shared<GridField>();
    field->dims = dims;
    field->originWorld = bounds.lo;
    field->spacingWorld =
        (bounds.hi - bounds.lo) / glm::dvec3(double(dims[0] - 1), double(dims[1] - 1), double(dims[2] - 1));
    const auto samples = std::shared_ptr<float[]>(new float[3 * field->sampleCount()]);
    std::size_t at = 0;
    for (std::int64_t z = 0; z < dims[2]; ++z)
        for (std::int64_t y = 0; y < dims[1]; ++y)
            for (std::int64_t x = 0; x < dims[0]; ++x) {
                const glm::vec3 v =
                    vectorAt(field->originWorld + field->spacingWorld * glm::dvec3(double(x), double(y), double(z)));
                for (int c = 0; c < 3; ++c) samples[at++] = v[c];
                if (std::isfinite(glm::length(v)))
                    field->maxMagnitude = std::max(field->maxMagnitude, double(glm::length(v)));
            }
    field->samples = std::shared_ptr<const void>(samples, samples.get());
    field->name = "made";
    return field;
}

Scene makeScene(SurfaceMesh mesh, std::shared_ptr<const GridField> field)
{
    Scene scene;
    scene.surface = std::move(mesh);
    scene.field = std::move(field);
    scene.boundsWorld = scene.surface.bounds();
    if (scene.field) scene.maxVector = scene.field->maxMagnitude;
    for (const auto* vectors : {&scene.surface.pointVectors, &scene.surface.cellVectors})
        for (const glm::vec3& v : *vectors)
            if (std::isfinite(glm::length(v))) scene.maxVector = std::max(scene.maxVector, double(glm::length(v)));
    scene.hasScalar = !scene.surface.pointScalars.empty() || !scene.surface.cellScalars.empty();
    return scene;
}

Scene makeBuiltinScene(const std::string& surface, const std::string& flow)
{
    SurfaceMesh mesh = makeBuiltinSurface(surface);
    const Bounds bounds = mesh.bounds();
    return makeScene(std::move(mesh), makeBuiltinFlow(flow, bounds));
}

Camera fitCamera(const Scene& scene, const CameraOptions& options, int width, int height)
{
    return makeCamera(options, scene.boundsWorld, radiusOf(scene), width, height);
}

Camera frontCamera(const Scene& scene, double distance, int width, int height, double fovDeg)
{
    CameraOptions options;
    options.position = Vec3{0, 0, distance};
    options.focal = Vec3{0, 0, 0};
    options.up = Vec3{0, 1, 0};
    options.fov = fovDeg;
    return fitCamera(scene, options, width, height);
}

glm::dvec3 positionAt(const Camera& camera, double invDepth, int x, int y)
{
    const double xs = (x + 0.5 - 0.5 * camera.width) / camera.focalPx,
                 ys = (y + 0.5 - 0.5 * camera.height) / camera.focalPx;
    return camera.positionWorld + (camera.forward + xs * camera.right - ys * camera.up) / invDepth;
}

glm::dvec3 imageOf(const Camera& camera, const glm::dvec3& positionWorld)
{
    const glm::dvec3 p = positionWorld - camera.positionWorld;
    const double depth = glm::dot(p, camera.forward);
    return {0.5 * camera.width - 0.5 + camera.focalPx * glm::dot(p, camera.right) / depth,
            0.5 * camera.height - 0.5 - camera.focalPx * glm::dot(p, camera.up) / depth, depth};
}

LicOptions directLic(int steps, Integrator integrator, Kernel kernel, double phaseRad)
{
    LicOptions lic;
    lic.method = LicMethod::direct;
    lic.integrator = integrator;
    lic.steps = steps;
    lic.kernel = kernel;
    lic.phase = phaseRad;
    return lic;
}

Stages::Stages(const std::string& backendName, Scene theScene, std::uint32_t seed)
    : scene(std::move(theScene)), noise(seed), backend(makeBackend(*choiceNamed<BackendChoice>(backendName), scene))
{
}

const GBuffer& Stages::project(const Camera& camera, const LicOptions& lic)
{
    LicOptions seeded = lic;
    seeded.seed = noise.seed;
    if (noise.style != lic.style) noise = NoisePyramid(noise.seed, lic.style);
    view = aeolic::makeView(camera, scene, seeded);
    backend->project(view, wholeImage(camera));
    buffer = &backend->probe().gbuffer();
    return *buffer;
}

const Image<float>& Stages::convolve(const LicOptions& lic)
{
    return convolve(lic, buffer->valid());
}

const Image<float>& Stages::convolve(const LicOptions& lic, const Extent& compute)
{
    backend->convolve(inShortSteps(lic, view), compute);
    return backend->probe().lic();
}

std::string whyNoBackend(const std::string& backend)
{
    if (backend == "cpu") return {};
    static const std::string why = [] {
        setenv("AEOLIC_GL_DEBUG", "1", 1);
        try {
            const Scene scene = makeScene(makeCube({0, 0, 0}, 1));
            makeBackend(BackendChoice::gl, scene);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    }();
    return why;
}

void skipWithout(const std::string& backend)
{
    const std::string why = whyNoBackend(backend);
    if (why.empty()) return;
    if (std::getenv("AEOLIC_REQUIRE_GL")) FAIL() << why;
    GTEST_SKIP() << why;
}

void forEachSimdTarget(const std::function<void()>& body)
{
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        SCOPED_TRACE(hwy::TargetName(target));
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        body();
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

double mean(const std::vector<double>& values)
{
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / double(values.size());
}

double standardDeviation(const std::vector<double>& values)
{
    const double center = mean(values);
    double sum = 0;
    for (const double v : values) sum += (v - center) * (v - center);
    return std::sqrt(sum / double(values.size()));
}

double correlation(const std::vector<double>& a, const std::vector<double>& b)
{
    const double meanA = mean(a), meanB = mean(b);
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - meanA) * (b[i] - meanB);
    return sum / double(a.size()) / (standardDeviation(a) * standardDeviation(b));
}

Fit fitGain(const std::vector<double>& a, const std::vector<double>& b)
{
    double ab = 0, aa = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += a[i] * b[i];
        aa += a[i] * a[i];
    }
    Fit fit{ab / aa, 0};
    for (std::size_t i = 0; i < a.size(); ++i) fit.worst = std::max(fit.worst, std::abs(fit.gain * a[i] - b[i]));
    return fit;
}

}  // namespace aeolic::testkit
