// SPDX-License-Identifier: Apache-2.0
// What the page of the paper's experiment says, in every language; figures go into the places in braces.
#pragma once

#include "proofmass/report/text/language.hpp"

namespace proofmass::reproduction_words {

inline constexpr Words kVariance{"{}{} by {}", "{0}{2} 为 {1}"};
inline constexpr Words kComma{", ", "、"};
inline constexpr Words kInconsistencies{
    R"(## What does not fit in the paper

- **Table 1**: the exponent printed for 7 nodes, the size that the paper chose, does not agree with the sizes beside it. Table 1 above shows how far sizes and random starts make the training MSE differ; nothing sets 7 apart from 6 or 8 by a power of ten.
- **Table 3**: with one test set, 1 − R² = MSE / variance, so MSE / (1 − R²) must be the same for every method. The R² printed beside 2.6884e-3 for BP and 9.178e-6 for PSO-BP imply different variances: the two were not scored on the same rows, or a figure is misprinted. Here every method is scored on the same test rows, and the variance comes out as {} ({})².
- **BP's MSE**: 2.6884e-3 is 293 times 9.178e-6. Were the latter the noise of the record, BP had ended 17 times above it in RMSE; here one textbook run ends near the noise (Table 3).
- **The second Kop**: the model lists Kop twice, once for Ao·Ap and once for the odd quadratic term |Ai|·Ai. The standard's name of the latter is Koq, which is used here.
- How coefficients come out of the network is left open. Here the network is projected onto the model's terms by least squares.
- Fitness is said to be the RMSE of a particle; 50,000 iterations are 50 particles × 50 generations × 20 epochs, so each particle was trained before it was scored. The paper's preset does that.
)",
    R"(## 论文中的矛盾之处

- **表 1**：论文选定的 7 个单元，其数值所印的指数与相邻各单元数不相称。上面的表 1 表明单元数和随机起点使训练 MSE 相差多少；没有什么使 7 与 6 或 8 相差一个数量级。
- **表 3**：测试集相同时，1 − R² = MSE / 方差，故 MSE / (1 − R²) 对各方法应相同。BP 的 2.6884e-3 与 PSO-BP 的 9.178e-6 旁所印的 R² 对应不同的方差：两者不是在相同的行上评分，或有一个数值印错。此处各方法在相同的测试行上评分，所得方差（单位 ({1})²）：{0}。
- **BP 的 MSE**：2.6884e-3 是 9.178e-6 的 293 倍。若后者是记录的噪声，则 BP 终止时的 RMSE 为其 17 倍；此处单次标准 BP 终止在噪声附近（表 3）。
- **第二个 Kop**：模型中 Kop 列出两次，一次为 Ao·Ap，一次为奇二次项 |Ai|·Ai。标准中后者称为 Koq，此处采用该名。
- 论文没有说明如何由网络得到系数。此处将网络按最小二乘投影到模型各项上。
- 论文称适应度为粒子的 RMSE；50 000 次迭代为 50 个粒子 × 50 代 × 20 个轮次，可见每个粒子都是训练后再评分的。论文设置即如此。
)"};
inline constexpr Words kTable1{
    "## Table 1: size of the hidden layer\n\nTraining MSE of textbook BP in ({})²; repeats with other splits "
    "and starts: {}. The paper chose 7 of 3…12 by this figure alone.\n\n| hidden | mean | least | largest "
    "|\n|---|---|---|---|\n",
    "## 表 1：隐层单元数\n\n标准 BP 的训练 MSE，单位 ({})²；另行划分与初始化的重复次数：{}。论文仅凭此值从 "
    "3…12 中选择 7。\n\n| 隐层单元数 | 平均 | 最小 | 最大 |\n|---|---|---|---|\n"};
inline constexpr Words kLeftOut{"left out", "未选入"};
inline constexpr Words kUnidentifiable{"unidentifiable", "不可辨识"};
inline constexpr Words kTable2{
    "## Table 2: coefficients\n\nIn g per g^order, ± one standard error; \"left out\" is a method's choice "
    "and counts as zero, \"-\" was not asked for. The truth of the twin is what the paper's PSO-BP "
    "identified; the paper gives 8 coefficients by LSM, 10 by GMDH and 15 by PSO-BP.\n\n| term | the paper's "
    "PSO-BP: our truth |",
    "## 表 2：系数\n\n单位为 g 除以 g 的相应阶次幂，± "
    "一倍标准误差；“未选入”为方法自身的选择，按零计，“-”表示未要求该项。仿真的真值取论文 PSO-BP "
    "的辨识结果；论文中 LSM 给出 8 个系数，GMDH 10 个，PSO-BP 15 个。\n\n| 项 | 论文 PSO-BP：此处的真值 |"};
inline constexpr Words kOverStandardError{"rms error / standard error", "误差均方根 / 标准误差"};
inline constexpr Words kOverBound{"rms error / Cramér–Rao bound", "误差均方根 / Cramér–Rao 下界"};
inline constexpr Words kTestMse{"test MSE", "测试 MSE"};
inline constexpr Words kTable2End{
    "\nThe figures of error are over the terms that a method was asked for; a short model may look exact in "
    "its own terms and miss the rest. Least squares with the right terms already reaches the bound under "
    "this white noise: no network can do better here.\n\n",
    "\n误差的数值只统计各方法所要求的项；项少的模型可能在自己的项上看似准确，而缺少其余各项。在这样的白噪声下"
    "，项正确的最小二乘已达到下界：任何网络都不能更好。\n\n"};
