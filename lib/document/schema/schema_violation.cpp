#include "document/schema/schema_violation.h"

#include "document/schema/schema_view.h"

#include <valijson/schema.hpp>
#include <valijson/validator.hpp>

namespace qm {

std::optional<SchemaViolation> firstViolation(const Json& root, const Json& schema) {
    valijson::Schema compiled;
    parseSchema(schema, compiled);
    valijson::ValidationResults results;
    valijson::Validator validator;
    if (validator.validate(compiled, schema_view::Adapter({&root, &results}), &results)) return {};
    valijson::ValidationResults::Error first;
    results.popError(first);
    return SchemaViolation{first.context, first.description};
}

} // namespace qm
