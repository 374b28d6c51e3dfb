#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "reference/reference.h"
#include "render/gbuffer.h"
#include "render/limits.h"
#include "render/shading_model.h"

namespace aeolic::reference {
namespace {

struct Hit {
    double depth = std::numeric_limits<double>::infinity();
    double u = 0, v = 0;
    long triangle = -1;
};

Hit nearestHit(const Scene& scene, const glm::dvec3& eye, const glm::dvec3& ray, double nearDepth, double farDepth)
{
    Hit hit;
    const SurfaceMesh& mesh = scene.surface;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        const glm::dvec3 p0(mesh.positions[t[0]]), e1 = glm::dvec3(mesh.positions[t[1]]) - p0,
                                                   e2 = glm::dvec3(mesh.positions[t[2]]) - p0;
        const glm::dvec3 p = glm::cross(ray, e2), q = glm::cross(eye - p0, e1);
        const double determinant = glm::dot(e1, p);
        if (determinant == 0) continue;
        const double u = glm::dot(eye - p0, p) / determinant, v = glm::dot(ray, q) / determinant;
        const double depth = glm::dot(e2, q) / determinant;  // `ray` has unit eye depth.
        if (u < 0 || v < 0 || u + v > 1 || depth < nearDepth || depth > farDepth || depth >= hit.depth) continue;
        hit = {depth, u, v, long(i)};
    }
    return hit;
}

template <class T>
T interpolate(const std::vector<T>& values, const std::array<std::uint32_t, 3>& t, double u, double v)
{
    return T((1 - u - v) * values[t[0]] + u * values[t[1]] + v * values[t[2]]);
}

glm::dvec3 interpolate(const std::vector<glm::vec3>& values, const std::array<std::uint32_t, 3>& t, double u, double v)
{
    return (1 - u - v) * glm::dvec3(values[t[0]]) + u * glm::dvec3(values[t[1]]) + v * glm::dvec3(values[t[2]]);
}

void link(const View& view, PixelImage& image)
{
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int sy = -1; sy <= 1; ++sy)
                for (int sx = -1; sx <= 1; ++sx) {
                    Pixel& a = image.at(x, y);
                    if ((sx == 0 && sy == 0) || !image.contains(x + sx, y + sy)) continue;
                    const Pixel& b = image.at(x + sx, y + sy);
                    if (!a.hasFlow || !b.hasFlow) continue;
                    const double ga = a.gradX * sx + a.gradY * sy, gb = b.gradX * sx + b.gradY * sy,
                                 change = b.invDepth - a.invDepth;
                    const double errorA = change - ga, errorB = gb - change;
                    const double slack =
                        0.5 * double(limits::kSlackFootprints) / view.camera.focalPx * (a.invDepth + b.invDepth) +
                        double(limits::kSlackSlope) * std::max(std::abs(ga), std::abs(gb));
                    const bool predicted = std::min(std::abs(errorA), std::abs(errorB)) <= slack,
                               crease = errorA * errorB >= 0;
                    a.linked[std::size_t((sy + 1) * 3 + sx + 1)] = predicted || crease;
                }
}

}  // namespace

glm::dvec3 sampleField(const GridField& field, const glm::dvec3& positionWorld)
{
    const glm::dvec3 g = (positionWorld - field.originWorld) / field.spacingWorld;
    std::int64_t lower[3];
    double w[3];
    for (int c = 0; c < 3; ++c) {
        const double top = double(field.dims[std::size_t(c)] - 1);
        if (!(g[c] >= -1e-3 && g[c] <= top + 1e-3)) return glm::dvec3(std::numeric_limits<double>::quiet_NaN());
        const double in = std::clamp(g[c], 0.0, top);
        lower[c] = std::min(std::int64_t(in), field.dims[std::size_t(c)] - 2);
        w[c] = in - double(lower[c]);
    }
    glm::dvec3 sum(0);
    for (int k = 0; k < 8; ++k) {
        const std::int64_t x = lower[0] + (k & 1), y = lower[1] + (k >> 1 & 1), z = lower[2] + (k >> 2);
        const float* s = field.floats() + ((z * field.dims[1] + y) * field.dims[0] + x) * field.components;
        const double weight =
            ((k & 1) ? w[0] : 1 - w[0]) * ((k >> 1 & 1) ? w[1] : 1 - w[1]) * ((k >> 2) ? w[2] : 1 - w[2]);
        for (int c = 0; c < field.components; ++c) sum[c] += weight * double(s[c]);
    }
    return sum;
}

