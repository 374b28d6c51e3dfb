#include "reader/file_server.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <span>
#include <stdexcept>

#include "aeolic/error.h"
#include "data/vtk/reader_messages.h"
#include "reader/answer_files.h"
#include "reader/answers.h"
#include "reader/memory_limit.h"
#include "reader/vtk/format_registry.h"

namespace aeolic {
namespace {

constexpr const char* kLarger = "an undamaged file, a smaller one or a larger machine";

void tellProgress(const char*, double fraction, void* context)
{
    static_cast<const PacketSocket*>(context)->send(PacketKind::progress, std::as_bytes(std::span(&fraction, 1)));
}

FileFacts factsOf(DataFile& file)
{
    FileFacts facts;
    facts.announcesArrays = file.announcesArrays();
    facts.arraysByParts = file.readsFloats();
    if (facts.announcesArrays && !facts.arraysByParts) facts.arrays = file.announcedArrays();
    facts.parts = file.parts();
    facts.timeSteps = file.timeSteps();
    facts.wholeExtent = file.wholeExtent();
    facts.spacingWorld = file.imageSpacing();
    return facts;
}

}  // namespace

void FileServer::serve()
{
    try {
        for (;;)
            if (const auto packet = caller_.receive(-1)) answer(*packet);
    } catch (const LostPeer&) {
    }
}

void FileServer::answer(const Packet& packet)
{
    const auto refuse = [&](const std::string& text) {
        caller_.send(PacketKind::refusal, std::as_bytes(std::span(text)));
    };
    try {
        ByteReader message(packet.bytes);
        if (packet.kind == PacketKind::open) return open(message);
        if (packet.kind == PacketKind::look) return look(message);
        if (!file_ && packet.kind != PacketKind::close) throw LostPeer();
        if (packet.kind == PacketKind::arrays) tellArrays(message);
        if (packet.kind == PacketKind::read) read(message);
        if (packet.kind == PacketKind::close) {
            file_.reset();
            caller_.send(PacketKind::answer);
        }
    } catch (const LostPeer&) {
        throw;
    } catch (const InputError& error) {
        refuse(error.what());
    } catch (const TooLong& error) {
        refuse(InputError(path_, error.what(), "a file of fewer parts and arrays").what());
    } catch (const std::bad_alloc&) {
        refuse(InputError(path_, "there is not enough memory to read it", kLarger).what());
    } catch (const std::length_error&) {  // More than any machine has.
        refuse(InputError(path_, "there is not enough memory to read it", kLarger).what());
    }
}

/// Relative names start from the caller's folder.
void FileServer::enter(const std::string& folder, const std::string& path)
{
    path_ = path;
    const bool isThere = !folder.empty() && chdir(folder.c_str()) == 0;
    if (!isThere && std::filesystem::path(path).is_relative())
        throw InputError(path, "no such file: the current folder is gone", "a file that can be read");
}

void FileServer::look(ByteReader& message)
{
    LookRequest request;
    message.read(request);
    file_.reset();
    enter(request.folder, request.path);
    limitMemory(mostMemoryOf(request.path));
    ByteWriter answer;
    addAnswer(answer, request, {tellProgress, const_cast<PacketSocket*>(&caller_)});
    send(answer);
}

void FileServer::open(ByteReader& message)
{
    OpenRequest request;
    message.read(request);
    file_.reset();
    enter(request.folder, request.path);
    limitMemory(mostMemoryOf(request.path));
    file_ = std::make_unique<DataFile>(request.path, request.use, request.time);
    ByteWriter answer;
    answer.add(factsOf(*file_));
    send(answer);
}

void FileServer::tellArrays(ByteReader& message)
{
    ArraysRequest request;
    message.read(request);
    file_->keepParts(request.parts);
    file_->requireAtTime(request.atTime);
    ByteWriter answer;
    answer.add(file_->announcedArrays());
    send(answer);
}

void FileServer::read(ByteReader& message)
{
    ReadRequest request;
    message.read(request);
    file_->keepParts(request.parts);
    if (request.arrays) file_->keepOnly(*request.arrays);
    if (request.polyhedra) file_->keepPolyhedra();
    const ProgressReport progress{tellProgress, const_cast<PacketSocket*>(&caller_)};
    AnswerFiles files;
    ByteWriter answer;
    {
        const auto data =
            request.pieces ? file_->readPieces(*request.pieces) : file_->read(progress, "reading", request.extent);
        addData(answer, data, files);
    }
    file_->forget();
    const std::vector<int> all = files.descriptors();
    for (std::size_t i = 0; i < all.size(); i += PacketSocket::kMostFiles)
        caller_.send(PacketKind::memory, {},
                     std::span(all).subspan(i, std::min(PacketSocket::kMostFiles, all.size() - i)));
    send(answer);
}

void FileServer::send(ByteWriter& message)
{
    const Bytes bytes = message.take();
    caller_.send(PacketKind::answer, bytes);
}

}  // namespace aeolic
