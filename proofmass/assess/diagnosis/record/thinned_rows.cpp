// SPDX-License-Identifier: Apache-2.0
#include "proofmass/assess/diagnosis/record/thinned_rows.hpp"

#include <numeric>

#include "proofmass/numeric/random.hpp"

namespace proofmass {

std::vector<std::size_t> thinned_rows(std::size_t rows, std::size_t most) {
  std::vector<std::size_t> chosen(rows < most ? rows : most);
  if (rows <= most) {
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    return chosen;
  }
  RandomStream random(0, stream_id("thinned rows"));
  for (std::size_t k = 0; k < most; ++k) {
    const std::size_t first = k * rows / most;
    chosen[k] = first + random.index((k + 1) * rows / most - first);
  }
  return chosen;
}

}  // namespace proofmass
