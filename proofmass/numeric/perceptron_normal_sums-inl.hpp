// SPDX-License-Identifier: Apache-2.0
// Normal equations of a network by all its weights, compiled once for every instruction set: included by
// perceptron_kernels.cpp alone, through foreach_target, so without an ordinary include guard.
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

#include "proofmass/numeric/perceptron_kernels-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace proofmass {
namespace HWY_NAMESPACE {

// Products of the inputs two and two, each input taken last being one: x_1 x_1, x_1 x_2, … x_1, x_2 x_2, …
// x_I, 1.
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
  std::copy_n(samples.mask_data() + first, rows, moments);
}

// Activations, ones and error of a block, one after the other, and slopes unless null.
void HiddenOutputBlock(const Network& network, const Samples& samples, std::size_t first, std::size_t rows,
                       double* hidden, double* slopes) {
  double* const ones = hidden + network.shape.hidden * kStride;
  HiddenBlock(network, samples, first, rows,
              {.activation = hidden, .slope = slopes, .error = ones + kStride});
  std::copy_n(samples.mask_data() + first, rows, ones);
}

// The sum of squared errors, in a pass that leaves activations and errors.
double KeepingForward(const PerceptronShape& shape, const double* weights, const Samples& samples,
                      BlockColumns& columns) {
  const Network network{shape, weights, kNoColumns};
  V sums = hn::Zero(kD);
  ForEachBlock(samples, [&](std::size_t first, std::size_t rows) HWY_ATTR {
    double* const hidden = columns.block(first, nullptr);
    HiddenOutputBlock(network, samples, first, rows, hidden, nullptr);
    const double* const error = hidden + (network.shape.hidden + 1) * kStride;
    for (std::size_t at = 0; at < rows; at += kLanes) {
      const V e = hn::LoadU(kD, error + at);
      sums = hn::MulAdd(e, e, sums);
    }
  });
  return hn::GetLane(hn::SumOfLanes(kD, sums));
}

// The sums that make up JᵀJ, Jᵀe and eᵀe, and the columns of a block that they are taken over. As every
// derivative by a hidden weight is a unit's slope times an input or one, products of two slopes and of two
// inputs serve for many elements each.
class NormalSums {
 public:
  NormalSums(const Network& network, const Samples& samples, PerceptronColumns& columns)
      : network_(network),
        samples_(samples),
        columns_(columns),
        inputs_(network.shape.inputs),
        hidden_(network.shape.hidden),
        slopes_(hidden_ * (hidden_ + 1) / 2, (inputs_ + 1) * (inputs_ + 2) / 2, false),
        cross_(hidden_ * (inputs_ + 1), hidden_ + 2, false),
        outputs_(hidden_ + 2, hidden_ + 2, true) {
    slope_ = LayOut(hidden_ * kStride + columns.hidden.block_size() + columns.moments.block_size(), slopes_,
                    cross_, outputs_);
    scratch_ = slope_ + hidden_ * kStride;
  }

  // `kept`: whether activations and errors are there already.
  void run(bool kept) {
    kept = kept && columns_.hidden.keeps();
    const bool moments_kept = std::exchange(columns_.moments_known, columns_.moments.keeps());
    ForEachBlock(samples_, [&](std::size_t first, std::size_t rows) HWY_ATTR {
      double* const hidden = columns_.hidden.block(first, scratch_);
      double* const moments = columns_.moments.block(first, scratch_ + columns_.hidden.block_size());
      if (kept) {
        HiddenBlock<true>(network_, samples_, first, rows, {.activation = hidden, .slope = slope_});
      } else {
        HiddenOutputBlock(network_, samples_, first, rows, hidden, slope_);
      }
      if (!moments_kept) MomentBlock(samples_, first, rows, moments);
      add(hidden, moments, rows);
    });
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
  // Adds the products of a block's columns: activations, ones and error, and products of inputs.
  void add(const double* hidden, const double* moments, std::size_t rows) {
    for (std::size_t c = 0; c < hidden_ + 2; ++c) outputs_.left[c] = {hidden + c * kStride, nullptr};
    outputs_.right = cross_.right = hidden;
    slopes_.right = moments;
    for (std::size_t i = 0, pair = 0; i < hidden_; ++i) {
      const double* const slope = slope_ + i * kStride;
      for (std::size_t j = i; j < hidden_; ++j, ++pair) slopes_.left[pair] = {slope, slope_ + j * kStride};
      for (std::size_t k = 0; k <= inputs_; ++k) {
        cross_.left[i * (inputs_ + 1) + k] = {slope, moments + moment(k, inputs_) * kStride};
      }
    }
    for (ProductSums* list : {&slopes_, &cross_, &outputs_}) list->add(rows);
  }

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
  PerceptronColumns& columns_;
  std::size_t inputs_, hidden_;
  ProductSums slopes_, cross_, outputs_;
  double* slope_ = nullptr;    // of each unit in a block
  double* scratch_ = nullptr;  // of columns that are not kept
};

}  // namespace HWY_NAMESPACE
}  // namespace proofmass
HWY_AFTER_NAMESPACE();

#endif  // PROOFMASS_PERCEPTRON_NORMAL_SUMS_INL
