/// \file A schema as Valijson keeps it. Apart from validation, because both take long to compile.
#pragma once

#include "document/json.h"

namespace valijson {
class Schema;
}

namespace qm {

/// \param compiled  new; what the schema says is put into it
void parseSchema(const Json& schema, valijson::Schema& compiled);

} // namespace qm
