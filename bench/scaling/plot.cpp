#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "description/choices.h"
#include "render/overlay/ticks.h"
#include "scaling/paper.h"
#include "scaling/scaling_report.h"

namespace aeolic {
namespace {

constexpr double kWidth = 940, kHeight = 600;
constexpr double kLeft = 76, kRight = 660, kTop = 92, kBottom = 520;  // The axes' box.
constexpr double kLegendX = 690;
constexpr const char* kInk = "#1f2933";
constexpr const char* kFaint = "#616e7c";

// The colour blind can tell them apart too (Okabe and Ito).
std::string_view colorOf(std::string_view balance)
{
    if (balance == "static") return "#d98200";
    if (balance == "timing") return "#009e73";
    if (balance == "pixels") return "#b5488a";
    return "#0072b2";
}

struct Point {
    double nodes, speedup;
};

struct Curve {
    std::string name;
    std::string_view color;
    bool ours;
    std::vector<Point> points;
};

class Axes {
public:
    Axes(double mostNodes, double mostSpeedup) : mostNodes_(mostNodes), mostSpeedup_(mostSpeedup) {}

    double mostNodes() const { return mostNodes_; }
    double mostSpeedup() const { return mostSpeedup_; }
    double x(double nodes) const { return kLeft + (kRight - kLeft) * nodes / (mostNodes_ * 1.03); }
    double y(double speedup) const { return kBottom - (kBottom - kTop) * speedup / mostSpeedup_; }

private:
    double mostNodes_, mostSpeedup_;
};

std::string escaped(std::string_view text)
{
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else
            out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return out;
}

std::string label(double x, double y, int size, const char* color, const char* anchor, std::string_view text,
                  const char* more = "")
{
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
                       x, y, size, color, anchor, more, escaped(text));
}

std::string line(double x0, double y0, double x1, double y1, std::string_view color, double width,
                 const char* dashes = "")
{
    return fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", x0, y0,
        x1, y1, color, width, dashes);
}

/// A dot on our full lines, an open square on the paper's dashed ones.
std::string marker(double x, double y, const Curve& curve)
{
    if (curve.ours)
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.2\" fill=\"{}\"/>\n", x, y, curve.color);
    return fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"7\" height=\"7\" fill=\"#ffffff\" stroke=\"{}\" "
        "stroke-width=\"1.4\"/>\n",
        x - 3.5, y - 3.5, curve.color);
}

const char* dashesOf(const Curve& curve)
{
    return curve.ours ? "" : " stroke-dasharray=\"5 4\"";
}

std::string drawCurve(const Curve& curve, const Axes& axes)
{
    std::string points, markers;
    for (const Point& p : curve.points) {
        points += fmt::format("{:.1f},{:.1f} ", axes.x(p.nodes), axes.y(p.speedup));
        markers += marker(axes.x(p.nodes), axes.y(p.speedup), curve);
    }
    return fmt::format(
               "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
               "stroke-linejoin=\"round\"{}/>\n",
               points, curve.color, curve.ours ? 2.4 : 1.4, dashesOf(curve)) +
           markers;
}

std::vector<Curve> curvesOf(const ScalingBenchPlan& plan, const ScalingBench& bench)
{
    std::vector<Curve> curves;
    for (const std::string& balance : plan.balancers)
        if (paper::table1(balance, 1)) {
            Curve curve{balance, colorOf(balance), false, {}};
            for (int n = 1; const auto there = paper::table1(balance, n); ++n)
                curve.points.push_back({double(n), *there / *paper::table1(balance, 1)});
            curves.push_back(curve);
        }
    for (const std::string& balance : plan.balancers) {
        Curve curve{balance, colorOf(balance), true, {{1, 1}}};
        for (const ScalingRow& row : bench.rows)
            if (row.part == ScalingPart::nodes && row.balance == balance && row.ranks > 1)
                curve.points.push_back({double(row.ranks), row.speedup.value_or(1)});
        curves.push_back(curve);
    }
    return curves;
}

Axes axesFor(const std::vector<Curve>& curves)
{
    double nodes = 2, speedup = 2;
    for (const Curve& curve : curves)
        for (const Point& p : curve.points) {
            nodes = std::max(nodes, p.nodes);
            speedup = std::max(speedup, p.speedup);
        }
    return {nodes, std::min(1.04 * std::max(speedup, nodes), 1.35 * speedup)};
}

