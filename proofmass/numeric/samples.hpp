// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <new>
#include <span>
#include <vector>

namespace proofmass {

// Memory whose first element starts a cache line, for vector loads.
template <typename T>
struct CacheAligned {
  using value_type = T;
  static constexpr std::align_val_t kAlignment{64};
  CacheAligned() = default;
  template <typename U>
  explicit CacheAligned(const CacheAligned<U>&) noexcept {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), kAlignment)); }
  void deallocate(T* p, std::size_t) noexcept { ::operator delete(p, kAlignment); }
  bool operator==(const CacheAligned&) const noexcept { return true; }
};
using AlignedColumn = std::vector<double, CacheAligned<double>>;

// Inputs and target of a regression as columns. They are padded with zero rows to a multiple of the widest
// vectors, so that kernels need no special case for the last rows. `mask` is 1 for rows and 0 for padding.
class Samples {
 public:
  static constexpr std::size_t kRowMultiple = 8;

  Samples(std::size_t inputs, std::size_t rows);

  [[nodiscard]] std::size_t inputs() const noexcept { return inputs_.size(); }
  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }
  [[nodiscard]] std::size_t padded_rows() const noexcept { return mask_.size(); }
  [[nodiscard]] std::span<double> input(std::size_t k) noexcept { return {inputs_[k].data(), rows_}; }
  [[nodiscard]] std::span<double> target() noexcept { return {target_.data(), rows_}; }
  [[nodiscard]] std::span<const double> target() const noexcept { return {target_.data(), rows_}; }

  // padded_rows() long each.
  [[nodiscard]] const double* input_data(std::size_t k) const noexcept { return inputs_[k].data(); }
  [[nodiscard]] const double* target_data() const noexcept { return target_.data(); }
  [[nodiscard]] const double* mask_data() const noexcept { return mask_.data(); }

 private:
  std::size_t rows_;
  std::vector<AlignedColumn> inputs_;
  AlignedColumn target_;
  AlignedColumn mask_;
};

// The root mean square that belongs to a sum of squares over the samples.
[[nodiscard]] double root_mean(double sum_of_squares, const Samples& samples);

}  // namespace proofmass
