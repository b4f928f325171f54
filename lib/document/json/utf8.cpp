#include "document/json/utf8.h"

#include "base/error.h"
#include "document/json/json.h"

namespace qm {

bool isUtf8(std::string_view text) {
    try {
        (void)Json(std::string(text)).dump();
    } catch (const Json::type_error&) { // as it writes nothing else
        return false;
    }
    return true;
}

void requireUtf8Name(const std::string& path) {
    if (!isUtf8(path))
        throw Error("", "its name is not UTF-8, so no document can refer to it", "Rename the file");
}

} // namespace qm
