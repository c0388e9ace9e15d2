#pragma once
/// \file
/// A finding as JSON.

#include <nlohmann/json.hpp>

#include "finding.hpp"

namespace checker {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Diagnosis, mistake, slips, region, argument, limit, value)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Finding, property, diagnosis, detail, trace, arguments, result, right)

}  // namespace checker
