// SPDX-License-Identifier: Apache-2.0
// Normal equations of a network by all its weights, compiled once for every instruction set: included through
// foreach_target, so without an ordinary include guard.
#if defined(PROOFMASS_PERCEPTRON_NORMAL_SUMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_PERCEPTRON_NORMAL_SUMS_INL
#undef PROOFMASS_PERCEPTRON_NORMAL_SUMS_INL
#else
#define PROOFMASS_PERCEPTRON_NORMAL_SUMS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

#include "proofmass/numeric/kernel_scratch_internal.hpp"
#include "proofmass/numeric/perceptron_kernels-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

// The sums that make up JᵀJ, Jᵀe and eᵀe, and the columns of a block that they are taken over. As every
// derivative by a hidden weight is a unit's slope times an input or one, products of two slopes and of two
// inputs serve for many elements each.
class NormalSums {
 public:
  NormalSums(const Network& network, const Samples& samples)
      : network_(network),
        samples_(samples),
        inputs_(network.shape.inputs),
        hidden_(network.shape.hidden),
        slopes_(hidden_ * (hidden_ + 1) / 2, (inputs_ + 1) * (inputs_ + 2) / 2, false),
        cross_(hidden_ * (inputs_ + 1), hidden_ + 2, false),
        outputs_(hidden_ + 2, hidden_ + 2, true) {
    lay_out();
  }

  void run() {
    for (std::size_t first = 0; first < samples_.padded_rows(); first += kBlockRows) {
      const std::size_t rows = std::min(kBlockRows, samples_.padded_rows() - first);
      HiddenBlock(network_, samples_, first, rows, columns_);
      MomentBlock(samples_, first, rows, moments_);
      std::copy_n(samples_.mask_data() + first, rows, columns_.activation + hidden_ * kStride);
      for (ProductSums* list : {&slopes_, &cross_, &outputs_}) list->add(rows);
    }
    for (ProductSums* list : {&slopes_, &cross_, &outputs_}) list->finish();
  }

  // Returns eᵀe.
  double store(Matrix& jtj, double* jte) const {
    const std::size_t first = network_.shape.hidden_weights();
    for (std::size_t c = 0; c <= hidden_; ++c) {
      for (std::size_t r = 0; r <= c; ++r) {
        jtj(first + r, first + c) = jtj(first + c, first + r) = outputs_.total(r, c);
      }
      jte[first + c] = outputs_.total(c, hidden_ + 1);
    }
    for (std::size_t j = 0; j < hidden_; ++j) {
      for (std::size_t k = 0; k <= inputs_; ++k) store_row(j, k, jtj, jte);
    }
    return outputs_.total(hidden_ + 1, hidden_ + 1);
  }

 private:
  // Gives sums and columns their places in the scratch memory, and sums the columns that they are of.
  void lay_out() {
    const std::size_t sums = slopes_.storage() + cross_.storage() + outputs_.storage();
    const std::size_t columns = 2 * hidden_ + 2 + (inputs_ + 1) * (inputs_ + 2) / 2;
    double* next = kernel_scratch(sums + columns * kStride);
    std::fill_n(next, sums, 0.0);
    for (ProductSums* list : {&slopes_, &cross_, &outputs_}) {
      list->start(next);
      next += list->storage();
    }
    columns_.activation = next;  // then ones, then the error
    columns_.error = next + (hidden_ + 1) * kStride;
    columns_.slope = columns_.error + kStride;
    moments_ = columns_.slope + hidden_ * kStride;
    for (std::size_t c = 0; c < hidden_ + 2; ++c) outputs_.left[c] = {next + c * kStride, nullptr};
    outputs_.right = cross_.right = next;
    slopes_.right = moments_;
    for (std::size_t i = 0, pair = 0; i < hidden_; ++i) {
      for (std::size_t j = i; j < hidden_; ++j, ++pair) slopes_.left[pair] = {slope(i), slope(j)};
      for (std::size_t k = 0; k <= inputs_; ++k) {
        cross_.left[i * (inputs_ + 1) + k] = {slope(i), moments_ + moment(k, inputs_) * kStride};
      }
    }
  }

  [[nodiscard]] const double* slope(std::size_t j) const { return columns_.slope + j * kStride; }

  // The number of the product of inputs k and l, the last input being one.
  [[nodiscard]] std::size_t moment(std::size_t k, std::size_t l) const {
    const std::size_t low = std::min(k, l);
    return low * (2 * inputs_ + 1 - low) / 2 + std::max(k, l);
  }

  // The weight of input k into unit j, or its bias, among all weights.
  [[nodiscard]] std::size_t weight(std::size_t j, std::size_t k) const {
    return k < inputs_ ? j * inputs_ + k : hidden_ * inputs_ + j;
  }

  // What the weight of input k into unit j has to do with those of the units from j on and with the output
  // layer.
  void store_row(std::size_t j, std::size_t k, Matrix& jtj, double* jte) const {
    const std::size_t at = weight(j, k);
    const std::size_t row = j * (inputs_ + 1) + k;
    const std::size_t first = network_.shape.hidden_weights();
    for (std::size_t c = 0; c <= hidden_; ++c) jtj(at, first + c) = jtj(first + c, at) = cross_.total(row, c);
    jte[at] = cross_.total(row, hidden_ + 1);
    for (std::size_t i = j; i < hidden_; ++i) {
      const std::size_t pair = j * (2 * hidden_ - j - 1) / 2 + i;
      for (std::size_t l = 0; l <= inputs_; ++l) {
        jtj(at, weight(i, l)) = jtj(weight(i, l), at) = slopes_.total(pair, moment(k, l));
      }
    }
  }

  const Network& network_;
  const Samples& samples_;
  std::size_t inputs_, hidden_;
  ProductSums slopes_, cross_, outputs_;
  HiddenColumns columns_{};
  double* moments_ = nullptr;  // products of inputs
};

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_PERCEPTRON_NORMAL_SUMS_INL
