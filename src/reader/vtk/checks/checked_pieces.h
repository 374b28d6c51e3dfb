#pragma once

#include <vtkDataSet.h>
#include <vtkXMLDataReader.h>

namespace aeolic {

/// One of VTK's readers of structured data in pieces. VTK copies samples out of a piece that could not be read, for
/// example because its values cannot be unpacked, and crashes. This one stops there.
template <class Reader>
class CheckedPieces : public Reader {
public:
    static CheckedPieces* New()
    {
        auto* reader = new CheckedPieces;
        reader->InitializeObjectBase();
        return reader;
    }

protected:
    CheckedPieces() = default;

    int ReadPieceData() override
    {
        vtkXMLDataReader* piece = this->PieceReaders[this->Piece];
        if (piece) piece->UpdateExtent(this->SubExtent);
        vtkDataSet* data = piece ? piece->GetOutputAsDataSet() : nullptr;
        if (data && data->GetNumberOfPoints() > 0) return Reader::ReadPieceData();
        vtkErrorWithObjectMacro(this, "Cannot read piece " << this->Piece);
        return 0;
    }
};

}  // namespace aeolic
