#include "cli/tools/enumeration_tool.h"

#include "base/deadline.h"
#include "base/number_text.h"
#include "cli/system/output_file.h"
#include "cli/tools/graph_line.h"
#include "document/files/files.h"
#include "document/files/referenced_file.h"
#include "document/join_enumerations.h"
#include "document/options/options.h"
#include "document/sections/enumeration_section.h"

#include <cmath>
#include <string_view>
#include <utility>

namespace qm {

namespace {

void verifyFile(const Tool& tool, const std::string& option, const std::string& file) {
    if (file == "-" && tool.outputPath() == "-")
        throw UsageError("--" + option +
                         " -: the document goes to standard output too. Name a file with --output");
    if (!file.empty() && file != "-" && isSameFile(file, tool.outputPath()))
        throw UsageError("--" + option + " and --output name the same file");
}

/// Reads "I/N", which part of the sub-meshes is to be searched.
Part readPart(const std::string& text) {
    constexpr int maxParts = 1000000;
    const std::string_view whole = text;
    const std::size_t slash = whole.find('/');
    Part part;
    if (slash != std::string_view::npos && parseNumber(whole.substr(0, slash), part.number) &&
        parseNumber(whole.substr(slash + 1), part.of) && part.number >= 1 && part.number <= part.of &&
        part.of <= maxParts)
        return part;
    throw UsageError("--part " + text + ": is no I/N with 1 <= I <= N <= " + std::to_string(maxParts));
}

void verifyParts(const Tool& tool, const EnumerationRequests& requests, EnumerationOptions& options) {
    if (!requests.join && !requests.furtherParts.empty())
        throw UsageError("unexpected operand " + requests.furtherParts.front());
    if (!requests.part.empty()) options.part = readPart(requests.part);
    std::vector<std::string> others{"all", "list"};
    if (requests.join) {
        others.insert(others.end(), {"part", "mesh", "require-complete", "require-optimal"});
        describe(options, [&](const char* name, auto&&...) { others.emplace_back(name); });
    }
    for (const std::string& name : others)
        if (tool.given(name) && (requests.join || !requests.part.empty()))
            throw UsageError("--" + name + " does not go with --" + (requests.join ? "join" : "part"));
}

/// \throw FileError  if no graphs can be written to a file, which a long search should not end with
void requireWritable(const Tool& tool, const std::string& file) {
    if (file.empty()) return;
    if (file != "-" && isSameFile(file, tool.inputPath()))
        throw FileError(file, "is the input", "Name another file");
    verifyWritable(file);
}

void writeGraphs(const Tool& tool, const Model& model, const EnumerationOptions& options,
                 const std::string& path, ListedGraphs which) {
    const bool areBest = which == ListedGraphs::best;
    const SeparatrixIndex separatrices(model.mesh, model.baseComplex);
    OutputFile file(path);
    std::size_t written = 0;
    const GraphListing listing{[&](SubMeshId subMesh, const MotorcycleGraph& graph, std::string& text) {
                                   appendGraphLine(model.mesh, separatrices, subMesh, graph, text);
                               },
                               [&](std::string_view text, std::size_t graphs) {
                                   file.write(text);
                                   written += graphs;
                                   return true;
                               }};
    const bool all = listGraphs(model.searched(), options, which, listing,
                                tool.control(areBest ? "writing the best graphs" : "writing every graph"));
    file.commit();
    tool.count(areBest ? "bestGraphsWritten" : "graphsWritten", written);
    if (!all) tool.warnOfInput("the search was ended early; not every graph was written to " + path);
}

} // namespace

void declareRequests(Tool& tool, EnumerationRequests& requests, EnumerationOptions& options) {
    tool.text(
        "part", requests.part, "I/N",
        "search only the I-th sub-mesh and every N-th after it, so that N parallel runs share the work");
    tool.option(
        "join", requests.join,
        "join the results of such runs, given as DOCUMENTs, into what a single run would have written");
    tool.readsMore(requests.furtherParts);
    tool.text("all", requests.allGraphs, "FILE",
              "write every graph to this file, one line of JSON each; - is standard output, and requires "
              "--output for the document");
    tool.text("list", requests.bestGraphs, "FILE",
              "write the --best graphs to this file in the same way, the cheapest first; the document keeps "
              "only one");
    tool.option("require-complete", requests.requireComplete,
                "exit with status 3 if a limit ended the search");
    tool.option("require-optimal", requests.requireOptimal,
                "exit with status 3 unless the best graph of every sub-mesh is proved optimal");
    tool.verify([&tool, &requests, &options] {
        verifyParts(tool, requests, options);
        verifyFile(tool, "all", requests.allGraphs);
        verifyFile(tool, "list", requests.bestGraphs);
        if (!requests.allGraphs.empty() && isSameFile(requests.allGraphs, requests.bestGraphs))
            throw UsageError("--all and --list name the same file");
        if (static_cast<double>(options.best) > maxSamples && requests.bestGraphs.empty())
            throw UsageError("--best: more than a million graphs go to a file only. Name it with --list");
        if (options.sample > 0 && std::isfinite(options.maxCost))
            throw UsageError("--sample draws from all graphs: --max-cost does not go with it");
        if (options.gap > 0 && options.best > 1 && requests.bestGraphs.empty())
            throw UsageError("--gap: several graphs are all proved, whatever the gap. Leave out one of --gap "
                             "and --best");
        if (options.graphClass == GraphClass::tmesh && options.method != Method::optimum)
            throw UsageError("--class tmesh: only --method optimum knows it");
        if ((options.sample > 0 || !requests.bestGraphs.empty()) && options.method != Method::optimum)
            throw UsageError("--sample and --list need --method optimum");
    });
}

int joinParts(const Tool& tool, const EnumerationRequests& requests) {
    std::vector<Document> parts;
    const auto add = [&](const std::string& bytes, const std::string& file) {
        parts.push_back(parseDocument(bytes, file));
        tool.protect(file, "is one of the parts");
        for (const std::string& mesh : referencedPaths(JsonPlace(parts.back().root)["mesh"], file))
            tool.protect(mesh);
    };
    add(tool.readInput(), tool.inputPath());
    for (const std::string& file : requests.furtherParts)
        add(readFile(file), file);
    tool.write(printDocument(joinEnumerations(std::move(parts))));
    return exitDone;
}

Enumeration searchGraphs(const Tool& tool, const Model& model, const EnumerationOptions& options,
                         const EnumerationRequests& requests) {
    requireWritable(tool, requests.allGraphs);
    requireWritable(tool, requests.bestGraphs);
    const Control control = tool.control("searching");
    const Deadline end(control, options.timeLimit);
    int steps = 1 + (requests.allGraphs.empty() ? 0 : 1) + (requests.bestGraphs.empty() ? 0 : 1);
    const auto withShareOfTime = [&](EnumerationOptions step) {
        step.timeLimit = end.secondsLeft() / steps--;
        return step;
    };
    EnumerationOptions ofDocument = options;
    if (!requests.bestGraphs.empty()) ofDocument.best = 1;
    Enumeration found = enumerateGraphs(model.searched(), withShareOfTime(ofDocument), control);
    if (!requests.allGraphs.empty())
        writeGraphs(tool, model, withShareOfTime(options), requests.allGraphs, ListedGraphs::every);
    if (!requests.bestGraphs.empty())
        writeGraphs(tool, model, withShareOfTime(options), requests.bestGraphs, ListedGraphs::best);
    return found;
}

int judge(const Tool& tool, const Enumeration& enumeration, const EnumerationRequests& requests) {
    const auto isOptimal = [](const SubMeshGraphs& subMesh) {
        return subMesh.cost && subMesh.lowerBound && *subMesh.lowerBound >= *subMesh.cost;
    };
    int searched = 0, optimal = 0, withoutGraph = 0;
    for (const SubMeshId subMesh : enumeration.subMeshes.ids()) {
        if (!enumeration.part.holds(subMesh)) continue;
        ++searched;
        if (isOptimal(enumeration.subMeshes[subMesh])) ++optimal;
        if (!enumeration.subMeshes[subMesh].cost) ++withoutGraph;
    }
    tool.count("subMeshes", searched);
    tool.count("provedOptimal", optimal);
    const bool allOptimal = optimal == searched;
    const bool unmet =
        (requests.requireComplete && !enumeration.complete) || (requests.requireOptimal && !allOptimal);
    if (!enumeration.complete || unmet) {
        std::string message;
        if (!enumeration.complete) message += "a limit ended the search; ";
        message += "the best graph of " + std::to_string(optimal) + " of " + std::to_string(searched) +
                   " sub-meshes is proved optimal";
        if (withoutGraph > 0) message += ", and no graph is known of " + std::to_string(withoutGraph);
        tool.warnOfInput(message);
    }
    return unmet ? exitUnmet : exitDone;
}

} // namespace qm
