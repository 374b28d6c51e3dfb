#include "codecs/codecs_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "description/choices.h"
#include "version.h"

namespace aeolic {
namespace {

using Json = nlohmann::ordered_json;

struct Line {
    const char* name;
    const char* key;
    double bitsPerS;
};
constexpr Line kLines[] = {
    {"10 Mbit/s", "10_mbit_s", 10e6}, {"100 Mbit/s", "100_mbit_s", 100e6}, {"1 Gbit/s", "1_gbit_s", 1e9}};

std::string heading(const CodecsBenchPlan& plan, const CodecsBench& bench)
{
    const SceneDescription& scene = plan.scene;
    const OutputOptions& output = scene.output;
    std::string text = fmt::format("{}: {}, threads: {}\n", bench.backend, bench.device, bench.threads);
    text += fmt::format("surface {}, field {}, {}\n", scene.surface.spec,
                        scene.field.spec.empty() ? "the surface's own" : scene.field.spec,
                        scene.shading.colorBy.empty() ? "no colour" : "coloured by " + scene.shading.colorBy);
    text +=
        fmt::format("views: {} of {}x{}, {} bytes a pixel; the surface covers {:.0f} % of them; medians of {}\n",
                    output.frames, output.width, output.height, bench.channels, 100 * bench.coveredShare, plan.repeats);
    return text;
}

std::string rowLine(const CodecsBenchPlan& plan, const CodecsBench& bench, const CodecsBenchRow& row,
                    const CodecCost& cost)
{
    const std::string name = std::string(codecName(row.codec)) + (row.quality ? fmt::format(" {}", row.quality) : "");
    std::string text =
        fmt::format("{:<9}{:>7.2f}{:>9}{:>9.0f}{:>9.0f}", name, double(bench.pixelBytes) / double(cost.encodedBytes),
                    row.quality ? fmt::format("{:.1f}", row.psnrDb) : "exact", bench.mbPerS(cost.encodeMs),
                    bench.mbPerS(cost.decodeMs));
    for (const Line& line : kLines)
        text += fmt::format("{:>13.1f}", msToViewer(cost, plan.scene.output.frames, line.bitsPerS));
    return text + "\n";
}

std::string columns(const std::string& title)
{
    std::string text = fmt::format("\n{}\n{:<9}{:>7}{:>9}{:>18}{:>39}\n", title, "", "", "PSNR", "pixel MB/s",
                                   "ms from drawn to decoded, over");
    text += fmt::format("{:<9}{:>7}{:>9}{:>9}{:>9}", "codec", "ratio", "dB", "encode", "decode");
    for (const Line& line : kLines) text += fmt::format("{:>13}", line.name);
    return text + "\n";
}

Json costJson(const CodecsBenchPlan& plan, const CodecsBench& bench, const CodecCost& cost)
{
    Json toViewer;
    for (const Line& line : kLines) toViewer[line.key] = msToViewer(cost, plan.scene.output.frames, line.bitsPerS);
    return {{"encoded_bytes", cost.encodedBytes},
            {"ratio", double(bench.pixelBytes) / double(cost.encodedBytes)},
            {"encode_mb_per_s", bench.mbPerS(cost.encodeMs)},
            {"decode_mb_per_s", bench.mbPerS(cost.decodeMs)},
            {"ms_to_viewer", toViewer}};
}

Json rowJson(const CodecsBenchPlan& plan, const CodecsBench& bench, const CodecsBenchRow& row)
{
    Json json{{"codec", codecName(row.codec)}};
    json["quality"] = row.quality ? Json(row.quality) : Json();
    json["psnr_db"] = row.quality ? Json(row.psnrDb) : Json();
    json["one_piece"] = costJson(plan, bench, row.whole.value_or(CodecCost{}));
    json["bands"] = costJson(plan, bench, row.bands);
    return json;
}

}  // namespace

std::string CodecsTables::next(const CodecsBench& soFar)
{
    std::string text;
    if (!std::exchange(begun_, true))
        text = heading(plan_, soFar) + columns(fmt::format("In bands of {} rows, on all threads:", plan_.bandRows));
    for (; bandRows_ < soFar.rows.size(); ++bandRows_) {
        const CodecsBenchRow& row = soFar.rows[bandRows_];
        text += rowLine(plan_, soFar, row, row.bands);
    }
    for (; wholeRows_ < soFar.rows.size() && soFar.rows[wholeRows_].whole; ++wholeRows_) {
        const CodecsBenchRow& row = soFar.rows[wholeRows_];
        if (wholeRows_ == 0) text += columns("In one piece, on one thread:");
        text += rowLine(plan_, soFar, row, *row.whole);
    }
    return text;
}

std::string CodecsTables::notes(const CodecsBench& all)
{
    std::string text =
        "\nratio: bytes of pixels to bytes encoded. MB/s: of pixels, 10^6 bytes. PSNR: what the bands lose.\n"
        "ms: one view encoded, then sent, then decoded, one after the other, without the line's latency.\n";
    if (all.channels == 4) text += "Without jpeg, which keeps no alpha.\n";
    return text;
}

std::string codecsJson(const CodecsBenchPlan& plan, const CodecsBench& bench)
{
    const SceneDescription& scene = plan.scene;
    Json rows = Json::array();
    for (const CodecsBenchRow& row : bench.rows) rows.push_back(rowJson(plan, bench, row));
    const Json document{{"version", versionText},
                        {"machine", {{"backend", bench.backend}, {"device", bench.device}, {"threads", bench.threads}}},
                        {"scene",
                         {{"surface", scene.surface.spec},
                          {"field", scene.field.spec},
                          {"color_by", scene.shading.colorBy},
                          {"method", nameOf(scene.lic.method)},
                          {"size", {scene.output.width, scene.output.height}},
                          {"views", scene.output.frames},
                          {"covered", bench.coveredShare},
                          {"bytes_per_pixel", bench.channels},
                          {"pixel_bytes", bench.pixelBytes}}},
                        {"repeats", plan.repeats},
                        {"band_rows", plan.bandRows},
                        {"rows", rows}};
    return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aeolic
