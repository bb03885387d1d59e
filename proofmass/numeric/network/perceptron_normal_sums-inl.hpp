// SPDX-License-Identifier: Apache-2.0
// Normal equations of a network by all its weights, compiled once for every instruction set. Only
// perceptron_kernels.cpp includes this file, through foreach_target, so it has no ordinary include guard.
#if defined(PROOFMASS_PERCEPTRON_NORMAL_SUMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROOFMASS_PERCEPTRON_NORMAL_SUMS_INL
#undef PROOFMASS_PERCEPTRON_NORMAL_SUMS_INL
#else
#define PROOFMASS_PERCEPTRON_NORMAL_SUMS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "proofmass/numeric/network/perceptron_kernels-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

// Products of pairs of inputs, with each input alone as well: x_1 x_1, x_1 x_2, … x_1, x_2 x_2, … x_I.
void MomentBlock(const Samples& samples, std::size_t first, std::size_t rows, double* moments) {
  for (std::size_t k = 0; k < samples.inputs(); ++k) {
    const double* const x = samples.input_data(k) + first;
    for (std::size_t l = k; l < samples.inputs(); ++l, moments += kStride) {
      const double* const y = samples.input_data(l) + first;
      for (std::size_t at = 0; at < rows; at += kLanes) {
        hn::StoreU(hn::Mul(hn::LoadU(kD, x + at), hn::LoadU(kD, y + at)), kD, moments + at);
      }
    }
    std::copy_n(x, rows, moments);
    moments += kStride;
  }
}

// Activations, error and slopes of a block, one after the other.
void HiddenOutputBlock(const Network& network, const Samples& samples, std::size_t first, std::size_t rows,
                       double* hidden) {
  double* const error = hidden + network.shape.hidden * kStride;
  HiddenBlock(network, samples, first, rows,
              {.activation = hidden, .slope = error + kStride, .error = error});
}

// The sum of squared errors, in a pass that keeps activations and errors.
double KeepingForward(const PerceptronShape& shape, const double* weights, const Samples& samples,
                      BlockColumns& columns) {
  const Network network{shape, weights, kNoColumns};
  V sums = hn::Zero(kD);
  ForEachBlock(samples, [&](std::size_t first, std::size_t rows) HWY_ATTR {
    double* const hidden = columns.block(first, nullptr);
    HiddenOutputBlock(network, samples, first, rows, hidden);
    const double* const error = hidden + network.shape.hidden * kStride;
    for (std::size_t at = 0; at < rows; at += kLanes) {
      const V e = hn::LoadU(kD, error + at);
      sums = hn::MulAdd(e, e, sums);
    }
  });
  return hn::GetLane(hn::SumOfLanes(kD, sums));
}

// The sums that JᵀJ, Jᵀe and eᵀe consist of, and the columns of a block that they are taken over. Every
// derivative by a hidden weight is a unit's output weight and slope times an input or one. Products of two
// slopes and of two inputs are therefore used for many elements each.
class NormalSums {
 public:
  NormalSums(const Network& network, const Samples& samples, PerceptronColumns& columns)
      : network_(network),
        samples_(samples),
        columns_(columns),
        inputs_(network.shape.inputs),
        hidden_(network.shape.hidden),
        slopes_({.rows = hidden_ * (hidden_ + 1) / 2,
                 .columns = moment(inputs_, inputs_),
                 .pairs = true,
                 .ones = true}),
        weights_({.rows = hidden_ * inputs_, .columns = hidden_ + 1, .pairs = true, .ones = true}),
        biases_({.rows = hidden_, .columns = hidden_ + 1, .ones = true}),
        outputs_({.rows = hidden_ + 1, .columns = hidden_ + 1, .ones = true, .upper = true}) {
    scratch_ = LayOut(columns.hidden.block_size() + columns.moments.block_size(), slopes_, weights_, biases_,
                      outputs_);
  }

  // `kept`: activations and errors are already filled.
  void run(bool kept) {
    kept = kept && columns_.hidden.keeps();
    const bool moments_kept = std::exchange(columns_.moments_known, columns_.moments.keeps());
    ForEachBlock(samples_, [&](std::size_t first, std::size_t rows) HWY_ATTR {
      double* const hidden = columns_.hidden.block(first, scratch_);
      double* const moments = columns_.moments.block(first, scratch_ + columns_.hidden.block_size());
      if (!kept) HiddenOutputBlock(network_, samples_, first, rows, hidden);
      if (!moments_kept) MomentBlock(samples_, first, rows, moments);
      add(hidden, moments, rows);
    });
    for (ProductSums* list : {&slopes_, &weights_, &biases_, &outputs_}) list->finish();
  }