std::string drawAxes(const Axes& axes)
{
    std::string svg;
    const Ticks across = niceTicks(1, axes.mostNodes(), 12), up = niceTicks(0, axes.mostSpeedup(), 10);
    for (std::size_t i = 0; i < up.values.size(); ++i) {
        const double y = axes.y(up.values[i]);
        if (up.values[i] > 0) svg += line(kLeft, y, kRight, y, "#e4e7eb", 1);
        svg += label(kLeft - 10, y + 4.5, 13, kFaint, "end", up.labels[i]);
    }
    std::vector<double> nodes = across.values;
    if (axes.mostNodes() <= 12) {
        nodes.clear();
        for (int n = 1; n <= int(axes.mostNodes()); ++n) nodes.push_back(n);
    }
    for (const double n : nodes) {
        svg += line(axes.x(n), kBottom, axes.x(n), kBottom + 5, kFaint, 1);
        svg += label(axes.x(n), kBottom + 22, 13, kFaint, "middle", fmt::format("{:g}", n));
    }
    svg += line(kLeft, kBottom, kRight, kBottom, kFaint, 1.2) + line(kLeft, kTop, kLeft, kBottom, kFaint, 1.2);
    svg += label(0.5 * (kLeft + kRight), kBottom + 46, 14, kInk, "middle", "nodes");
    const double middle = 0.5 * (kTop + kBottom);
    svg += label(26, middle, 14, kInk, "middle", "speedup over one node",
                 fmt::format(" transform=\"rotate(-90 26 {:.1f})\"", middle).c_str());
    const double end = std::min(axes.mostNodes(), axes.mostSpeedup());
    svg += line(axes.x(1), axes.y(1), axes.x(end), axes.y(end), "#9aa5b1", 1.3, " stroke-dasharray=\"2 4\"");
    svg += label(axes.x(0.93 * end) - 8, axes.y(0.93 * end) - 6, 13, kFaint, "end", "ideal");
    return svg;
}

std::string drawLegend(const std::vector<Curve>& curves)
{
    std::string svg;
    double y = kTop + 12;
    const auto group = [&](bool ours, const char* title) {
        if (std::none_of(curves.begin(), curves.end(), [&](const Curve& c) { return c.ours == ours; })) return;
        svg += label(kLegendX, y, 14, kInk, "start", title, " font-weight=\"600\"");
        y += 26;
        for (const Curve& curve : curves) {
            if (curve.ours != ours) continue;
            svg += line(kLegendX, y - 4.5, kLegendX + 38, y - 4.5, curve.color, ours ? 2.4 : 1.4, dashesOf(curve));
            svg += marker(kLegendX + 19, y - 4.5, curve);
            svg += label(kLegendX + 50, y, 14, kInk, "start", curve.name);
            const Point& last = curve.points.back();
            svg += label(kWidth - 26, y, 13, kFaint, "end",
                         fmt::format("{:.{}f} on {:g}", last.speedup, ours ? 2 : 1, last.nodes));
            y += 25;
        }
        y += 20;
    };
    group(true, "Aeolic, modelled");
    group(false, "Bachthaler et al. 2006");
    return svg;
}

}  // namespace

std::string scalingPlot(const ScalingBenchPlan& plan, const ScalingBench& bench)
{
    const SceneDescription& scene = plan.scene;
    const std::vector<Curve> curves = curvesOf(plan, bench);
    const Axes axes = axesFor(curves);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\" "
        "font-family=\"Helvetica, Arial, sans-serif\">\n<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"#ffffff\"/>\n",
        kWidth, kHeight);
    svg += label(kLeft, 40, 20, kInk, "start", "Frames on several nodes", " font-weight=\"600\"");
    svg += label(kLeft, 64, 14, kFaint, "start",
                 fmt::format("{} in {}, turning; {}x{}, {}, 2 x {} steps", scene.surface.spec,
                             scene.field.spec.empty() ? "its own vectors" : scene.field.spec, scene.output.width,
                             scene.output.height, nameOf(scene.lic.method), scene.lic.steps));
    svg += drawAxes(axes);
    for (const Curve& curve : curves) svg += drawCurve(curve, axes);
    svg += drawLegend(curves);
    svg += label(kLeft, kHeight - 12, 12, kFaint, "start",
                 fmt::format("Modelled: slowest rank's CPU time of every stage ({}), and a network of {}", bench.device,
                             networkText(plan.network)));
    return svg + "</svg>\n";
}

}  // namespace aeolic
