// SPDX-License-Identifier: Apache-2.0
// Proofmass as a contestant; the contract is in contract/request.hpp.
#include "contract/target.hpp"
#include "ours/tasks.hpp"
#include "proofmass/numeric/network/perceptron_kernels.hpp"
#include "proofmass/numeric/parallel.hpp"

namespace {

using namespace bench;

Task on_one_thread(Answer (*task)(const Request&)) {
  return [task](const Request& request) {
    const proofmass::ThreadLimit limit(1);
    if (!request.target.empty()) force_target(request.target);
    Answer answer = task(request);
    answer.about["target"] = proofmass::kernel_target();
    return answer;
  };
}

}  // namespace

int main(int argc, char** argv) {
  return contend(argc, argv,
                 {{"forward", on_one_thread(ours::forward)},
                  {"kernels", on_one_thread(ours::kernels)},
                  {"train", on_one_thread(ours::train)},
                  {"least-squares", on_one_thread(ours::least_squares)},
                  {"read", on_one_thread(ours::read)}});
}
