#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "aeolic/scene_description.h"
#include "stream/codec/codec.h"
#include "stream/wire.h"

namespace aeolic::stream {

using Json = nlohmann::ordered_json;

/// Reads a JSON payload: one object, not nested deeper than any object of the protocol. Throws ProtocolError.
Json parseJson(ByteView payload);
inline Json parseJson(std::string_view text)
{
    return parseJson(ByteView(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

/// The text of a JSON message. What is not UTF-8 is replaced.
inline std::string jsonText(const Json& json)
{
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// What a viewer says about itself. helloFrom() throws ProtocolError where it is not as docs/protocol.md says.
struct Hello {
    std::vector<Codec> codecs;  ///< Codecs that this build has too; png is among them.
    bool direct = false;
    std::string name;  ///< Printable, at most 64 bytes.
};
Hello helloFrom(const Json& json);

/// A viewer's view. Camera, LIC and shading stay JSON until a scene is known to lay them over.
struct ViewRequest {  // NOLINT(bugprone-exception-escape): JSON takes memory where it is freed.
    std::uint32_t view = 0;
    bool moving = false;
    int width = 1, height = 1;
    Json options;  ///< {"camera":…,"lic":…,"shading":…}, any of them left out.
    /// The camera is that of the scene that is loaded when it is drawn, so many times as far from its focal point.
    std::optional<double> home;
};
/// Throws ProtocolError. Sizes over `largestSide` are reduced to it in proportion.
ViewRequest viewFrom(const Json& json, int largestSide);

/// A viewer asks what its view shows at a pixel, counted from the upper left.
struct PickRequest {  // NOLINT(bugprone-exception-escape): as in ViewRequest.
    ViewRequest view;
    int x = 0, y = 0;
};
/// Throws ProtocolError. Where the view's size is reduced, so is the pixel's place.
PickRequest pickFrom(Json json, int largestSide);

/// How many samples of the noise one picture of the scene takes at most: pixels times integration steps, both ways, for
/// the direct method; pixels times levels of jumps for the hierarchical one. What a picture costs follows from that.
std::uint64_t samplesOf(const SceneDescription& scene);

/// 4096 x 4096 pixels with 512 direct steps each way: minutes on two cores.
inline constexpr std::uint64_t kMostSamples = std::uint64_t{1} << 34;

/// The scene with a view's options, of that size. Throws InputError naming the field where an option is wrong.
SceneDescription withView(const SceneDescription& scene, const ViewRequest& view, int width, int height);

/// The view with the camera that `home` asks for; `ofScene`: the view that the Scene has, or null.
ViewRequest fromHome(ViewRequest view, const Json& ofScene);

/// A change of the scene that all viewers share.
struct ChangeRequest {  // NOLINT(bugprone-exception-escape): as in ViewRequest.
    std::optional<std::string> surface, vectors, colorBy;
    std::optional<double> time;
    std::optional<std::vector<bool>> shown;  ///< Which of the scene's surfaces are.
    /// The surface cut out of the field at that place among the scene's surfaces; nothing: an added one goes again.
    std::map<std::size_t, std::optional<std::string>> cuts;
    std::optional<std::uint32_t> places;  ///< That of the Scene by which `shown` and `cuts` count surfaces.
    Json steer;                ///< Names of a program's controls, and the number that each shall have; null: none.
    std::uint32_t number = 0;  ///< The viewer's own, which comes back with Changed.
    bool moving = false;       ///< More changes will follow soon.
};
ChangeRequest changeFrom(const Json& json);

/// Lays the wishes of a newer change over those of an older one.
void merge(ChangeRequest& older, ChangeRequest newer);

/// `scene` changed; `original` is the server's first scene. Surfaces that viewers add stand behind its own. The
/// result has passed validate(). Throws InputError where it does not, and for a surface that is neither the original
/// nor cut out of the field: a viewer names no file.
SceneDescription withChange(const SceneDescription& scene, const SceneDescription& original,
                            const ChangeRequest& change);

/// What Scene calls the surface that is shown: "original", or what a viewer has chosen last.
std::string surfaceName(const SceneDescription& scene, const SceneDescription& original);

/// Whether one follows from the other by showing another moment, or others of the surfaces: nothing is loaded for that.
bool differInWhatIsShown(const SceneDescription& a, const SceneDescription& b);

/// One frame that the job has to draw. As text it is the payload of Draw.
struct DrawRequest {
    std::uint32_t frame = 0, viewer = 0, view = 0, askedWidth = 0;
    Codec codec = Codec::png;
    int quality = 80;
    bool direct = false;     ///< Tiles go to the viewer itself where it is connected.
    SceneDescription scene;  ///< Only camera, LIC, shading and size are looked at.
};
std::string drawToJson(const DrawRequest& draw);
DrawRequest drawFrom(const Json& json);

/// What the job is asked of a viewer's pixel. As text it is the payload of Probe.
struct ProbeRequest {
    std::uint32_t viewer = 0, view = 0;
    int x = 0, y = 0;
    SceneDescription scene;  ///< Only camera and size are looked at.
};
std::string probeToJson(const ProbeRequest& probe);
ProbeRequest probeFrom(const Json& json);

}  // namespace aeolic::stream
