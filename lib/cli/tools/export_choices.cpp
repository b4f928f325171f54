#include "cli/tools/export_choices.h"

#include "base/number_text.h"
#include "cli/tool.h"
#include "cli/tools/export_date.h"
#include "cli/tools/surface_warnings.h"
#include "document/json/utf8.h"
#include "document/model.h"
#include "mesh/bounding_box.h"
#include "summary/figure_text.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace qm {
namespace {

/// If the distance within which STEP identifies points is a larger share of the mesh's diagonal than this,
/// the mesh is too small.
constexpr double smallestShare = 1e-3;

/// \throw UsageError  if neither the option nor the output's name determines the format
ExportFormat exportFormat(NamedFormat format, const std::string& outputPath) {
    using enum ExportFormat;
    static const std::map<std::string, ExportFormat> ofEnding = {
        {".step", step}, {".stp", step}, {".iges", iges}, {".igs", iges},
        {".obj", obj},   {".ply", ply},  {".glb", glb}};
    std::string ending = format == NamedFormat::ending
                             ? std::filesystem::path(outputPath).extension().string()
                             : "." + std::string(choiceName(format));
    for (char& letter : ending) // many programs write extensions in capitals
        if (letter >= 'A' && letter <= 'Z') letter += 'a' - 'A';
    const auto found = ofEnding.find(ending);
    if (found == ofEnding.end())
        throw UsageError("the output's name does not tell the format. Give --format, or a name such as "
                         "part.step, part.iges, part.obj, part.ply or part.glb");
    return found->second;
}

/// \throw Error  if no product can have this name, because it is too long or not UTF-8, or if that is no date
void verifyNameAndDate(const std::string& name, const std::string& date) {
    constexpr std::size_t maxLength = 1000; // OpenCASCADE crashes at longer ones in IGES
    if (name.size() > maxLength)
        throw UsageError("--name: is longer than " + std::to_string(maxLength) + " bytes");
    if (!isUtf8(name)) throw UsageError("--name: is not UTF-8");
    if (!date.empty() && date != "mesh") (void)exportDate(date, "");
}

} // namespace

void declareChecks(Tool& tool, ExportOptions& options, const NamedFormat& format, const std::string& date) {
    using enum ExportFormat;
    const auto isSolid = [&tool, &format] {
        const ExportFormat written = exportFormat(format, tool.outputPath());
        return written == step || written == iges;
    };
    tool.needs({"unit", "join", "analytic", "analytic-tolerance", "name", "date"}, "STEP or IGES", isSolid);
    tool.needs({"analytic-tolerance"}, "--analytic", [&options] { return options.analytic; });
    tool.needs({"colour"}, "PLY or glTF", [&tool, &format, isSolid] {
        return !isSolid() && exportFormat(format, tool.outputPath()) != obj;
    });
    tool.verify([&tool, &options, &format, &date] {
        options.format = exportFormat(format, tool.outputPath());
        verifyNameAndDate(options.name, date);
    });
}

std::string productName(const std::string& meshPath) {
    std::string name = std::filesystem::path(meshPath).stem().string();
    if (!isUtf8(name))
        std::ranges::replace_if(
            name, [](char letter) { return static_cast<unsigned char>(letter) > '~'; }, '?');
    return name;
}

Kind neededKind(const ExportOptions& options) {
    using enum ExportFormat;
    const bool quads = options.format == obj || options.format == ply || options.format == glb;
    const bool coloured = options.format != obj && options.colour == ColourBy::deviation;
    return quads && !coloured ? Kind::layout : Kind::surfaces;
}

int reportShape(Tool& tool, const std::optional<ShapeReport>& found, const Model& model, LengthUnit unit) {
    if (!found) return exitDone;
    const ShapeReport& shape = *found;
    tool.count("solids", shape.solids);
    tool.count("cavities", shape.cavities);
    tool.count("openEdges", shape.openEdges);
    tool.count("shapeFaces", shape.faces);
    tool.count("simpleFaces", shape.simpleFaces);
    tool.count("smoothEdges", shape.smoothEdges);
    tool.count("newAngle", shape.largestNewAngle);
    tool.count("valid", shape.valid ? 1 : 0);
    tool.count("gap", shape.largestGap);
    tool.count("tolerance", shape.largestTolerance);
    const std::string unitName = " " + std::string(choiceName(unit));
    const auto length = [&unitName](double value) { return figureText(value) + unitName; };
    if (shape.shells > 0)
        tool.warn(countText(shape.shells, "open shell") + ", " + countText(shape.solids, "solid") + ": " +
                  countText(shape.openEdges, "edge") + " of " + std::to_string(shape.edges) +
                  " on the boundary of the mesh. If it should have none, close it");
    warnOfFolds(tool, *model.surfaces);
    int status = exitDone;
    const auto alarm = [&](const std::string& message) {
        tool.warn(message);
        status = exitUnmet;
    };
    if (shape.largestGap > shape.resolution)
        alarm("patches are " + length(shape.largestGap) + " apart, and STEP joins what is nearer than " +
              length(shape.resolution) + ". Fit the surfaces with qm-bspline --fit smooth");
    if (const double diagonal = boundingBox(model.mesh).diagonal();
        shape.resolution > smallestShare * diagonal)
        alarm("the mesh, " + length(diagonal) + " across, is too small: STEP joins what is nearer than " +
              length(shape.resolution) + ". Scale it up");
    else if (shape.lostEdges > 0)
        alarm(countText(shape.lostEdges, "edge") + " shorter than the " + length(shape.resolution) +
              " within which STEP joins points. Mend the mesh there, or scale it up");
    if (!shape.valid)
        alarm("OpenCASCADE finds faults in the boundary representation. Fit the surfaces with "
              "qm-bspline --fit smooth, or with a smaller tolerance");
    return status;
}

} // namespace qm
