#include "cli/export_choices.h"

#include "cli/tool.h"

#include <filesystem>
#include <map>

namespace qm {

ExportFormat exportFormat(NamedFormat format, const std::string& outputPath) {
    using enum ExportFormat;
    static const std::map<std::string, ExportFormat> ofEnding = {
        {".step", step}, {".stp", step}, {".iges", iges}, {".igs", iges},
        {".obj", obj},   {".ply", ply},  {".glb", glb}};
    std::string ending = format == NamedFormat::ending
                             ? std::filesystem::path(outputPath).extension().string()
                             : "." + std::string(choiceName(format));
    for (char& letter : ending) // many programs write them large
        if (letter >= 'A' && letter <= 'Z') letter += 'a' - 'A';
    const auto found = ofEnding.find(ending);
    if (found == ofEnding.end())
        throw UsageError("the output's name does not tell the format. Give --format, or a name such as "
                         "part.step, part.iges, part.obj, part.ply or part.glb");
    return found->second;
}

void requireEffect(const Tool& tool, const ExportOptions& options) {
    using enum ExportFormat;
    const bool solid = options.format == step || options.format == iges;
    for (const char* name : {"unit", "join", "analytic", "analytic-tolerance"})
        if (tool.given(name) && !solid)
            throw UsageError("--" + std::string(name) + " is for STEP and IGES. Leave it out");
    if (tool.given("colour") && (solid || options.format == obj))
        throw UsageError("--colour is for PLY and glTF. Leave it out");
    if (tool.given("analytic-tolerance") && !options.analytic)
        throw UsageError("--analytic-tolerance needs --analytic. Give both, or neither");
}

Kind neededKind(const ExportOptions& options) {
    using enum ExportFormat;
    const bool quads = options.format == obj || options.format == ply || options.format == glb;
    const bool coloured = options.format != obj && options.colour == ColourBy::deviation;
    return quads && !coloured ? Kind::layout : Kind::surfaces;
}

void reportShape(Tool& tool, const ShapeReport& shape, LengthUnit unit) {
    tool.count("solids", static_cast<double>(shape.solids));
    tool.count("openEdges", static_cast<double>(shape.openEdges));
    tool.count("shapeFaces", static_cast<double>(shape.faces));
    tool.count("simpleFaces", static_cast<double>(shape.simpleFaces));
    tool.count("smoothEdges", static_cast<double>(shape.smoothEdges));
    tool.count("valid", shape.valid ? 1 : 0);
    tool.count("tolerance", shape.largestTolerance);
    if (!shape.valid)
        tool.warn("OpenCASCADE finds faults in the boundary representation. Fit the surfaces with "
                  "qm-bspline --fit smooth, or with a smaller tolerance");
    else if (shape.largestTolerance * inMillimetres(unit) > 1)
        tool.warn("Patches are more than a millimetre apart, which programs that read the file may find too "
                  "much. Fit the surfaces with qm-bspline --fit smooth");
}

} // namespace qm
