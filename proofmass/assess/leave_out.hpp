// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "proofmass/core/dataset.hpp"
#include "proofmass/core/identification.hpp"

namespace proofmass {

// Fills leave_one_out and, where the rows have mounts, leave_one_mount_out: errors of each row as predicted
// by the fit without it, and without its mount. Exact where the weights of the rows are fixed (ols; wls by
// sigma_E), one step with the weights held otherwise; a finding says which. Only for methods that fit all
// rows when they are not told otherwise, after a fit to these rows. Mounts are left out where there are two
// or more; rows without a label belong to none.
void add_leave_out_scores(Identification& result, const Dataset& fitted);

}  // namespace proofmass
