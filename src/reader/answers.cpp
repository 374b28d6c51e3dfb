#include "reader/answers.h"

#include "data/named_file.h"
#include "data/reading/packet_socket.h"
#include "reader/vtk/color_map_xml.h"
#include "reader/vtk/format_registry.h"
#include "reader/vtk/summarize.h"

namespace aeolic {
namespace {

/// What the kind of file can be asked. Throws LostPeer where it cannot: no caller asks it then.
template <class Ask>
Ask asked(const std::string& path, Ask FormatReader::*question)
{
    const FileKind* kind = namedKind(path);
    const Ask ask = kind ? formatOf(*kind).*question : nullptr;
    if (!ask) throw LostPeer();
    return ask;
}

}  // namespace

void addAnswer(ByteWriter& message, const LookRequest& request, const ProgressReport& progress)
{
    const std::string& path = request.path;
    switch (request.question) {
        case Question::listedFiles:
            checkReadableFile(path);
            return message.add(asked(path, &FormatReader::listed)(path));
        case Question::timesOfCase:
            return message.add(asked(path, &FormatReader::times)(path, request.words));
        case Question::pieces:
            return message.add(asked(path, &FormatReader::pieces)(path, request.use, request.words));
        case Question::surfaceCounts:
            return message.add(asked(path, &FormatReader::counts)(path));
        case Question::summary:
            return message.add(summaryOf(path, progress));
        case Question::colorPoints:
            return message.add(colorPointsInXml(request.words.at(0), path));
    }
    throw LostPeer();
}

}  // namespace aeolic
