#include "cli/enumeration_tool.h"

#include "cli/graph_line.h"
#include "cli/output_file.h"
#include "document/enumeration_section.h"

#include <algorithm>
#include <cmath>

namespace qm {

namespace {

void verifyFile(const Tool& tool, const std::string& option, const std::string& file) {
    if (file == "-" && tool.outputPath() == "-")
        throw UsageError("--" + option +
                         " -: the document goes to standard output too. Name a file with --output");
    if (!file.empty() && file != "-" && file == tool.outputPath())
        throw UsageError("--" + option + " and --output name the same file");
}

void writeGraphs(const Tool& tool, const Model& model, const EnumerationOptions& options,
                 const std::string& path, bool ranked) {
    if (path.empty()) return;
    const SeparatrixIndex separatrices(model.mesh, model.baseComplex);
    OutputFile file(path);
    std::size_t written = 0;
    const GraphListing listing{[&](int subMesh, const MotorcycleGraph& graph, std::string& text) {
                                   appendGraphLine(model.mesh, separatrices, subMesh, graph, text);
                               },
                               [&](std::string_view text, std::size_t graphs) {
                                   file.write(text);
                                   written += graphs;
                                   return true;
                               }};
    const bool all =
        listGraphs(model.mesh, model.complex, model.dihedralAngles, model.subMeshes, options, ranked, listing,
                   tool.control(ranked ? "writing the best graphs" : "writing every graph"));
    file.commit();
    tool.count(ranked ? "bestGraphsWritten" : "graphsWritten", static_cast<double>(written));
    if (!all)
        tool.warn(tool.inputName() + ": the search was ended early; not every graph was written to " + path);
}

} // namespace

void declareRequests(Tool& tool, EnumerationRequests& requests, const EnumerationOptions& options) {
    tool.text("all", requests.allGraphs, "FILE",
              "write every graph to this file, one line of JSON each; - means standard output, and "
              "then needs --output for the document");
    tool.text(
        "list", requests.bestGraphs, "FILE",
        "write the --best graphs to this file likewise, the cheapest first; the document keeps only one");
    tool.option("require-complete", requests.requireComplete,
                "exit with status 3 if a limit ended the search");
    tool.option("require-optimal", requests.requireOptimal,
                "exit with status 3 unless the best graph of every sub-mesh is proved optimal");
    tool.verify([&tool, &requests, &options] {
        verifyFile(tool, "all", requests.allGraphs);
        verifyFile(tool, "list", requests.bestGraphs);
        if (!requests.allGraphs.empty() && requests.allGraphs == requests.bestGraphs)
            throw UsageError("--all and --list name the same file");
        if (options.sample > 0 && std::isfinite(options.maxCost))
            throw UsageError("--sample draws from all graphs: --max-cost does not go with it");
        if (options.graphClass == GraphClass::tmesh && options.method != Method::optimum)
            throw UsageError("--class tmesh: only --method optimum knows it");
        if ((options.sample > 0 || !requests.bestGraphs.empty()) && options.method != Method::optimum)
            throw UsageError("--sample and --list need --method optimum");
    });
}

EnumerationOptions forDocument(const EnumerationOptions& options, const EnumerationRequests& requests) {
    EnumerationOptions result = options;
    if (!requests.bestGraphs.empty()) result.best = 1;
    return result;
}

void streamGraphs(const Tool& tool, const Model& model, const EnumerationOptions& options,
                  const EnumerationRequests& requests) {
    writeGraphs(tool, model, options, requests.allGraphs, false);
    writeGraphs(tool, model, options, requests.bestGraphs, true);
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
