// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "proofmass/report/plot/figure.hpp"

namespace proofmass {

// Numbers, or their logarithms, along a stretch of an image.
class Scale {
 public:
  // From the place of the least value to that of the largest, in units of the image.
  Scale(double from, double to, bool log = false) : from_(from), to_(to), log_(log) {}

  // A value that must fit; one that is not shown is passed over.
  void include(double value);
  // Widens the range by a margin, and to whole powers of ten where logarithmic. Call it after the last
  // include().
  void finish(double margin = 0.03);

  [[nodiscard]] bool shows(double value) const;
  [[nodiscard]] double place(double value) const;  // in the image
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] bool log() const { return log_; }

  // Round values within the range: 1, 2 or 5 times a power of ten apart; whole powers where logarithmic.
  [[nodiscard]] std::vector<double> ticks(std::size_t about = 6) const;

 private:
  [[nodiscard]] double raw(double value) const;

  double from_, to_;
  bool log_;
  bool empty_ = true;
  double low_ = 0.0, high_ = 1.0;  // raw
};

// As people write them: a true minus sign, powers of ten raised ("10⁻⁶"), no digits beyond the step between
// ticks.
[[nodiscard]] std::vector<std::string> tick_texts(const Scale& scale, const std::vector<double>& ticks);

}  // namespace proofmass
