// SPDX-License-Identifier: Apache-2.0
// GSL's nonlinear least squares. Variants: lm and lmaccel (with geodesic acceleration). The same program is
// linked to GSL's own BLAS and to OpenBLAS.
#include <gsl/gsl_blas.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <gsl/gsl_version.h>

#include <cmath>
#include <memory>

#include "contract/contend.hpp"
#include "peers/blas.hpp"
#include "peers/network.hpp"

namespace {

using namespace bench;
using peers::Network;

int residuals(const gsl_vector* x, void* network, gsl_vector* f) {
  static_cast<Network*>(network)->residuals(x->data, f->data);
  return GSL_SUCCESS;
}

int jacobian(const gsl_vector* x, void* network, gsl_matrix* j) {
  static_cast<Network*>(network)->jacobian(x->data, j->data);
  return GSL_SUCCESS;
}

int second_derivative(const gsl_vector* x, const gsl_vector* v, void* network, gsl_vector* fvv) {
  static_cast<Network*>(network)->second_derivative(x->data, v->data, fvv->data);
  return GSL_SUCCESS;
}

gsl_multifit_nlinear_fdf problem_of(Network& network) {
  gsl_multifit_nlinear_fdf problem{};
  problem.f = residuals;
  problem.df = jacobian;
  problem.fvv = second_derivative;
  problem.n = network.rows();
  problem.p = peers::kParameters;
  problem.params = &network;
  return problem;
}

// An iteration of GSL ends with an accepted step, or with an error when there is none.
Trained train_one(gsl_multifit_nlinear_workspace* work, gsl_multifit_nlinear_fdf& problem,
                  std::span<const double> start, std::size_t epochs) {
  const gsl_vector_const_view x = gsl_vector_const_view_array(start.data(), start.size());
  gsl_multifit_nlinear_init(&x.vector, &problem, work);
  while (work->niter < epochs && gsl_multifit_nlinear_iterate(work) == GSL_SUCCESS) {
  }
  double sum = 0.0;
  gsl_blas_ddot(work->f, work->f, &sum);
  return {.weights = {work->x->data, work->x->data + work->x->size},
          .rmse = std::sqrt(sum / static_cast<double>(problem.n)),
          .epochs = work->niter};
}

Answer train(const Request& request) {
  gsl_set_error_handler_off();
  const NetworkSamples samples = read_samples(request);
  Network network(samples);
  gsl_multifit_nlinear_fdf problem = problem_of(network);
  gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
  parameters.solver = gsl_multifit_nlinear_solver_cholesky;  // its fastest solver
  parameters.trs =
      request.variant == "lmaccel" ? gsl_multifit_nlinear_trs_lmaccel : gsl_multifit_nlinear_trs_lm;
  const std::unique_ptr<gsl_multifit_nlinear_workspace, decltype(&gsl_multifit_nlinear_free)> work(
      gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, problem.n, problem.p),
      gsl_multifit_nlinear_free);
  Answer answer = contend_training(request, samples, [&](std::span<const double> start, std::size_t epochs) {
    return train_one(work.get(), problem, start, epochs);
  });
  answer.about["version"] = gsl_version;
  answer.about["blas"] = peers::blas_kernel();
  return answer;
}

}  // namespace

int main(int argc, char** argv) { return contend(argc, argv, {{"train", train}}); }
