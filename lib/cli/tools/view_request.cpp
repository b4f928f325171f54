#include "cli/tools/view_request.h"

#include "cli/system/browser.h"
#include "cli/system/output_file.h"
#include "cli/tools/viewed_document.h"
#include "view/view_options.h"

namespace qm {
namespace {

PageOptions pageOptions(const ViewRequest& request) {
    return {parseLayers(request.show), parseDirection(request.from), parseDirection(request.up),
            parseSection(request.section)};
}

} // namespace

void verify(const Tool& tool, const ViewRequest& request) {
    (void)parseSize(request.size);
    (void)pageOptions(request);
    if (tool.given("output") && isSameFile(request.png, tool.outputPath()))
        throw UsageError("page and picture cannot go to the same place");
}

void writeViews(const Tool& tool, Stage& stage, const ViewRequest& request) {
    const ViewedDocuments documents(tool, stage, request);
    PageOptions options = pageOptions(request);
    const bool isPictured = !request.png.empty();
    if (isPictured) verifyWritable(request.png); // before the page appears
    if (!isPictured || tool.given("output")) tool.write(printPage(documents.forPage(), options));
    if (!isPictured) return;
    options.still = true;
    options.key = request.key;
    const auto [width, height] = parseSize(request.size);
    const std::string page = printPage(documents.forPicture(width, height), options);
    writeFile(request.png, photographPage(page, width, height));
}

} // namespace qm
