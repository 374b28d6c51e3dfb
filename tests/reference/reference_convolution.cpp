#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/reference.h"
#include "render/lic/lic_kernel.h"
#include "render/limits.h"

namespace aeolic::reference {
namespace {

struct Sample {
    double vx = 0, vy = 0, noise = 0;
    double widening = 0;  // By how much a stream tube widens on a step downstream: ln of the ratio of its widths.
};

// A trace: where it is, and the pixel of its sheet nearest to it.
struct Trace {
    double x, y;  // Pixel coordinates; integers are pixel centres.
    int pixelX, pixelY;
    bool alive = true;
};

int nearest(double v)
{
    return int(std::floor(v + 0.5));
}

// Walks from the trace's pixel to the one nearest (x, y) along links; false where one is missing.
bool follow(const PixelImage& image, Trace& t, double x, double y)
{
    const int toX = nearest(x), toY = nearest(y);
    while (t.pixelX != toX || t.pixelY != toY) {
        const int hopX = (toX > t.pixelX) - (toX < t.pixelX), hopY = (toY > t.pixelY) - (toY < t.pixelY);
        if (!image.at(t.pixelX, t.pixelY).linked[std::size_t((hopY + 1) * 3 + hopX + 1)]) return t.alive = false;
        t.pixelX += hopX;
        t.pixelY += hopY;
    }
    return true;
}

// How a tube widens where the flow is v, and changes by (ax, ay) a pixel to the right and by (bx, by) a pixel down: the
// divergence of the unit direction, times the step.
double wideningOf(double vx, double vy, double ax, double ay, double bx, double by)
{
    const double squared = vx * vx + vy * vy;
    return squared > 0 ? (vy * (vy * ax - vx * bx) + vx * (vx * by - vy * ay)) / squared : 0;
}

// Bilinear among the pixels linked to the nearest. Moves the trace's pixel; kills it where it cannot go.
Sample sample(const PixelImage& image, Trace& t, double x, double y)
{
    Sample s;
    if (!t.alive || !follow(image, t, x, y)) return s;
    const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
    double total = 0;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i) {
            const int dx = x0 + i - t.pixelX, dy = y0 + j - t.pixelY;
            const bool self = dx == 0 && dy == 0;
            if (!self && !image.at(t.pixelX, t.pixelY).linked[std::size_t((dy + 1) * 3 + dx + 1)]) continue;
            const double w = (i ? x - x0 : 1 - (x - x0)) * (j ? y - y0 : 1 - (y - y0));
            const Pixel& p = image.at(x0 + i, y0 + j);
            s.vx += w * p.vx;
            s.vy += w * p.vy;
            s.noise += w * p.noise;
            total += w;
        }
    s.vx /= total;
    s.vy /= total;
    s.noise /= total;
    const auto& linked = image.at(t.pixelX, t.pixelY).linked;
    if (std::count(linked.begin(), linked.end(), true) >= 8) {  // Differences across an edge tell nothing.
        const Pixel &p00 = image.at(x0, y0), &p10 = image.at(x0 + 1, y0), &p01 = image.at(x0, y0 + 1),
                    &p11 = image.at(x0 + 1, y0 + 1);
        const auto between = [](double from, double to, double w) { return from + w * (to - from); };
        s.widening = wideningOf(s.vx, s.vy, between(p10.vx - p00.vx, p11.vx - p01.vx, y - y0),
                                between(p10.vy - p00.vy, p11.vy - p01.vy, y - y0),
                                between(p01.vx - p00.vx, p11.vx - p10.vx, x - x0),
                                between(p01.vy - p00.vy, p11.vy - p10.vy, x - x0));
    }
    return s;
}

// One Runge-Kutta step of length h (in steps, signed); leaves the flow at the new place in `at`. Returns its length in
// pixels.
double step(const PixelImage& image, Integrator integrator, double h, Trace& t, Sample& at)
{
    const double x = t.x, y = t.y;
    Sample v = at;
    if (integrator == Integrator::rk2) {
        v = sample(image, t, x + 0.5 * h * at.vx, y + 0.5 * h * at.vy);
    } else if (integrator == Integrator::rk4) {
        const Sample k2 = sample(image, t, x + 0.5 * h * at.vx, y + 0.5 * h * at.vy);
        const Sample k3 = sample(image, t, x + 0.5 * h * k2.vx, y + 0.5 * h * k2.vy);
        const Sample k4 = sample(image, t, x + h * k3.vx, y + h * k3.vy);
        v = {(at.vx + 2 * k2.vx + 2 * k3.vx + k4.vx) / 6, (at.vy + 2 * k2.vy + 2 * k3.vy + k4.vy) / 6, 0};
    }
    t.x = x + h * v.vx;
    t.y = y + h * v.vy;
    at = sample(image, t, t.x, t.y);
    return std::abs(h) * std::hypot(v.vx, v.vy);
}

double kernelWeight(const LicOptions& lic, double i)
{
    const double wave = std::cos(std::numbers::pi * i / (lic.steps + 0.5) - lic.phase);
    if (lic.style == Style::oriented) return 0.5 * (lic.flow == FlowMotion::loop ? wave : 1 - i / lic.steps);
    return lic.kernel == Kernel::box ? 1 : 0.5 * (1 + wave);
}

/// What brings a Hann kernel of another phase than 0 to the contrast of phase 0: from its squared weight between the
/// ends of the streamline, given as parts of the kernel's length on either side.
double phaseGain(const LicOptions& lic, double ahead, double behind)
{
    const auto squaredWeight = [&](double phase) {
        constexpr int parts = 100;
        double sum = 0;
        for (int i = 0; i < parts; ++i) {
            const double at = -behind + (ahead + behind) * (i + 0.5) / parts;
            sum += std::pow(0.5 * (1 + std::cos(std::numbers::pi * at - phase)), 2);
        }
        return sum;
    };
    return std::min(std::sqrt(squaredWeight(0) / squaredWeight(lic.phase)), double(kMostPhaseGain));
}

}  // namespace

