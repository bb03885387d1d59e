// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "proofmass/core/identification.hpp"
#include "proofmass/report/text/language.hpp"

namespace proofmass {

// Over how many rows MAPE is, where it leaves some out.
class MapeRows {
 public:
  // The scores of a part of the record ("test"). Those of several methods or repeats become one range.
  void add(const Text& part, const std::optional<Metrics>& metrics);
  // "MAPE leaves out outputs below 1 % of their range: it is over 68 of 70 training rows"; empty where it
  // leaves out none.
  [[nodiscard]] std::string text(Language language = Language::en) const;

 private:
  struct Counts {
    std::size_t least = 0;
    std::size_t most = 0;
    void add(std::size_t count);
  };
  struct Part {
    Text name;
    Counts used, rows;
    bool leaves_out = false;
  };
  std::vector<Part> parts_;
};

}  // namespace proofmass
