#include "document/schema/schema_view.h"
#include "document/schema/schema_violation.h"

#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>

namespace qm {

void parseSchema(const Json& schema, valijson::Schema& compiled) {
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(schema_view::Adapter(schema), compiled);
}

} // namespace qm