std::vector<double> convolve(const PixelImage& image, const LicOptions& lic, int substeps)
{
    const ContrastModel contrast = makeContrastModel(lic);
    std::vector<double> out(image.pixels.size(), 0.0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Pixel& origin = image.at(x, y);
            if (!origin.hasFlow) continue;
            const double own = std::max(std::hypot(origin.vx, origin.vy), double(kShortestOwnPx));
            double sum = kernelWeight(lic, 0) * own * origin.noise, length = own, squares = own;
            double shares[2] = {};
            for (const int direction : {1, -1}) {
                Trace t{double(x), double(y), x, y};
                Sample at{origin.vx, origin.vy, origin.noise};
                double width = 1, walked = 0;
                for (int i = 1; i <= lic.steps * substeps; ++i) {
                    const Sample before = at;
                    const double ds = step(image, lic.integrator, direction / double(substeps), t, at);
                    if (!t.alive) break;
                    const double narrows =
                        std::max(-direction * at.widening - double(limits::kSteadyWidth), 0.0) / substeps;
                    const double half = lic.streaks == Streaks::even ? std::exp(-0.5 * narrows) : 1;
                    width *= half;
                    sum += kernelWeight(lic, direction * double(i) / substeps) * width * ds * at.noise;
                    walked += width * ds;
                    width *= half;
                    if (before.vx * at.vx + before.vy * at.vy < 1e-12)
                        break;  // Vanished, or turned round: a critical point.
                }
                length += walked;
                squares += 0.5 * walked * (1 + width);
                shares[direction < 0] = std::min((walked + 0.5 * own) / (own * lic.steps), 1.0);
            }
            const double pixels = length * length / squares;
            const double gain =
                std::pow(double(contrast.zeroLength) + pixels * pixels * double(contrast.perLength), 0.25);
            out[std::size_t(y) * std::size_t(image.width) + std::size_t(x)] =
                gain * double(contrast.inverseMeanWeight) * sum / length *
                (contrast.phased() ? phaseGain(lic, shares[0], shares[1]) : 1);
        }
    return out;
}

}  // namespace aeolic::reference
