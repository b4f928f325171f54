#include "base/decimal.h"

#include "base/big_count.h"

namespace qm {

std::string decimalProduct(std::span<const std::string> factors) {
    BigCount product = 1;
    for (const std::string& factor : factors)
        product *= BigCount(factor);
    return product.str();
}

} // namespace qm