double noiseAt(const NoisePyramid& noise, const NoiseLookup& lookup, const glm::dvec3& local, double footprint)
{
    const double wanted = footprint * lookup.levelFromFootprint;
    const int level = int(std::floor(std::log2(wanted)));
    const double mantissa = std::exp2(-level) * wanted;
    const bool isPhased = lookup.grains == GrainValue::cosine || lookup.grains == GrainValue::sine;
    const auto phaseOf = [&](std::size_t x, std::size_t y, std::size_t z) {
        const std::uint32_t sixteenths = grains::phaseOf(std::uint32_t(NoisePyramid::index(x, y, z)));
        const double phase = 2 * std::numbers::pi * sixteenths / grains::kPhases;
        return lookup.grains == GrainValue::cosine ? std::cos(phase) : std::sin(phase);
    };
    const auto trilinear = [&](int o) {
        const glm::dvec3 t = lookup.texelFromLocal * local * std::exp2(-o) +
                             double(o) * glm::dvec3(kNoiseLevelOffset[0], kNoiseLevelOffset[1], kNoiseLevelOffset[2]);
        const glm::dvec3 f = glm::floor(t), w = t - f;
        const auto wrapped = [](double v) { return std::size_t(std::int64_t(v) & (NoisePyramid::kSize - 1)); };
        const int cell = noise.cells[NoisePyramid::index(wrapped(f.x), wrapped(f.y), wrapped(f.z))];
        double sum = 0;
        if (isPhased) {  // Each corner's own phase, were there more grains than one in a cell, too.
            for (int k = 0; k < 8; ++k)
                if (cell >> k & 1)
                    sum += phaseOf(wrapped(f.x + (k & 1)), wrapped(f.y + (k >> 1 & 1)), wrapped(f.z + (k >> 2))) *
                           ((k & 1) ? w.x : 1 - w.x) * ((k >> 1 & 1) ? w.y : 1 - w.y) * ((k >> 2) ? w.z : 1 - w.z);
            return sum;
        }
        for (int k = 0; k < 8; ++k)
            sum += (2 * (cell >> k & 1) - 1) * ((k & 1) ? w.x : 1 - w.x) * ((k >> 1 & 1) ? w.y : 1 - w.y) *
                   ((k >> 2) ? w.z : 1 - w.z);
        return sum;
    };
    if (lookup.grains != GrainValue::none) {
        const double from = double(grains::kBlendFrom), to = double(grains::kBlendTo);
        const double blend = std::clamp((mantissa - from) / (to - from), 0.0, 1.0);
        const auto grain = [&](int o) {
            return isPhased ? trilinear(o) : (1 + trilinear(o)) / 2 - double(grains::kShare);
        };
        const double height = mantissa * double(grains::kHeight);
        return height * ((1 - blend) * grain(level) + 0.5 * blend * grain(level + 1)) / std::hypot(1 - blend, blend);
    }
    const double blend = mantissa - 1;
    return ((1 - blend) * trilinear(level) + blend * trilinear(level + 1)) /
           std::sqrt((1 - blend) * (1 - blend) + blend * blend);
}

