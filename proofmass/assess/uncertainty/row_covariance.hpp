// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"
#include "proofmass/identify/method.hpp"

namespace proofmass {

// Before a fit: throws a usage Error when the method has no such covariance, bad data when the record lacks
// the mounts that it goes by. `model` is always well.
void require_covariance(const Dataset& record, const Method& method, CovarianceKind kind);

// Puts the covariance by rows (HC3) or by mounts (CR3) in the place of the model's after a fit to these rows,
// with its standard errors, and says so; `model` changes nothing. Throws a refusal that names the row or
// mount without which the terms cannot be identified.
void use_covariance(Identification& result, const Dataset& fitted, CovarianceKind kind);

}  // namespace proofmass
