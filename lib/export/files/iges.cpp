#include "base/error.h"
#include "export/files/boundary_files.h"

#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <Transfer_FinderProcess.hxx>
#include <algorithm>
#include <mutex>
#include <sstream>

#ifdef __SANITIZE_ADDRESS__
/// OpenCASCADE keeps tables until the process ends; what it leaves is no leak of ours.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libTK";
}
#endif

namespace qm {
namespace {

/// "19700101.000000" for "1970-01-01T00:00:00".
std::string igesDate(std::string date) {
    std::erase_if(date, [](char letter) { return letter == '-' || letter == ':'; });
    std::ranges::replace(date, 'T', '.');
    return date;
}

/// IGES knows no other letters. Of the bytes of a letter in UTF-8, all but the first begin with bits 10.
std::string asciiName(std::string name) {
    std::erase_if(name, [](char letter) { return (static_cast<unsigned char>(letter) & 0xC0U) == 0x80U; });
    std::ranges::replace_if(
        name, [](char letter) { return letter < ' ' || letter > '~'; }, '_');
    return name;
}

Handle(TCollection_HAsciiString) text(const std::string& value) {
    return new TCollection_HAsciiString(value.c_str());
}

/// OpenCASCADE keeps its settings for the whole program, and reports on standard output.
class Session {
public:
    Session() : lock_(mutex) {
        Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
        IGESControl_Controller::Init();
        Interface_Static::SetCVal("xstep.cascade.unit", "MM");
        Interface_Static::SetCVal("write.iges.unit", "MM");
        Interface_Static::SetIVal("write.iges.brep.mode", 1);
    }

private:
    static inline std::mutex mutex;
    std::lock_guard<std::mutex> lock_;
};

void labelFaces(const BoundaryShape& shape, const FaceOrigins& origins,
                const Handle(Transfer_FinderProcess) & process) {
    for (std::size_t k = 0; k < shape.faces.size(); ++k) {
        Handle(IGESData_IGESEntity) entity;
        const auto mapper = TransferBRep::ShapeMapper(process, shape.faces[k]);
        if (process->FindTypedTransient(mapper, STANDARD_TYPE(IGESData_IGESEntity), entity))
            entity->SetLabel(text("S" + std::to_string(origins[k].front())));
    }
}

} // namespace

std::string shapeAsIges(const BoundaryShape& shape, const FaceOrigins& origins,
                        const ExportOptions& options) {
    const Session session;
    // The writer would convert from millimetres; so it is given those, and the unit is declared afterwards.
    IGESControl_Writer writer("MM", 1);
    if (!writer.AddShape(shape.shape))
        throw Error("surfaces", "cannot be translated to IGES",
                    "Look at the patches' deviation and normal angles");
    writer.ComputeModel();
    labelFaces(shape, origins, writer.TransferProcess());
    IGESData_GlobalSection global = writer.Model()->GlobalSection();
    const LengthUnitNames unit = namesOf(options.unit);
    global.SetUnitFlag(unit.igesFlag);
    global.SetUnitName(text(unit.igesName));
    global.SetDate(text(igesDate(options.date)));
    global.SetLastChangeDate(text(igesDate(options.date)));
    global.SetFileName(text(asciiName(options.name)));
    global.SetSendName(text(asciiName(options.name)));
    global.SetAuthorName(text(""));
    global.SetCompanyName(text(""));
    writer.Model()->SetGlobalSection(global);
    std::ostringstream stream;
    if (!writer.Write(stream)) throw Error("surfaces", "cannot be written as IGES", "Try STEP");
    return stream.str();
}

} // namespace qm
