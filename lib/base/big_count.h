/// \file Numbers of any size.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace qm {

/// Numbers of graphs exceed 2^64.
using BigCount = boost::multiprecision::cpp_int;

} // namespace qm
