// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/base64.hpp"

#include <cstdint>

namespace proofmass {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t kGroup = 3;
  constexpr std::uint32_t kSixBits = 63;
  std::string out;
  out.reserve((bytes.size() + 2) / kGroup * 4);
  for (std::size_t k = 0; k < bytes.size(); k += kGroup) {
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < kGroup; ++b)
      group = (group << 8U) | (k + b < bytes.size() ? static_cast<unsigned char>(bytes[k + b]) : 0U);
    for (std::size_t letter = 0; letter < 4; ++letter) {
      const bool filled = k + letter <= bytes.size();
      out += filled ? kLetters[(group >> (18U - 6U * static_cast<unsigned>(letter))) & kSixBits] : '=';
    }
  }
  return out;
}

}  // namespace proofmass
