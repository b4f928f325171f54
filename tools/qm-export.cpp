/// \file qm-export: writes layouts and surfaces as STEP, IGES, OBJ, PLY and glTF.
#include "base/or_null.h"
#include "cli/stage.h"
#include "cli/tools/export_choices.h"
#include "cli/tools/export_date.h"

int main(int argc, char** argv) {
    qm::ExportOptions options;
    std::string date;
    qm::NamedFormat format = qm::NamedFormat::ending;
    return qm::runTool(
        argc, argv, "qm-export", "Write a layout, or the surfaces fitted to it, for other programs.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            auto stage = std::make_shared<qm::Stage>(tool, qm::Kind::surfaces, qm::Kind::layout);
            tool.writes("the exported file");
            tool.option("format", format, "the output format");
            tool.option("unit", options.unit, "the mesh's unit, as declared in STEP and IGES");
            options.name.clear(); // if none is given, the mesh file's
            tool.text("name", options.name, "NAME",
                      "name of the product in STEP and IGES, instead of the mesh file's name");
            tool.text("date", date, "DATE",
                      "date in STEP and IGES, such as 2026-11-22 or 2026-11-22T10:00:00 (UTC), or mesh: the "
                      "date of the mesh file; by default 1970-01-01, so that equal input gives equal bytes");
            tool.option("colour", options.colour, "meaning of the colours in PLY and glTF");
            tool.option("join", options.join,
                        "merge faces that are one smooth surface or plane, and edges that are one curve");
            tool.option("analytic", options.analytic,
                        "replace patches by cylinders, cones, spheres and tori, edges by lines and conics");
            tool.option("analytic-tolerance", options.analyticTolerance, {0, qm::infinity},
                        "largest distance of a patch from the surface that replaces it, in the mesh's unit "
                        "or, with %, as a share of the bounding box's diagonal");
            tool.explain(
                "STEP and IGES need the surfaces of qm-bspline, which have no gaps unless fitted with --fit "
                "interpolate. The faces form one shell, and a solid where the mesh is closed. Plane patches "
                "become planes. Patches are split where they are only C0 or touch themselves. Exit status 3, "
                "with figures in a warning: the file is written, but has gaps between patches or other "
                "faults, or the mesh is too small for the format.");
            tool.example("qm-export part.surfaces.json -o part.step");
            tool.example("qm-bspline part.layout.json | qm-export --format iges -o part.igs");
            tool.example("qm-export --join --analytic part.surfaces.json -o part.step");
            tool.example("qm-export --format ply --colour deviation part.surfaces.json > part.ply");
            qm::declareChecks(tool, options, format, date);
            return [&tool, &options, &date, stage] {
                const qm::Model& model = stage->read(qm::neededKind(options));
                tool.protectInput();
                if (options.name.empty()) options.name = qm::productName(model.meshPath);
                if (!date.empty()) options.date = qm::exportDate(date, model.meshPath);
                const qm::Exported result =
                    qm::exportModel(model.mesh, *model.layout, qm::orNull(model.surfaces), options);
                tool.count("segments", model.layout->segments.size());
                tool.write(result.bytes);
                return qm::reportShape(tool, result.shape, model, options.unit);
            };
        });
}
