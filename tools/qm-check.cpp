/// \file qm-check: checks whether a document is true of its mesh. Only reading is shared with other tools.
#include "base/number_text.h"
#include "check/check_document.h"
#include "check/document/check_history.h"
#include "check/document/read_document.h"
#include "check/document/report.h"
#include "cli/terminal/messages.h"
#include "cli/tool.h"
#include "document/document.h"
#include "document/sections/mesh_section.h"

int main(int argc, char** argv) {
    std::string meshPath;
    bool asJson = false;
    return qm::runTool(argc, argv, "qm-check", "Verify a document against its mesh.", [&](qm::Tool& tool) {
        tool.explain(
            "Recomputes what follows from the mesh, in code of its own, and tests whether the rest agrees. "
            "The first twenty violations are reported, in a line each, with the JSON pointer of their "
            "places.");
        tool.reads("DOCUMENT", "a document of any kind");
        tool.group(qm::Tool::generalOptions);
        tool.text("mesh", meshPath, "FILE", "the mesh, if it is not where the document says");
        tool.group(qm::Tool::ownOptions);
        tool.writes("what was verified, and the verdict");
        tool.option("json", asJson, "write the report as JSON, with the first thousand violations");
        tool.example("qm-check part.layout.json");
        tool.example("qm-check --json part.surfaces.json | jq .ok");
        return [&]() -> int {
            const qm::Document document = qm::parseDocument(tool.readInput(), tool.inputPath());
            const auto found = qm::readMeshOf(qm::JsonPlace(document.root)["mesh"], document.path, meshPath);
            tool.protect(found.path);
            tool.protectInput();
            qm::check::Report report;
            report.verify("schema, and mesh of " +
                          qm::countText(found.mesh.n_vertices(), "vertex", "vertices") + " and " +
                          qm::countText(found.mesh.n_faces(), "face"));
            qm::check::checkHistory(document.root, report);
            report = qm::check::checkDocument(qm::check::checkedMesh(found.mesh),
                                              qm::check::readDocument(document.root), report, tool.jobs());
            constexpr std::size_t linesShown = 20;
            for (const std::string& line : qm::check::violationLines(report, linesShown))
                qm::printMessage(tool.name() + ": " + tool.inputName() + ": " + line);
            tool.write(asJson ? qm::check::reportJson(report) : qm::check::reportText(report));
            tool.count("violations", report.total());
            return report.ok() ? qm::exitDone : qm::exitFailure;
        };
    });
}
