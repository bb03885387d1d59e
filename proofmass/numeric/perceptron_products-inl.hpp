// SPDX-License-Identifier: Apache-2.0
// The sums of products that training needs, block after block of samples, compiled once for every instruction
// set: included through foreach_target, so without an ordinary include guard.
#if defined(PROOFMASS_PERCEPTRON_PRODUCTS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_PERCEPTRON_PRODUCTS_INL
#undef PROOFMASS_PERCEPTRON_PRODUCTS_INL
#else
#define PROOFMASS_PERCEPTRON_PRODUCTS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "proofmass/numeric/perceptron_kernels-inl.hpp"

namespace proofmass {
// Working storage of a pass, kept by each thread for its next one. What it holds is undefined.
double* kernel_scratch(std::size_t size);
}  // namespace proofmass

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

// The sums that make up PerceptronProducts, and the columns of a block that they are taken over.
class Products {
 public:
  // Without a transform q is phi; there are no fixed columns then.
  Products(const Network& network, const Samples& samples, const Matrix* transform, bool derivatives)
      : network_(network),
        samples_(samples),
        transform_(transform),
        inputs_(network.shape.inputs),
        units_(derivatives ? network.shape.hidden : 0),
        n_(network.shape.output_weights() + network.fixed.columns()),
        phi_(n_),
        pairs_(units_ * (units_ + 1) / 2, (inputs_ + 1) * (inputs_ + 2) / 2, false),
        cross_(units_ * (inputs_ + 1), n_ + 1, false),
        gram_(n_, n_ + 1, true),
        error_(1, 1, false) {
    lay_out(derivatives);
  }

  void run() {
    for (std::size_t first = 0; first < samples_.padded_rows(); first += kBlockRows) {
      const std::size_t rows = std::min(kBlockRows, samples_.padded_rows() - first);
      HiddenBlock(network_, samples_, first, rows, hidden_);
      const double* const ones = samples_.mask_data() + first;
      if (transform_ == nullptr) {
        std::copy_n(ones, rows, linear_ + network_.shape.hidden * kStride);
      } else {
        phi_[network_.shape.hidden] = ones;
        for (std::size_t c = 0; c < network_.fixed.columns(); ++c) {
          phi_[network_.shape.output_weights() + c] = network_.fixed.column(c) + first;
        }
        TransformBlock(phi_.data(), *transform_, rows, linear_);
      }
      for (std::size_t c = 0; c < n_; ++c) gram_.left[c][1] = ones;
      error_.left[0][1] = ones;
      gram_.add(rows);
      error_.add(rows);
      if (units_ == 0) continue;
      MomentBlock(samples_, first, rows, moments_);
      pairs_.add(rows);
      cross_.add(rows);
    }
  }

  void store(PerceptronProducts& products) {
    for (ProductSums* list : {&pairs_, &cross_, &gram_, &error_}) list->finish();
    products.ee = error_.total(0, 0);
    for (std::size_t c = 0; c < n_; ++c) {
      for (std::size_t r = 0; r <= c; ++r) products.qq(r, c) = products.qq(c, r) = gram_.total(r, c);
      products.qe[c] = gram_.total(c, n_);
    }
    for (std::size_t j = 0; j < units_; ++j) {
      for (std::size_t k = 0; k <= inputs_; ++k) store_derivative(j, k, products);
    }
  }

 private:
  // Gives sums and columns their places in the scratch memory, and sums the columns that they are of.
  void lay_out(bool derivatives) {
    const std::size_t hidden = network_.shape.hidden;
    const std::size_t sums = pairs_.storage() + cross_.storage() + gram_.storage() + error_.storage();
    const std::size_t columns = 2 * hidden + n_ + 1 + (inputs_ + 1) * (inputs_ + 2) / 2;
    double* next = kernel_scratch(sums + columns * kStride);
    std::fill_n(next, sums, 0.0);
    for (ProductSums* list : {&pairs_, &cross_, &gram_, &error_}) {
      list->start(next);
      next += list->storage();
    }
    const auto take = [&next](std::size_t count) { return std::exchange(next, next + count * kStride); };
    linear_ = take(n_ + 1);
    hidden_ = {.activation = transform_ == nullptr ? linear_ : take(hidden),
               .slope = derivatives ? take(hidden) : nullptr,
               .error = linear_ + n_ * kStride};
    moments_ = next;
    for (std::size_t j = 0; j < hidden; ++j) phi_[j] = hidden_.activation + j * kStride;
    for (std::size_t c = 0; c < n_; ++c) gram_.left[c][0] = linear_ + c * kStride;
    error_.left[0][0] = error_.right = hidden_.error;
    gram_.right = cross_.right = linear_;
    pairs_.right = moments_;
    for (std::size_t i = 0, pair = 0; i < units_; ++i) {
      for (std::size_t j = i; j < units_; ++j, ++pair) pairs_.left[pair] = {slope(i), slope(j)};
      for (std::size_t k = 0; k <= inputs_; ++k) {
        cross_.left[i * (inputs_ + 1) + k] = {slope(i), moments_ + moment(k, inputs_) * kStride};
      }
    }
  }

  [[nodiscard]] const double* slope(std::size_t j) const { return hidden_.slope + j * kStride; }

  // The number of the product of inputs k and l, the last input being one.
  [[nodiscard]] std::size_t moment(std::size_t k, std::size_t l) const {
    const std::size_t low = std::min(k, l);
    return low * (2 * inputs_ + 1 - low) / 2 + std::max(k, l);
  }

  // The weight of input k into unit j, or its bias, among all hidden weights.
  [[nodiscard]] std::size_t weight(std::size_t j, std::size_t k) const {
    return k < inputs_ ? j * inputs_ + k : network_.shape.hidden * inputs_ + j;
  }

  // The row of D that belongs to input k of unit j, with the columns from unit j on.
  void store_derivative(std::size_t j, std::size_t k, PerceptronProducts& products) const {
    const std::size_t at = weight(j, k);
    const std::size_t row = j * (inputs_ + 1) + k;
    for (std::size_t c = 0; c < n_; ++c) products.dq(at, c) = cross_.total(row, c);
    products.de[at] = cross_.total(row, n_);
    for (std::size_t i = j; i < units_; ++i) {
      const std::size_t pair = j * (2 * units_ - j - 1) / 2 + i;
      for (std::size_t l = 0; l <= inputs_; ++l) {
        products.dd(at, weight(i, l)) = products.dd(weight(i, l), at) = pairs_.total(pair, moment(k, l));
      }
    }
  }

  const Network& network_;
  const Samples& samples_;
  const Matrix* transform_;
  std::size_t inputs_;
  std::size_t units_;  // whose derivatives are wanted
  std::size_t n_;      // columns that the output is linear in
  std::vector<const double*> phi_;
  ProductSums pairs_, cross_, gram_, error_;
  HiddenColumns hidden_{};
  double* linear_ = nullptr;   // q, then the error
  double* moments_ = nullptr;  // products of inputs
};

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_PERCEPTRON_PRODUCTS_INL
