/// \file qm-export: layouts and surfaces as STEP, IGES, OBJ, PLY and glTF.
#include "cli/stage.h"
#include "export/export.h"

#include <filesystem>
#include <map>

namespace qm {

template <> struct Choices<ExportFormat> {
    static constexpr std::array all{
        Choice<ExportFormat>{ExportFormat::step, "step", "B-spline surfaces, STEP AP214"},
        Choice<ExportFormat>{ExportFormat::iges, "iges", "B-spline surfaces, IGES"},
        Choice<ExportFormat>{ExportFormat::obj, "obj", "quads, one group for every segment"},
        Choice<ExportFormat>{ExportFormat::ply, "ply", "quads with colours and segment numbers, binary"},
        Choice<ExportFormat>{ExportFormat::glb, "glb",
                             "coloured triangles, one glTF node for every segment"}};
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

qm::ExportFormat formatOf(const std::string& path) {
    using enum qm::ExportFormat;
    static const std::map<std::string, qm::ExportFormat> formats = {
        {".step", step}, {".stp", step}, {".iges", iges}, {".igs", iges},
        {".obj", obj},   {".ply", ply},  {".glb", glb}};
    const auto format = formats.find(std::filesystem::path(path).extension().string());
    if (format == formats.end())
        throw qm::UsageError("the output's name does not tell the format. Give --format, or a name such as "
                             "part.step, part.iges, part.obj, part.ply or part.glb");
    return format->second;
}

} // namespace

int main(int argc, char** argv) {
    qm::ExportOptions options;
    return qm::runTool(
        argc, argv, "qm-export", "Write a layout, or the surfaces fitted to it, for other programs.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            auto stage = std::make_shared<qm::Stage>(tool, qm::Kind::surfaces, qm::Kind::layout);
            tool.writes("the file for the other program");
            tool.option("format", options.format,
                        "what to write; the ending of the output's name by default");
            tool.option("unit", options.unit, "the mesh's unit, which STEP and IGES declare");
            tool.option("colour", options.colour, "what colours in PLY and glTF mean");
            tool.explain(
                "STEP and IGES need the surfaces of qm-bspline; with --watertight or --fit tolerance "
                "they have no gaps. Faces become one shell, and a solid where the mesh is closed.");
            tool.example("qm-export part.surfaces.json -o part.step");
            tool.example("qm-bspline --watertight part.layout.json | qm-export --format iges -o part.igs");
            tool.example("qm-export --format ply --colour deviation part.surfaces.json > part.ply");
            tool.verify([&] {
                if (!tool.given("format")) options.format = formatOf(tool.outputPath());
            });
            return [&tool, &options, stage] {
                const qm::Model& model = stage->read();
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
