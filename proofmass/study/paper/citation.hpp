// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace proofmass {

// What "the paper" and "Shi et al." mean everywhere.
inline constexpr std::string_view kPaperCitation =
    "史有志, 冯仁剑, 李晓婷 (Shi Youzhi, Feng Renjian, Li Xiaoting), "
    "《基于PSO-BP的石英挠性加速度计静态模型辨识》, 计测技术 (Metrology & Measurement Technology) 45(3), 2025";

// Of BP and PSO-BP: its Table 3, test MSE in (m/s²)², and the iterations of its text.
inline constexpr std::array kPaperTestMse{2.6884e-3, 9.178e-6};
inline constexpr std::array kPaperIterations{11'000.0, 50'000.0};

}  // namespace proofmass
