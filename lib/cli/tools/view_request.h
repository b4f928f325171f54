/// \file Requests to qm-view: a page, a picture of it, or both.
#pragma once

#include "cli/stage.h"
#include "cli/tools/export_choices.h"

#include <string>

namespace qm {

/// Texts as users give them (see view/view_options.h); empty where something is not asked for.
struct ViewRequest {
    std::string png; ///< file of the picture
    std::string size = "1200x900";
    std::string show;
    std::string from = "1,-1.5,0.9";
    std::string up = "0,0,1";
    std::string section;
    std::string compare;   ///< file of another document, to be shown to the left
    std::string reference; ///< file of the scan, if it is not the recorded one
    LengthUnit unit = LengthUnit::mm;
    bool key = true; ///< whether the picture has one
};

/// \throw UsageError, Error  if a text has not the right form, or page and picture would be one file
void verify(const Tool& tool, const ViewRequest& request);

/// Reads the documents, and writes the page, the picture or both.
void writeViews(const Tool& tool, Stage& stage, const ViewRequest& request);

} // namespace qm
