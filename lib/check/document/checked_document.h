/// \file A document as the checker sees it: every figure as it stands, nothing yet believed.
///
/// Arrays keep the document's order, so that an index is also the last part of a JSON pointer. An index that
/// is no whole number of 32 bits is read as -1, which no check accepts.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace qm::check {

struct BaseComplexPart {
    struct Separatrix {
        int id = -1;
        std::vector<int> vertices;
        std::optional<int> opposite;
        bool selfCrossing = false;
    };
    std::vector<int> extraordinaryVertices;
    int ordinaryJunctions = -1;
    std::vector<Separatrix> separatrices;
};

struct FeaturesPart {
    struct Curve {
        int id = -1;
        std::vector<int> vertices;
        int seed = -1;
    };
    std::vector<Curve> curves;
};

struct CutPart {
    struct SubMesh {
        int id = -1;
        std::optional<double> quasiComplexity;
        std::optional<int> ordinaryJunctions;
        std::optional<int> source;
        std::optional<int> sink;
    };
    std::vector<int> labels;
    std::vector<SubMesh> subMeshes;
};

/// A track, of a layout or of an enumerated graph.
struct TrackPart {
    std::optional<int> id;
    std::optional<int> separatrix; ///< of the base complex
    std::optional<int> source;     ///< vertex
    std::vector<int> vertices;
    std::optional<double> cost;
    bool transversal = false;
};

struct EnumerationPart {
    struct Graph {
        std::optional<double> cost;
        std::vector<TrackPart> tracks;
    };
    struct SubMesh {
        int id = -1;
        std::optional<double> cost;
        std::optional<double> lowerBound;
        std::optional<std::string> count;
        std::vector<Graph> graphs;
        std::vector<Graph> samples; ///< in any order, perhaps some twice
    };
    bool tmesh = false; ///< tracks may begin and end on others
    std::optional<std::string> count;
    std::vector<SubMesh> subMeshes;
};

/// The weights of the cost, as the enumeration used them.
struct CostWeights {
    double alpha = 0;
    double epsilon = 0;
    double dihedral = 1;
    double length = 0;
    double segments = 0;
    double custom = 1;
};

struct LayoutPart {
    struct Segment {
        int id = -1;
        std::array<int, 2> size{};
        std::array<int, 4> corners{};
        std::array<std::vector<int>, 4> sides;
        std::vector<int> faces;
    };
    struct Quality {
        std::optional<double> rho; ///< the angle above which an edge counts as sharp
        std::optional<double> segments;
        std::optional<double> tJoints;
        std::optional<double> capturedSharpness;
        std::optional<double> medianAspect;
        std::optional<double> maxAspect;
        std::optional<double> gap;
    };
    /// What pruning found for one price of a segment.
    struct FrontPoint {
        double beta = 0;
        double segments = 0;
        double cost = 0;
        double capturedSharpness = 0;
        std::optional<double> objectiveBound;
        bool proven = false;
    };
    std::optional<double> cost;
    std::optional<double> lowerBound;
    bool pruned = false; ///< the last tool that wrote it removed tracks
    bool tmesh = false;  ///< it was made from a T-mesh
    std::vector<TrackPart> tracks;
    bool divided = false; ///< segments are given; they may be left out
    std::vector<Segment> segments;
    Quality quality;
    std::vector<FrontPoint> front;
};

struct SurfacesPart {
    /// Figures of a deviation.
    struct Figures {
        std::map<std::string, double, std::less<>> stated; ///< by name

        /// Nothing if it is not stated.
        [[nodiscard]] std::optional<double> operator[](const char* name) const {
            const auto figure = stated.find(name);
            return figure == stated.end() ? std::nullopt : std::optional(figure->second);
        }
    };
    /// Control point (i, j), i along u, is controlPoints[j * count[0] + i].
    struct Patch {
        int segment = -1;
        std::array<int, 2> degree{};
        std::array<std::vector<double>, 2> knots;
        std::array<int, 2> count{};
        std::vector<std::array<double, 3>> controlPoints;
        bool rectangular = true; ///< all rows of control points have `count[0]`
        Figures figures;
    };
    /// What was promised of the fit; nothing is checked that is not known.
    bool interpolates = false;
    bool watertight = false;
    bool isOfScan = false; ///< whether the reference is a scan
    Figures figures;       ///< of all patches
    /// Paths along the borders across which patches are not smooth.
    std::optional<std::vector<std::vector<int>>> creases = {};
    /// Where the document says that something is.
    struct Claim {
        int patch = -1;
        std::array<double, 2> at{};
        std::array<double, 3> point{};
    };
    std::optional<Claim> farthest = {}; ///< from the reference
    std::vector<Claim> folds = {};
    std::vector<Patch> patches;
};

/// What a person demanded, as paths along edges.
struct ConstraintsPart {
    std::vector<std::vector<int>> required;
    std::vector<std::vector<int>> forbidden;
    struct Weight {
        std::vector<int> vertices;
        double weight = 0;
    };
    std::vector<Weight> weights = {};
};

struct CheckedDocument {
    std::optional<ConstraintsPart> constraints;
    std::optional<BaseComplexPart> baseComplex;
    std::optional<FeaturesPart> features;
    std::optional<CutPart> cut;
    std::optional<EnumerationPart> enumeration;
    std::optional<CostWeights> weights;
    std::optional<LayoutPart> layout;
    std::optional<SurfacesPart> surfaces;
};

} // namespace qm::check
