// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contract/contend.hpp"

namespace bench::ours {

Answer forward(const Request& request);
Answer kernels(const Request& request);
Answer train(const Request& request);
Answer least_squares(const Request& request);
Answer read(const Request& request);

}  // namespace bench::ours
