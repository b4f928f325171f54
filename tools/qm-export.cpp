/// \file qm-export: layouts and surfaces as STEP, IGES, OBJ, PLY and glTF.
#include "cli/tool.h"
#include "document/model.h"
#include "export/export.h"

#include <filesystem>
#include <map>

namespace {

/// What --format may say: a format, or that the output's name tells it.
enum class Format { ending, step, iges, obj, ply, glb };

} // namespace

namespace qm {

template <> struct Choices<Format> {
    static constexpr std::array all{
        Choice<Format>{Format::ending, "ending", "what the ending of the output's name says"},
        Choice<Format>{Format::step, "step", "B-spline surfaces, STEP AP214"},
        Choice<Format>{Format::iges, "iges", "B-spline surfaces, IGES"},
        Choice<Format>{Format::obj, "obj", "quads, one group for every segment"},
        Choice<Format>{Format::ply, "ply", "quads with colours and segment numbers, binary"},
        Choice<Format>{Format::glb, "glb", "coloured triangles, one glTF node for every segment"}};
};

template <> struct Choices<LengthUnit> {
    static constexpr std::array all{Choice<LengthUnit>{LengthUnit::mm, "mm", "millimetres"},
                                    Choice<LengthUnit>{LengthUnit::cm, "cm", "centimetres"},
                                    Choice<LengthUnit>{LengthUnit::m, "m", "metres"},
                                    Choice<LengthUnit>{LengthUnit::inch, "inch", "inches"}};
};

template <> struct Choices<ColourBy> {
    static constexpr std::array all{
        Choice<ColourBy>{ColourBy::segment, "segment", "another colour for every segment"},
        Choice<ColourBy>{ColourBy::deviation, "deviation", "blue to red by the surface's largest deviation"}};
};

} // namespace qm

namespace {

qm::ExportFormat exportFormat(Format format, const std::string& path) {
    using enum qm::ExportFormat;
    static const std::map<std::string, qm::ExportFormat> ofEnding = {
        {".step", step}, {".stp", step}, {".iges", iges}, {".igs", iges},
        {".obj", obj},   {".ply", ply},  {".glb", glb}};
    const std::string ending = format == Format::ending ? std::filesystem::path(path).extension().string()
                                                        : "." + std::string(qm::choiceName(format));
    const auto found = ofEnding.find(ending);
    if (found == ofEnding.end())
        throw qm::UsageError("the output's name does not tell the format. Give --format, or a name such as "
                             "part.step, part.iges, part.obj, part.ply or part.glb");
    return found->second;
}

/// Quads need no surfaces, unless they are coloured by them.
qm::Kind neededKind(const qm::ExportOptions& options) {
    using enum qm::ExportFormat;
    const bool quads = options.format == obj || options.format == ply || options.format == glb;
    const bool coloured = options.format != obj && options.colour == qm::ColourBy::deviation;
    return quads && !coloured ? qm::Kind::layout : qm::Kind::surfaces;
}

qm::Model readModel(const qm::Tool& tool, qm::Kind kind, const std::string& meshPath) {
    qm::Document document = qm::parseDocument(tool.readInput(), tool.inputPath());
    (void)qm::requireKind(document, kind);
    qm::Model model = qm::readModel(document, kind, meshPath);
    for (const std::string& note : model.notes)
        tool.warn(tool.inputName() + ": " + note);
    return model;
}

} // namespace

int main(int argc, char** argv) {
    qm::ExportOptions options;
    Format format = Format::ending;
    std::string meshPath;
    return qm::runTool(
        argc, argv, "qm-export", "Write a layout, or the surfaces fitted to it, for other programs.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            tool.reads("DOCUMENT", "a document with a layout or, for STEP and IGES, surfaces");
            tool.writes("the file for the other program");
            tool.option("format", format, "what to write");
            tool.option("unit", options.unit, "the mesh's unit, which STEP and IGES declare");
            tool.option("colour", options.colour, "what colours in PLY and glTF mean");
            tool.text("mesh", meshPath, "FILE", "the mesh, if it is not where the document says");
            tool.explain(
                "STEP and IGES need the surfaces of qm-bspline; with --watertight or --fit tolerance "
                "they have no gaps. Faces become one shell, and a solid where the mesh is closed.");
            tool.example("qm-export part.surfaces.json -o part.step");
            tool.example("qm-bspline --watertight part.layout.json | qm-export --format iges -o part.igs");
            tool.example("qm-export --format ply --colour deviation part.surfaces.json > part.ply");
            tool.verify([&] { options.format = exportFormat(format, tool.outputPath()); });
            return [&tool, &options, &meshPath] {
                const qm::Model model = readModel(tool, neededKind(options), meshPath);
                const qm::Surfaces* surfaces = model.surfaces ? &*model.surfaces : nullptr;
                const qm::Exported result = qm::exportModel(model.mesh, *model.layout, surfaces, options);
                tool.count("segments", static_cast<double>(model.layout->segments.size()));
                if (result.shape) {
                    tool.count("solids", static_cast<double>(result.shape->solids));
                    tool.count("openEdges", static_cast<double>(result.shape->openEdges));
                    tool.count("valid", result.shape->valid ? 1 : 0);
                    tool.count("tolerance", result.shape->largestTolerance);
                    if (!result.shape->valid)
                        tool.warn("OpenCASCADE finds faults in the boundary representation. Fit the "
                                  "surfaces with --watertight, or with a smaller tolerance");
                }
                tool.write(result.bytes);
                return qm::exitDone;
            };
        });
}
