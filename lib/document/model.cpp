#include "document/model.h"

#include "document/document.h"
#include "document/files/files.h"
#include "document/sections/base_complex_section.h"
#include "document/sections/constraints_section.h"
#include "document/sections/cut_section.h"
#include "document/sections/enumeration_section.h"
#include "document/sections/features_section.h"
#include "document/sections/layout_section.h"
#include "document/sections/mesh_section.h"
#include "document/sections/surfaces_section.h"

namespace qm {

namespace {

class ModelReader {
public:
    ModelReader(Document& document, const std::string& meshPath) : document_(document) {
        FoundMesh found = readMeshOf(JsonPlace(document.root)["mesh"], document.path, meshPath);
        model_.mesh = std::move(found.mesh);
        model_.meshPath = std::move(found.path);
    }

    Model read(Kind upTo) {
        readBaseComplex();
        if (upTo >= Kind::features) readFeatureCurves();
        if (upTo == Kind::cut || upTo == Kind::enumeration) readSubMeshes();
        if (upTo == Kind::enumeration) readGraphs();
        if (upTo >= Kind::layout) {
            readDemands();
            readSegments();
        }
        if (upTo == Kind::surfaces) readPatches();
        return std::move(model_);
    }

    Model readAll() {
        readBaseComplex();
        readFeatureCurves();
        readSubMeshes();
        if (document_.has(Kind::enumeration)) readGraphs();
        if (document_.has(Kind::layout)) readSegments();
        if (document_.has(Kind::surfaces)) readPatches();
        return std::move(model_);
    }

private:
    void readBaseComplex() {
        model_.dihedralAngles = dihedralAngles(model_.mesh);
        model_.baseComplex = buildBaseComplex(model_.mesh);
        verifyBaseComplex(model_.mesh, model_.baseComplex, document_.section(Kind::basecomplex));
        model_.complex = model_.baseComplex;
    }

    void readFeatureCurves() {
        if (!document_.has(Kind::features)) return;
        model_.features = readFeatures(model_.mesh, document_.section(Kind::features));
        if (!model_.features.curves.empty())
            model_.complex = buildBaseComplex(model_.mesh, seeds(model_.mesh, model_.features));
    }

    void readSubMeshes() {
        if (document_.has(Kind::cut)) {
            model_.cut = readCut(model_.mesh, model_.complex, document_.section(Kind::cut));
            Json& section = document_.root[sectionOf(Kind::cut)];
            if (!figuresAgree(*model_.cut, section)) {
                updateFigures(*model_.cut, section);
                model_.notes.emplace_back(
                    "/cut/subMeshes: quasi-complexity and ordinary junctions measured anew");
            }
        }
        model_.subMeshes = subMeshesOf(model_.cut);
        readDemands();
    }

    void readDemands() {
        if (const auto section = JsonPlace(document_.root).find("constraints"))
            model_.constraints = readConstraints(model_.mesh, model_.complex, *section);
    }

    void readCosts() {
        model_.cost = readCost(document_.section(Kind::enumeration));
        model_.edgeCosts = edgeCosts(model_.mesh, model_.dihedralAngles, model_.cost, model_.constraints);
    }

    void readGraphs() {
        readCosts();
        model_.enumeration = readEnumeration({model_.mesh, model_.baseComplex, model_.complex,
                                              model_.edgeCosts, model_.cost.terms, model_.subMeshes},
                                             document_.section(Kind::enumeration));
    }

    void readSegments() {
        readCosts();
        model_.layout =
            readLayout(model_.mesh, model_.dihedralAngles, model_.edgeCosts, document_.section(Kind::layout));
        Json& section = document_.root[sectionOf(Kind::layout)];
        if (layoutIsWhole(model_.mesh, *model_.layout, section)) return;
        section.update(
            layoutToJson(model_.mesh, *model_.layout, model_.dihedralAngles, sharpAngle(document_.root)));
        model_.notes.emplace_back("/layout: costs, segments and quality made anew from the tracks");
    }

    void readPatches() {
        std::vector<std::array<int, 2>> sizes;
        for (const Segment& segment : model_.layout->segments)
            sizes.push_back(segment.size);
        model_.surfaces = readSurfaces(model_.mesh, sizes, document_.section(Kind::surfaces));
    }

    Document& document_;
    Model model_;
};

} // namespace

Model readModel(Document& document, Kind upTo, const std::string& meshPath) {
    return inFile(displayName(document.path), [&] { return ModelReader(document, meshPath).read(upTo); });
}

Model readWholeModel(Document& document, const std::string& meshPath) {
    return inFile(displayName(document.path), [&] { return ModelReader(document, meshPath).readAll(); });
}

} // namespace qm
