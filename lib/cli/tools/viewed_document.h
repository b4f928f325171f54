/// \file The scenes that qm-view makes of documents.
#pragma once

#include "bspline/reference/scan/triangle_surface.h"
#include "cli/stage.h"
#include "cli/tools/view_request.h"
#include "view/scene.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace qm {

/// The tool's document and, if given, another one to its left.
class ViewedDocuments {
public:
    /// Reads the documents.
    ViewedDocuments(const Tool& tool, Stage& stage, const ViewRequest& request);
    ViewedDocuments(const ViewedDocuments&) = delete;
    ViewedDocuments& operator=(const ViewedDocuments&) = delete;

    /// One scene for every document.
    [[nodiscard]] std::vector<Scene> forPage() const;
    /// The same with no more points than a picture with so many pixels can show.
    [[nodiscard]] std::vector<Scene> forPicture(int width, int height) const;

private:
    struct Part {
        const Document* document;
        const Model* model;
        std::optional<TriangleSurface> scan;
    };
    [[nodiscard]] std::vector<Scene> scenes(std::optional<std::size_t> maxPoints) const;

    const Tool& tool_;
    LengthUnit unit_;
    Document other_;
    Model otherModel_;
    std::vector<Part> parts_; ///< from left to right
};

} // namespace qm
