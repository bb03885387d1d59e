// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace proofmass {

// What "the paper" and "Shi et al." mean everywhere.
inline constexpr std::string_view kPaperCitation =
    "史有志, 冯仁剑, 李晓婷 (Shi Youzhi, Feng Renjian, Li Xiaoting), "
    "《基于PSO-BP的石英挠性加速度计静态模型辨识》, 计测技术 (Metrology & Measurement Technology) 45(3), 2025";

}  // namespace proofmass
