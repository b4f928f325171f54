#include "export/exchange.h"

#include "base/error.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
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

/// A file says when it was made; ours shall not differ from run to run.
constexpr const char* noTime = "1970-01-01T00:00:00";
constexpr const char* noTimeIges = "19700101.000000";

const char* unitName(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::cm:
        return "CM";
    case LengthUnit::m:
        return "M";
    case LengthUnit::inch:
        return "INCH";
    default:
        return "MM";
    }
}

/// The number that IGES has for a unit.
int unitFlag(LengthUnit unit) {
    switch (unit) {
    case LengthUnit::cm:
        return 10;
    case LengthUnit::m:
        return 6;
    case LengthUnit::inch:
        return 1;
    default:
        return 2;
    }
}

Handle(TCollection_HAsciiString) text(const std::string& value) {
    return new TCollection_HAsciiString(value.c_str());
}

/// OpenCASCADE keeps its settings for the whole program, and reports on standard output.
class Session {
public:
    explicit Session(LengthUnit unit) : lock_(mutex) {
        Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
        STEPControl_Controller::Init();
        IGESControl_Controller::Init();
        // Both the same: coordinates stay as they are.
        Interface_Static::SetCVal("xstep.cascade.unit", unitName(unit));
        Interface_Static::SetCVal("write.step.unit", unitName(unit));
        Interface_Static::SetCVal("write.iges.unit", "MM");
        Interface_Static::SetCVal("write.step.schema", "AP214IS");
        Interface_Static::SetIVal("write.iges.brep.mode", 1);
    }

private:
    static inline std::mutex mutex;
    std::lock_guard<std::mutex> lock_;
};

using Origins = std::vector<std::vector<std::size_t>>;

/// "segment 4", or "segments 4 7" of a face that was joined.
std::string faceName(const std::vector<std::size_t>& segments) {
    std::string name = segments.size() == 1 ? "segment" : "segments";
    for (const std::size_t segment : segments)
        name += " " + std::to_string(segment);
    return name;
}

void nameFaces(const BoundaryShape& shape, const Origins& origins,
               const Handle(Transfer_FinderProcess) & process) {
    for (std::size_t k = 0; k < shape.faces.size(); ++k) {
        const auto item = STEPConstruct::FindEntity(process, shape.faces[k]);
        if (!item.IsNull()) item->SetName(text(faceName(origins[k])));
    }
}

/// Names of products differ, as programs that read the file tell the parts of an assembly by them.
/// OpenCASCADE would number those of a whole process.
void nameProducts(const Handle(StepData_StepModel) & model) {
    int number = 0;
    for (int k = 1; k <= model->NbEntities(); ++k) {
        const auto product = Handle(StepBasic_Product)::DownCast(model->Value(k));
        if (product.IsNull()) continue;
        const std::string name = number == 0 ? "quadmesh" : "quadmesh " + std::to_string(number);
        product->SetId(text(name));
        product->SetName(text(name));
        ++number;
    }
}

void labelFaces(const BoundaryShape& shape, const Origins& origins,
                const Handle(Transfer_FinderProcess) & process) {
    for (std::size_t k = 0; k < shape.faces.size(); ++k) {
        Handle(IGESData_IGESEntity) entity;
        const auto mapper = TransferBRep::ShapeMapper(process, shape.faces[k]);
        if (process->FindTypedTransient(mapper, STANDARD_TYPE(IGESData_IGESEntity), entity))
            entity->SetLabel(text("S" + std::to_string(origins[k].front())));
    }
}

} // namespace

std::string shapeAsStep(const BoundaryShape& shape, const Origins& origins, LengthUnit unit) {
    const Session session(unit);
    STEPControl_Writer writer;
    if (writer.Transfer(shape.shape, STEPControl_AsIs) != IFSelect_RetDone)
        throw Error("surfaces", "cannot be translated to STEP", "Look at the patches' deviation and kinks");
    nameFaces(shape, origins, writer.WS()->TransferWriter()->FinderProcess());

    const Handle(StepData_StepModel) model = writer.Model();
    nameProducts(model);
    APIHeaderSection_MakeHeader header(model);
    header.SetName(text("quadmesh"));
    header.SetTimeStamp(text(noTime));
    header.SetOriginatingSystem(text("quadmesh"));
    header.SetAuthorValue(1, text(""));
    header.SetOrganizationValue(1, text(""));

    StepData_StepWriter printer(model);
    printer.SendModel(Handle(StepData_Protocol)::DownCast(model->Protocol()));
    std::ostringstream stream;
    printer.Print(stream);
    return stream.str();
}

std::string shapeAsIges(const BoundaryShape& shape, const Origins& origins, LengthUnit unit) {
    const Session session(LengthUnit::mm);
    // The writer would convert from millimetres; so it is given those, and the unit is declared afterwards.
    IGESControl_Writer writer("MM", 1);
    if (!writer.AddShape(shape.shape))
        throw Error("surfaces", "cannot be translated to IGES", "Look at the patches' deviation and kinks");
    writer.ComputeModel();
    labelFaces(shape, origins, writer.TransferProcess());
    IGESData_GlobalSection global = writer.Model()->GlobalSection();
    global.SetUnitFlag(unitFlag(unit));
    global.SetUnitName(text(unitName(unit)));
    global.SetDate(text(noTimeIges));
    global.SetLastChangeDate(text(noTimeIges));
    global.SetFileName(text("quadmesh"));
    global.SetSendName(text("quadmesh"));
    global.SetAuthorName(text(""));
    global.SetCompanyName(text(""));
    writer.Model()->SetGlobalSection(global);
    std::ostringstream stream;
    if (!writer.Write(stream)) throw Error("surfaces", "cannot be written as IGES", "Try STEP");
    return stream.str();
}

} // namespace qm
