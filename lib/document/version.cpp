#include "document/version.h"

namespace qm {

std::string version() {
    return QM_VERSION;
}

} // namespace qm
