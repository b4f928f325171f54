/// \file Numbers of any size.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

namespace qm {

/// Graph counts pass 2^64.
using BigCount = boost::multiprecision::cpp_int;

} // namespace qm
