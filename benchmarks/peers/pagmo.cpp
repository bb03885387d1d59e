// SPDX-License-Identifier: Apache-2.0
// The RMSE of many networks as the fitness of a pagmo problem.
#include <cmath>
#include <memory>
#include <pagmo/problem.hpp>
#include <pagmo/types.hpp>
#include <utility>

#include "contract/contend.hpp"
#include "peers/network.hpp"

namespace {

using namespace bench;

// As a pagmo user would write it. pagmo copies problems, so the samples are shared.
struct NetworkProblem {
  std::shared_ptr<const peers::Network> network;

  [[nodiscard]] pagmo::vector_double fitness(const pagmo::vector_double& weights) const {
    return {std::sqrt(network->sum_of_squares(weights.data()) / static_cast<double>(network->rows()))};
  }
  [[nodiscard]] std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {pagmo::vector_double(peers::kParameters, -5.0), pagmo::vector_double(peers::kParameters, 5.0)};
  }
};

Answer forward(const Request& request) {
  const auto network = std::make_shared<const peers::Network>(read_samples(request));
  const pagmo::problem problem{NetworkProblem{network}};
  const std::vector<Row> swarm = read_table(request.starts);
  std::vector<double> rmse(swarm.size());
  Answer answer = measure(request.seconds, [&] {
    for (std::size_t k = 0; k < swarm.size(); ++k) rmse[k] = problem.fitness(swarm[k])[0];
  });
  answer.ns = 1e9 * answer.seconds / static_cast<double>(network->rows() * swarm.size());
  answer.values = rmse;
  return answer;
}

}  // namespace

int main(int argc, char** argv) { return contend(argc, argv, {{"forward", forward}}); }
