/// \file qm-enum: searches the motorcycle graphs of every sub-mesh.
#include "cli/stage.h"
#include "cli/tools/enumeration_tool.h"
#include "document/sections/enumeration_section.h"
#include "enumerate/enumerate.h"

int main(int argc, char** argv) {
    qm::EnumerationOptions options;
    qm::EnumerationRequests requests;
    return qm::runTool(
        argc, argv, "qm-enum", "Find the cheapest motorcycle graphs of every sub-mesh.",
        [&](qm::Tool& tool) -> qm::ToolBody {
            auto stage = std::make_shared<qm::Stage>(tool, qm::Kind::cut, qm::Kind::basecomplex,
                                                     qm::Kind::enumeration);
            tool.explain("A document without the section cut is searched as a whole. An interrupt ends the "
                         "search with the best graphs so far.");
            tool.options(options);
            qm::declareRequests(tool, requests, options);
            tool.stopsGracefully();
            tool.example("qm-enum part.cut.json -o part.enumeration.json");
            tool.example("qm-basecomplex part.obj | qm-enum --best 3 --count > part.enumeration.json");
            tool.example("qm-enum --all graphs.jsonl part.features.json -o part.enumeration.json");
            tool.example("qm-enum --cost dihedral+0.5*segments --best 1000 --list best.jsonl "
                         "part.basecomplex.json -o part.enumeration.json");
            tool.example(
                "qm-enum --part 1/2 part.cut.json -o 1.json; qm-enum --part 2/2 part.cut.json -o 2.json; "
                "qm-enum --join 1.json 2.json -o part.enumeration.json");
            tool.example("qm-enum --class tmesh --sample 10 part.basecomplex.json > part.enumeration.json");
            return [&, stage] {
                if (requests.join) return qm::joinParts(tool, requests);
                const qm::Model& model = stage->read();
                const qm::Enumeration enumeration = qm::searchGraphs(tool, model, options, requests);
                const int status = qm::judge(tool, enumeration, requests);
                const qm::SeparatrixIndex separatrices(model.mesh, model.baseComplex);
                stage->write(options, qm::enumerationToJson(model.mesh, separatrices, enumeration));
                return status;
            };
        });
}
