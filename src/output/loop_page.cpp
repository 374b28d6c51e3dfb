#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "base/embedded_file.h"
#include "base/text.h"
#include "output/animation.h"
#include "output/new_file.h"

extern "C" const aeolic::EmbeddedFile aeolicLoopFiles[];

namespace aeolic {
namespace {

std::string_view loopFile(std::string_view name)
{
    for (const EmbeddedFile* file = aeolicLoopFiles; file->name; ++file)
        if (name == file->name) return file->bytes();
    throw std::logic_error("no file of a loop's page has that name");
}

/// What plays the pictures: the page's modules as one script, without what they import from each other.
std::string playerScript()
{
    std::string script;
    for (const char* name :
         {"picture/cycle.js", "picture/cycle_gpu.js", "picture/cycle_painter.js", "picture/cycle_player.js"}) {
        std::istringstream lines{std::string(loopFile(name))};
        for (std::string line; std::getline(lines, line);)
            if (!line.starts_with("import ")) script += line + '\n';
    }
    return script;
}

std::string base64(const std::string& bytes)
{
    std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // The function ends it with a zero.
    const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                                       reinterpret_cast<const unsigned char*>(bytes.data()), int(bytes.size()));
    text.resize(std::size_t(length));
    return text;
}

/// A page that stands alone: the pictures of one cycle, and what plays them in a browser (web/picture/cycle_player.js).
class LoopPage : public Animation {
public:
    explicit LoopPage(const AnimationPlan& plan) : plan_(plan) {}

    void add(const Picture& picture) override
    {
        pictures_ += fmt::format("  'data:image/webp;base64,{}',\n", base64(lossyWebpOf(picture, plan_.path)));
        width_ = picture.width;
        height_ = picture.height;
    }

    void complete() override
    {
        const std::pair<std::string_view, std::string> values[] = {
            {"@TITLE@", xmlText(plan_.title)},
            {"@BACKGROUND@", plan_.background == "transparent" ? plan_.background : "#" + plan_.background},
            {"@WIDTH@", std::to_string(width_)},
            {"@HEIGHT@", std::to_string(height_)},
            {"@COUNT@", std::to_string(plan_.frames)},
            {"@SECONDS@", fmt::format("{}", plan_.frames / plan_.framesPerSecond)},
            {"@PLAYER@\n", playerScript()},
            {"@PICTURES@\n", pictures_},
        };
        NewFile file(plan_.path);
        std::string_view rest = loopFile("loop/loop.html");
        for (std::size_t at = rest.find('@'); at != rest.npos; at = rest.find('@')) {
            file.write(rest.substr(0, at));
            rest.remove_prefix(at);
            const auto* value = std::find_if(std::begin(values), std::end(values),
                                             [&](const auto& named) { return rest.starts_with(named.first); });
            const bool found = value != std::end(values);
            file.write(found ? std::string_view(value->second) : rest.substr(0, 1));
            rest.remove_prefix(found ? value->first.size() : 1);
        }
        file.write(rest);
        file.complete();
    }

private:
    AnimationPlan plan_;
    std::string pictures_;
    int width_ = 0, height_ = 0;
};

}  // namespace

std::unique_ptr<Animation> makeLoopPage(const AnimationPlan& plan)
{
    return std::make_unique<LoopPage>(plan);
}

}  // namespace aeolic
