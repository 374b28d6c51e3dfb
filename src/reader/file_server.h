#pragma once

#include <memory>
#include <string>

#include "base/byte_message.h"
#include "data/reading/packet_socket.h"
#include "reader/vtk/data_file.h"

namespace aeolic {

/// Answers what a caller asks of files, one after the other (PacketKind).
class FileServer {
public:
    explicit FileServer(const PacketSocket& caller) : caller_(caller) {}

    /// Until the caller has gone.
    void serve();

private:
    void answer(const Packet& packet);
    void enter(const std::string& folder, const std::string& path);
    void look(ByteReader& message, ByteWriter& answer);
    void open(ByteReader& message, ByteWriter& answer);
    void tellArrays(ByteReader& message, ByteWriter& answer);
    void read(ByteReader& message, ByteWriter& answer);

    const PacketSocket& caller_;
    std::string path_;  // Of the file that is read.
    std::unique_ptr<DataFile> file_;
};

}  // namespace aeolic