  // Fills the lower triangle of JᵀJ; returns eᵀe.
  double store(Matrix& jtj, double* jte) const {
    const std::size_t first = network_.shape.hidden_weights();
    const std::size_t bias = first + hidden_;
    for (std::size_t j = 0; j < hidden_; ++j) {
      for (std::size_t k = j * inputs_; k < (j + 1) * inputs_; ++k) store_row(j, k, weights_, k, jtj, jte);
      store_row(j, hidden_ * inputs_ + j, biases_, j, jtj, jte);
      for (std::size_t i = j; i < hidden_; ++i) store_pair(j, i, jtj);
      for (std::size_t i = j; i < hidden_; ++i) jtj(first + i, first + j) = outputs_.total(j, i);
      jtj(bias, first + j) = outputs_.total(j, hidden_ + 1);
      jte[first + j] = outputs_.total(j, hidden_);
    }
    jtj(bias, bias) = static_cast<double>(samples_.rows());
    jte[bias] = outputs_.total(hidden_, hidden_ + 1);
    return outputs_.total(hidden_, hidden_);
  }

 private:
  // Adds the products of a block's columns: activations and error, and products of inputs.
  void add(const double* hidden, const double* moments, std::size_t rows) {
    for (std::size_t c = 0; c <= hidden_; ++c) outputs_.left[c] = {hidden + c * kStride, nullptr};
    outputs_.right = weights_.right = biases_.right = hidden;
    slopes_.right = moments;
    const double* const slopes = hidden + (hidden_ + 1) * kStride;
    for (std::size_t i = 0, pair = 0; i < hidden_; ++i) {
      const double* const slope = slopes + i * kStride;
      for (std::size_t j = i; j < hidden_; ++j, ++pair) slopes_.left[pair] = {slope, slopes + j * kStride};
      for (std::size_t k = 0; k < inputs_; ++k) {
        weights_.left[i * inputs_ + k] = {slope, moments + moment(k, inputs_) * kStride};
      }
      biases_.left[i] = {slope, nullptr};
    }
    for (ProductSums* list : {&slopes_, &weights_, &biases_, &outputs_}) list->add(rows);
  }

  // Index of the product of inputs k and l; input I is the constant one. The product of one with itself comes
  // last.
  [[nodiscard]] std::size_t moment(std::size_t k, std::size_t l) const {
    const std::size_t low = std::min(k, l);
    return low * (2 * inputs_ + 1 - low) / 2 + std::max(k, l);
  }

  // Elements of a hidden weight of unit j (index `at` among all weights) with the output layer, from row
  // `row` of the sums.
  void store_row(std::size_t j, std::size_t at, const ProductSums& sums, std::size_t row, Matrix& jtj,
                 double* jte) const {
    const double v = network_.output[j];
    double* const column = &jtj(network_.shape.hidden_weights(), at);
    for (std::size_t c = 0; c < hidden_; ++c) column[c] = v * sums.total(row, c);
    column[hidden_] = v * sums.total(row, hidden_ + 1);
    jte[at] = v * sums.total(row, hidden_);
  }

  // Elements of the hidden weights of unit i with those of unit j <= i.
  void store_pair(std::size_t j, std::size_t i, Matrix& jtj) const {
    const std::size_t pair = j * (2 * hidden_ - j - 1) / 2 + i;
    const std::size_t bias = hidden_ * inputs_;
    const double both = network_.output[j] * network_.output[i];
    for (std::size_t k = 0; k < inputs_; ++k) {
      for (std::size_t l = 0; l < inputs_; ++l) {
        jtj(i * inputs_ + l, j * inputs_ + k) = both * slopes_.total(pair, moment(k, l));
      }
      jtj(bias + i, j * inputs_ + k) = jtj(bias + j, i * inputs_ + k) =
          both * slopes_.total(pair, moment(k, inputs_));
    }
    jtj(bias + i, bias + j) = both * slopes_.total(pair, moment(inputs_, inputs_));
  }

  const Network& network_;
  const Samples& samples_;
  PerceptronColumns& columns_;
  std::size_t inputs_, hidden_;
  ProductSums slopes_;            // products of two slopes with the products of inputs
  ProductSums weights_, biases_;  // derivatives with activations and error, without the output weight
  ProductSums outputs_;           // activations and error
  double* scratch_ = nullptr;     // memory of columns that are not kept
};

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_PERCEPTRON_NORMAL_SUMS_INL