PixelImage project(const View& view, const Scene& scene, const NoisePyramid& noise)
{
    const Camera& camera = view.camera;
    PixelImage image(camera.width, camera.height);
    const SurfaceMesh& mesh = scene.surface;
    const glm::dvec3 eye = camera.positionWorld - mesh.originWorld;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const double xs = (x + 0.5 - 0.5 * camera.width) / camera.focalPx,
                         ys = (y + 0.5 - 0.5 * camera.height) / camera.focalPx;
            const glm::dvec3 ray = camera.forward + xs * camera.right - ys * camera.up;
            const Hit hit = nearestHit(scene, eye, ray, camera.nearDepth, camera.farDepth);
            if (hit.triangle < 0) continue;
            Pixel& p = image.at(x, y);
            const auto& t = mesh.triangles[std::size_t(hit.triangle)];
            const glm::dvec3 position = eye + hit.depth * ray;
            const glm::dvec3 p0(mesh.positions[t[0]]);
            const glm::dvec3 facet =
                glm::cross(glm::dvec3(mesh.positions[t[1]]) - p0, glm::dvec3(mesh.positions[t[2]]) - p0);
            const double offset = glm::dot(facet, p0 - eye);
            const glm::dvec3 normal = glm::normalize(interpolate(mesh.normals, t, hit.u, hit.v));
            const double facing = -glm::dot(normal, glm::normalize(position - eye));
            const glm::dvec3 soft = double(shading::kSoftRight) * camera.right + double(shading::kSoftUp) * camera.up +
                                    double(shading::kSoftForward) * camera.forward;
            const double turned = std::clamp(double(shading::kSoftTurn) * facing, -1.0, 1.0) * glm::dot(normal, soft);
            p.triangle = hit.triangle;
            p.invDepth = view.unitWorld / hit.depth;
            p.gradX = view.unitWorld * glm::dot(facet, camera.right) / (offset * camera.focalPx);
            p.gradY = -view.unitWorld * glm::dot(facet, camera.up) / (offset * camera.focalPx);
            p.light = double(shading::kAmbient) + double(shading::kDiffuse) * std::abs(facing) +
                      double(shading::kSoft) * 0.5 * (1 + turned);

            const SceneSurface surface = mesh.surfaceOf.empty() ? SceneSurface{} : scene.surfaces[mesh.surfaceOf[t[0]]];
            glm::dvec3 v(0);
            if (scene.field && !surface.ownVectors)
                v = sampleField(*scene.field, position + mesh.originWorld);
            else if (!mesh.cellVectors.empty())
                v = glm::dvec3(mesh.cellVectors[std::size_t(hit.triangle)]);
            else if (!mesh.pointVectors.empty())
                v = interpolate(mesh.pointVectors, t, hit.u, hit.v);
            p.hasFlow = std::isfinite(v.x + v.y + v.z);
            if (needsNormal(scene.ofVectors) && !surface.ownScalar)
                p.scalar = scene.ofVectors == ArrayPart::normal ? glm::dot(v, normal)
                                                                : glm::length(v - normal * glm::dot(v, normal));
            else if (scene.ofVectors == ArrayPart::length && !surface.ownScalar)
                p.scalar = glm::length(sampleField(*scene.field, position + mesh.originWorld));
            else if (scene.scalarField && !surface.ownScalar)
                p.scalar = sampleField(*scene.scalarField, position + mesh.originWorld).x;
            else if (!mesh.cellScalars.empty())
                p.scalar = double(mesh.cellScalars[std::size_t(hit.triangle)]);
            else if (!mesh.pointScalars.empty())
                p.scalar = double(interpolate(mesh.pointScalars, t, hit.u, hit.v));
            if (!p.hasFlow) continue;
            v *= double(view.vectorFactor);
            if (glm::length(v) < double(view.maskBelow)) p.light = -p.light;

            const glm::dvec3 tangent = v - normal * glm::dot(normal, v);
            const double length = glm::length(tangent);
            glm::dvec3 step = tangent * double(view.vectorScale);
            if (view.normalize)
                step = length > double(view.tinyVector) ? tangent * (double(view.stepLocal) / length) : glm::dvec3(0);
            const double along = glm::dot(step, camera.forward), pixels = camera.focalPx * p.invDepth;
            p.vx = pixels * (glm::dot(step, camera.right) - xs * along);
            p.vy = -pixels * (glm::dot(step, camera.up) + ys * along);
            const double speed = std::hypot(p.vx, p.vy);
            if (speed > double(view.maxStepPx)) {
                p.vx *= double(view.maxStepPx) / speed;
                p.vy *= double(view.maxStepPx) / speed;
            }
            const double footprint =
                1 / (camera.focalPx * p.invDepth * std::sqrt(std::max(std::abs(facing), 1.0 / 16)));
            const double fade =
                view.fadePerVector > 0 ? std::sqrt(std::min(length * double(view.fadePerVector), 1.0)) : 1.0;
            p.noise = std::clamp(fade * noiseAt(noise, view.noise, position / view.unitWorld, footprint), -1.0, 1.0);
        }
    link(view, image);
    return image;
}

PixelImage fromGBuffer(const GBuffer& buffer)
{
    const Extent& valid = buffer.valid();
    PixelImage image(valid.width(), valid.height());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            Pixel& p = image.at(x, y);
            const int gx = x + valid.x0, gy = y + valid.y0;
            p.invDepth = double(buffer.invDepth.at(gx, gy));
            if (p.invDepth <= 0) continue;
            p.gradX = double(buffer.gradX.at(gx, gy));
            p.gradY = double(buffer.gradY.at(gx, gy));
            p.light = double(buffer.light.at(gx, gy));
            if (buffer.scalar.valid() == valid) p.scalar = double(buffer.scalar.at(gx, gy));
            const std::uint32_t texel = buffer.flow.at(gx, gy);
            p.hasFlow = texel != 0;
            if (!p.hasFlow) continue;
            p.vx = flow_texel::dx(texel) * double(buffer.flowUnitPx);
            p.vy = flow_texel::dy(texel) * double(buffer.flowUnitPx);
            p.noise = (flow_texel::noise(texel) - flow_texel::kNoiseZero) * double(flow_texel::kNoiseUnit);
            for (int sy = -1; sy <= 1; ++sy)
                for (int sx = -1; sx <= 1; ++sx)
                    if (sx != 0 || sy != 0)
                        p.linked[std::size_t((sy + 1) * 3 + sx + 1)] = buffer.links.at(gx, gy) >> linkBit(sx, sy) & 1;
        }
    return image;
}

}  // namespace aeolic::reference