inline constexpr Words kTable3{
    "## Table 3: errors\n\nOn the test rows, in {0} and ({0})², mean over repeats with other splits and "
    "starts, of which there are {1}. \"Ours\" is the default preset; multistart spends the swarm's epochs on "
    "random starts instead, an ablation that the paper lacks. The noise alone makes an MSE of about "
    "{2}.\n\n| method | the paper's MSE | MSE | MAE | RMSE | MAPE % | R² | training MSE | iterations | time, "
    "s |\n|---|---|---|---|---|---|---|---|---|---|\n",
    "## 表 3：误差\n\n测试行上的误差，单位 {0} 与 ({0})²，为 {1} "
    "次另行划分与初始化的平均。“默认设置”即本软件的默认设置；多次初始化 BP "
    "将粒子群的训练轮次用于随机初始化，是论文所缺的对照。仅噪声所致的 MSE 约为 {2}。\n\n| 方法 | 论文的 MSE "
    "| MSE | MAE | RMSE | MAPE % | R² | 训练 MSE | 迭代次数 | 时间，s "
    "|\n|---|---|---|---|---|---|---|---|---|---|\n"};
inline constexpr Words kTestPart{"test", "测试集"};
inline constexpr Words kSentence{"\n{}.\n", "\n{}。\n"};
inline constexpr Words kCosts{
    "## Iterations\n\n| | the paper | here |\n|---|---|---|\n| BP: the sizes of Table 1, then the final "
    "training | 11,000 | {:.0f} |\n| PSO-BP: the swarm's training, then the final one | 50,000 | {:.0f} |\n| "
    "ratio | 4.5 | {} |\n\nThe paper's 11,000 are 10 sizes × 1000 + 1000; training that converges or stops "
    "early spends less. The swarm scores its particles once before its first generation, and its final "
    "training is counted here.\n\n",
    "## 迭代次数\n\n| | 论文 | 此处 |\n|---|---|---|\n| BP：表 1 各单元数的训练及最终训练 | 11 000 | {:.0f} "
    "|\n| PSO-BP：粒子群的训练及最终训练 | 50 000 | {:.0f} |\n| 比值 | 4.5 | {} |\n\n论文的 11 000 为 10 "
    "种单元数 × 1000 + "
    "1000；收敛或提前停止的训练用得更少。粒子群在第一代之前先评价一次全部粒子，其最终训练也计入此处。\n\n"};
inline constexpr Words kGains{
    "## What the swarm gains over one BP run\n\nTest MSE of one textbook BP run over that of PSO-BP, "
    "geometric mean over {} records. The paper's is 293. With the paper's noise BP already ends near the "
    "noise, and no method can be much better; at 1 µg the training decides. Iterations are epochs of "
    "training, all particles together; where the swarm scores particles without training them, as ours does, "
    "each scoring counts as one iteration too, though it is less work than an epoch.\n\n| noise, µg | PSO-BP "
    "| MSE ratio | iterations of BP | of PSO-BP | over the {:.0f} of BP's search "
    "|\n|---|---|---|---|---|---|\n",
    "## 粒子群相对单次 BP 的收益\n\n单次标准 BP 的测试 MSE 与 PSO-BP 之比，{} 份记录的几何平均。论文为 "
    "293。在论文的噪声下 BP 已接近噪声，任何方法都难以更好；噪声为 1 µg "
    "时由训练决定。迭代次数为训练轮次，各粒子合计；粒子群不训练粒子而直接评分时（如此处的默认设置），每次评分"
    "也计为一次迭代，尽管其计算量小于一个轮次。\n\n| 噪声，µg | PSO-BP | MSE 之比 | BP 的迭代次数 | PSO-BP "
    "的迭代次数 | 与 BP 搜索的 {:.0f} 次之比 |\n|---|---|---|---|---|---|\n"};
inline constexpr Words kGainsEnd{
    "\nThe paper's BP MSE (2.6884e-3) is far above the noise that its PSO-BP shows (9.178e-6, or 309 "
    "µg).\n\n",
    "\n论文中 BP 的 MSE（2.6884e-3）远大于其 PSO-BP 所示的噪声（9.178e-6，即 309 µg）。\n\n"};
inline constexpr Words kPictures{"## Figures\n\n", "## 图\n\n"};
inline constexpr Words kPicture{"![Figure {0}: {1}]({2}.svg)\n\nFigure {0}: {1} ([data]({2}.csv)).\n\n",
                                "![图 {0}：{1}]({2}.svg)\n\n图 {0}：{1}（[数据]({2}.csv)）。\n\n"};
inline constexpr Words kIntro{
    "# The paper's experiment, repeated\n\nThe paper: {}.\n\nThe paper's own record is not public. This is a "
    "simulated twin ({}): its coefficients as truth, {} rows, white noise of {:.4g} µg, seed {}, 70 % of the "
    "rows to train on. Figures of the two experiments need not agree, for the records differ; their order "
    "and the costs should.\n\n",
    "# 论文实验的复现\n\n论文：{}。\n\n论文的记录未公开。此处使用仿真记录（{}）：以论文系数为真值，{} "
    "行，白噪声 {:.4g} µg，随机种子 {}，70 % "
    "的行用于训练。记录不同，两者的数值不必一致；次序与计算量应当一致。\n\n"};

}  // namespace proofmass::reproduction_words
