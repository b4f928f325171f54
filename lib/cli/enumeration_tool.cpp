#include "cli/enumeration_tool.h"

#include "cli/output_file.h"
#include "document/enumeration_section.h"

#include <algorithm>

namespace qm {

void declareRequests(Tool& tool, EnumerationRequests& requests) {
    tool.text(
        "all", requests.allGraphs, "FILE",
        "write every motorcycle graph to this file, one line of JSON each; - means standard output, and "
        "then needs --output for the document");
    tool.option("require-complete", requests.requireComplete,
                "exit with status 3 if a limit ended the search");
    tool.option("require-optimal", requests.requireOptimal,
                "exit with status 3 unless the best graph of every sub-mesh is proved optimal");
    tool.verify([&tool, &requests] {
        if (requests.allGraphs == "-" && tool.outputPath() == "-")
            throw UsageError("--all -: the document goes to standard output too. Name a file with --output");
        if (!requests.allGraphs.empty() && requests.allGraphs != "-" &&
            requests.allGraphs == tool.outputPath())
            throw UsageError("--all and --output name the same file");
    });
}

void streamGraphs(const Tool& tool, const Model& model, const EnumerationOptions& options,
                  const EnumerationRequests& requests) {
    if (requests.allGraphs.empty()) return;
    const SeparatrixIndex separatrices(model.mesh, model.baseComplex);
    OutputFile file(requests.allGraphs);
    double graphs = 0;
    const bool all = forEachGraph(
        model.mesh, model.complex, model.dihedralAngles, model.subMeshes, options,
        [&](int subMesh, const MotorcycleGraph& graph) {
            Json line{{"subMesh", subMesh}};
            line.update(graphToJson(model.mesh, separatrices, graph));
            file.write(printJsonLine(line));
            ++graphs;
            return !tool.interrupted();
        },
        tool.control("writing every graph"));
    file.commit();
    tool.count("graphsWritten", graphs);
    if (!all)
        tool.warn(tool.inputName() + ": --all: the search was ended early; not every graph was written");
}

int judge(const Tool& tool, const Enumeration& enumeration, const EnumerationRequests& requests) {
    const auto isOptimal = [](const SubMeshGraphs& subMesh) {
        return subMesh.cost && subMesh.lowerBound && *subMesh.lowerBound >= *subMesh.cost;
    };
    const auto optimal = std::count_if(enumeration.subMeshes.begin(), enumeration.subMeshes.end(), isOptimal);
    tool.count("subMeshes", static_cast<double>(enumeration.subMeshes.size()));
    tool.count("provedOptimal", static_cast<double>(optimal));
    const bool allOptimal = static_cast<std::size_t>(optimal) == enumeration.subMeshes.size();
    if (!enumeration.complete)
        tool.warn(tool.inputName() + ": a limit ended the search; the best graph of " +
                  std::to_string(optimal) + " of " + std::to_string(enumeration.subMeshes.size()) +
                  " sub-meshes is proved optimal");
    const bool unmet =
        (requests.requireComplete && !enumeration.complete) || (requests.requireOptimal && !allOptimal);
    return unmet ? exitUnmet : exitDone;
}

} // namespace qm
