// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/label.hpp"

#include <array>
#include <cstddef>

#include "proofmass/report/text/sentence.hpp"

namespace proofmass {
namespace {

// In the order of Label.
constexpr std::array kWords{
    Words{"Identification of the static model", "静态模型辨识"},
    Words{"Comparison of methods", "方法比较"},
    Words{"Reproduction of the paper", "论文复现"},
    Words{"Contents", "目录"},
    Words{"Verdict", "结论"},
    Words{"All {count:.0f} terms of the model are identified, and no test of record and fit gave a warning.",
          "模型的 {count:.0f} 项全部已辨识，对记录与拟合的各项检验均未给出警告。"},
    Words{"{count:.0f} of {total:.0f} terms of the model are identified, and no test of record and fit gave "
          "a warning; the other terms are listed with the reason.",
          "模型 {total:.0f} 项中有 {count:.0f} "
          "项已辨识，对记录与拟合的各项检验均未给出警告；其余各项及原因见下文。"},
    Words{"{warnings:.0f} {warnings:?warning is|warnings are} to be settled before the coefficients are "
          "used; {count:.0f} of {total:.0f} terms of the model are identified.",
          "使用系数之前须先处理 {warnings:.0f} 条警告；模型 {total:.0f} 项中有 {count:.0f} 项已辨识。"},
    Words{"No coefficient is identified.", "没有已辨识的系数。"},
    Words{"Warning", "警告"},
    Words{"Note", "说明"},
    Words{"Basis", "依据"},
    Words{"Findings", "检验结果"},
    Words{"Coefficients", "系数"},
    Words{"Term", "项"},
    Words{"In common units", "常用单位"},
    Words{"Value", "值"},
    Words{"Standard error", "标准误差"},
    Words{"95 % interval", "95 % 置信区间"},
    Words{"Interval and zero", "区间与零点"},
    Words{"Terms that are not identified", "未辨识的项"},
    Words{"Reason", "原因"},
    Words{"Referred to input (divided by Ki)", "折算到输入（除以 Ki）"},
    Words{"Errors by part", "各部分误差"},
    Words{"Part", "部分"},
    Words{"Rows", "行数"},
    Words{"training", "训练集"},
    Words{"validation", "验证集"},
    Words{"test", "测试集"},
    Words{"leave one out", "留一法"},
    Words{"leave one mount out", "留一安装位置法"},
    Words{"MAPE is over the rows whose output is at least 1 % of its range.",
          "MAPE 只统计输出不小于其变化范围 1 % 的行。"},
    Words{"All rows were fitted.", "全部数据行均用于拟合。"},
    Words{"The test rows took no part in fitting, scaling or stopping.",
          "测试行未参与拟合、归一化与停止判断。"},
    Words{"How the computation ended", "计算终止情况"},
    Words{"Residual standard deviation", "残差标准差"},
    Words{"Degrees of freedom", "自由度"},
    Words{"Adjusted R²", "调整 R²"},
    Words{"Condition number", "条件数"},
    Words{"Condition number, scaled columns", "条件数（列归一化）"},
    Words{"Iterations", "迭代次数"},
    Words{"Measurement and prediction", "测量与预测"},
    Words{"Prediction against measurement", "预测值与测量值"},
    Words{"measured output, {unit}", "输出测量值，{unit}"},
    Words{"predicted output, {unit}", "输出预测值，{unit}"},
    Words{"prediction = measurement", "预测值 = 测量值"},
    Words{"Residuals", "残差"},
    Words{"residual, {unit}", "残差，{unit}"},
    Words{"Residuals against {what}", "残差与{what}"},
    Words{"order of rows", "行序"},
    Words{"row", "行序号"},
    Words{"time", "时间"},
    Words{"temperature", "温度"},
    Words{"mount", "安装位置"},
    Words{"Distribution of the residuals", "残差分布"},
    Words{"Histogram of the residuals and normal curve", "残差直方图与正态曲线"},
    Words{"rows in each bin", "每组行数"},
    Words{"residuals", "残差"},
    Words{"normal, of the same mean and sd", "同均值、同标准差的正态分布"},
    Words{"Normal Q–Q plot of the residuals", "残差的正态 Q–Q 图"},
    Words{"normal quantile", "正态分位数"},
    Words{"ordered residual, {unit}", "有序残差，{unit}"},
    Words{"normal distribution", "正态分布"},
    Words{"Training", "训练过程"},
    Words{"Error by epoch", "误差随训练轮次的变化"},
    Words{"Convergence of the swarm", "粒子群的收敛"},
    Words{"BP: error by epoch", "BP：误差随训练轮次的变化"},
    Words{"PSO-BP (paper's preset): error by epoch after the swarm",
          "PSO-BP（论文设置）：粒子群之后误差随训练轮次的变化"},
    Words{"The swarm: fitness by generation", "粒子群：适应度随代数的变化"},
    Words{"generation", "代数"},
    Words{"epoch", "轮次"},
    Words{"iteration", "迭代次数"},
    Words{"RMSE, {unit}", "均方根误差 RMSE，{unit}"},
    Words{"best particle", "最优粒子"},
    Words{"mean of the swarm", "粒子群平均"},
    Words{"fitness: RMSE, {unit}", "适应度：均方根误差 RMSE，{unit}"},
    Words{"chosen: epoch {epoch:.0f}", "所选轮次：{epoch:.0f}"},
    Words{"Test rows", "测试行"},
    Words{"Test rows: measured and predicted output", "测试行：输出的测量值与预测值"},
    Words{"Test rows: prediction errors", "测试行：预测误差"},
    Words{"test row", "测试行序号"},
    Words{"output, {unit}", "输出，{unit}"},
    Words{"measured minus predicted, {unit}", "测量值减预测值，{unit}"},
    Words{"measured", "测量值"},
    Words{"predicted", "预测值"},
    Words{"Correlations of the coefficients", "系数的相关性"},
    Words{"Correlation of each pair of coefficients", "各对系数的相关系数"},
    Words{"Excitation", "激励"},
    Words{"Specific force along the three axes, g", "沿三轴的比力，g"},
    Words{"Each point is a row of the record. Directions and levels without points were not tested.",
          "每点为一行数据。没有点的方向和加速度水平未经试验。"},
    Words{"Influence of single rows", "单行的影响"},
    Words{"Leverage and studentised residual", "杠杆值与学生化残差"},
    Words{"leverage", "杠杆值"},
    Words{"studentised residual", "学生化残差"},
    Words{"Cook's distance of each row", "各行的 Cook 距离"},
    Words{"Cook's distance", "Cook 距离"},
    Words{"Rows of the largest influence", "影响最大的行"},
    Words{"Line", "文件行号"},
    Words{"Nonlinearity", "非线性"},
    Words{"Identified nonlinearity along Ai", "沿 Ai 辨识出的非线性"},
    Words{"nonlinearity, {unit}", "非线性，{unit}"},
    Words{"The terms of Ai alone without bias and scale factor: {names}.",
          "仅含 Ai 的各项（不含零偏与标度因数）：{names}。"},
    Words{"95 % confidence", "95 % 置信带"},
    Words{"Record and settings", "记录与设置"},
    Words{"Record", "记录"},
    Words{"SHA-256 of the record", "记录的 SHA-256"},
    Words{"Rows", "行数"},
    Words{"{total:.0f}: {training:.0f} training, {validation:.0f} validation, {test:.0f} test",
          "{total:.0f}：训练 {training:.0f}，验证 {validation:.0f}，测试 {test:.0f}"},
    Words{"Units", "单位"},
    Words{"acceleration {acceleration}, output {output}", "加速度 {acceleration}，输出 {output}"},
    Words{"output {output}", "输出 {output}"},
    Words{"Ranges fitted", "拟合范围"},
    Words{"{axis} from {low:.6g} to {high:.6g} g", "{axis}：{low:.6g} 至 {high:.6g} g"},
    Words{"Method", "方法"},
    Words{"Model", "模型"},
    Words{"Seed", "随机种子"},
    Words{"Version", "版本"},
    Words{"Date of this report", "报告日期"},
    Words{"Reading of the record", "记录的读取"},
    Words{"Nothing was skipped, converted or assumed.", "没有跳过、换算或假定任何内容。"},
    Words{"Options", "选项"},
    Words{"Figures of rows are absent: {why}", "未绘制逐行图形：{why}"},
    Words{"the record {file} is not where it was.", "原位置没有记录 {file}。"},
    Words{"the record {file} has changed since: its SHA-256 differs.",
          "记录 {file} 此后有改动：SHA-256 不同。"},
    Words{"the result names no file of its record.", "结果未注明其记录。"},
    Words{"Figures show {count:.0f} of {total:.0f} rows: one of each of as many equal stretches, and besides "
          "all extremes, that is the largest residuals, the most influence and the ends of each axis. Counts "
          "and scores are over all rows.",
          "图中显示 {total:.0f} 行中的 {count:.0f} "
          "行：从等长的各段中各抽一行，并保留全部极值，即最大残差、最大影响和各轴两端。计数与误差统计针对全部"
          "行。"},
    Words{"Made by Proofmass {version}", "由 Proofmass {version} 生成"},
    Words{"Truth", "真值"},
    Words{"left out", "未选入"},
    Words{"not identifiable", "不可辨识"},
    Words{"Cost", "计算量"},
    Words{"Time, s", "时间，s"},
    Words{"Test RMSE over the repeats", "各次重复的测试 RMSE"},
    Words{"Time against error", "时间与误差"},
    Words{"time, s", "时间，s"},
    Words{"test RMSE, {unit}", "测试 RMSE，{unit}"},
    Words{"Error of each coefficient, truth known", "各系数的误差（真值已知）"},
    Words{"error in standard errors", "误差（以标准误差为单位）"},
    Words{"Each coefficient beside that of {method}", "各系数与 {method} 的比较"},
    Words{"difference in standard errors of {method}", "差值（以 {method} 的标准误差为单位）"},
    Words{"Distance from the truth", "与真值的距离"},
    Words{"rms error / standard error", "误差均方根 / 标准误差"},
    Words{"rms error / Cramér–Rao bound", "误差均方根 / Cramér–Rao 下界"},
    Words{"Largest error", "最大误差"},
    Words{"Repeats", "重复次数"},
    Words{"Ended", "终止"},
    Words{"{methods:.0f} {methods:?method|methods} on the same rows of {input}; repeats: {repeats:.0f}, each "
          "with a split of its own; training fraction {fraction:.3g}.",
          "对 {input} 的相同数据行比较 {methods:.0f} 种方法；重复 {repeats:.0f} 次，每次另行划分；训练比例 "
          "{fraction:.3g}。"},
    Words{"{methods:.0f} {methods:?method|methods} on the same rows of {input}; training fraction "
          "{fraction:.3g}.",
          "对 {input} 的相同数据行比较 {methods:.0f} 种方法；训练比例 {fraction:.3g}。"},
    Words{" ({count:.0f} of {total:.0f} repeats)", "（{total:.0f} 次重复中有 {count:.0f} 次）"},
    Words{"Coefficients ± one standard error, seed {seed:.0f}", "系数 ± 一倍标准误差，随机种子 {seed:.0f}"},
    Words{"Each point is the error of a coefficient over the method's own standard error; bars are the 95 % "
          "interval. An honest interval holds zero in 19 of 20 cases.",
          "每点为系数误差与该方法自身标准误差之比；误差棒为 95 % 区间。可信的区间应有 19/20 包含零点。"},
    Words{"Each point is the difference of a coefficient from that of {method}, over the standard error of "
          "{method}.",
          "每点为系数与 {method} 结果之差，除以 {method} 的标准误差。"},
    Words{"ratio of iterations", "迭代次数之比"},
    Words{"ratio of time", "时间之比"},
    Words{"ratio of test MSE", "测试 MSE 之比"},
    Words{"Ratios are to {method}.", "比值均相对于 {method}。"},
    Words{"Figures 4 to 8", "图 4 至图 8"},
    Words{"The paper's own record is not public. This is a simulated twin ({twin}): its coefficients as "
          "truth, {rows:.0f} rows, white noise of {noise:.4g} µg, seed {seed:.0f}, 70 % of the rows to train "
          "on. Figures of the two experiments need not agree, for the records differ; their order and the "
          "costs should.",
          "论文的记录未公开。此处使用仿真记录（{twin}）：以论文系数为真值，{rows:.0f} 行，白噪声 {noise:.4g} "
          "µg，随机种子 {seed:.0f}，70 % 的行用于训练。记录不同，两者的数值不必一致；次序与计算量应当一致。"},
    Words{"The paper: {citation}.", "论文：{citation}。"},
    Words{"Table 1: size of the hidden layer", "表 1：隐层单元数"},
    Words{"Training MSE of textbook BP in ({unit})²; repeats with other splits and starts: {repeats:.0f}. "
          "The paper chose 7 of 3…12 by this figure alone.",
          "标准 BP 的训练 MSE，单位 ({unit})²；另行划分与初始化的重复次数：{repeats:.0f}。论文仅凭此值从 "
          "3…12 中选择 7。"},
    Words{"hidden units", "隐层单元数"},
    Words{"mean", "平均"},
    Words{"least", "最小"},
    Words{"largest", "最大"},
    Words{"Table 2: coefficients", "表 2：系数"},
    Words{"In the units of the second column, ± one standard error. \"Left out\" is a method's choice and "
          "counts as zero; \"–\" was not asked for. The truth of the twin is what the paper's PSO-BP "
          "identified; the paper gives 8 coefficients by LSM, 10 by GMDH and 15 by PSO-BP.",
          "单位见第二列，± "
          "一倍标准误差。“未选入”为方法自身的选择，按零计；“–”表示未要求该项。仿真的真值取论文 PSO-BP "
          "的辨识结果；论文中 LSM 给出 8 个系数，GMDH 10 个，PSO-BP 15 个。"},
    Words{"the paper's PSO-BP: our truth", "论文 PSO-BP：此处的真值"},
    Words{"test MSE", "测试 MSE"},
    Words{"training MSE", "训练 MSE"},
    Words{"Table 3: errors", "表 3：误差"},
    Words{"On the test rows, in {unit} and ({unit})², mean over {repeats:.0f} {repeats:?repeat|repeats} with "
          "other "
          "splits and starts. \"Ours\" is the default preset; multistart spends the swarm's epochs on random "
          "starts "
          "instead, an ablation that the paper lacks. The noise alone makes an MSE of about {noise}.",
          "测试行上的误差，单位 {unit} 与 ({unit})²，为 {repeats:.0f} "
          "次另行划分与初始化的平均。“默认设置”即本软件的默认设置；多次初始化 BP "
          "将粒子群的训练轮次用于随机初始化，是论文所缺的对照。仅噪声所致的 MSE 约为 {noise}。"},
    Words{"the paper's MSE", "论文的 MSE"},
    Words{"Iterations", "迭代次数"},
    Words{"the paper", "论文"},
    Words{"here", "此处"},
    Words{"BP: the sizes of Table 1, then the final training", "BP：表 1 各单元数的训练及最终训练"},
    Words{"PSO-BP: the swarm's training, then the final one", "PSO-BP：粒子群的训练及最终训练"},
    Words{"ratio", "比值"},
    Words{"The paper's 11,000 are 10 sizes × 1000 + 1000; training that converges or stops early spends "
          "less. The swarm scores its particles once before its first generation, and its final training is "
          "counted here.",
          "论文的 11 000 为 10 种单元数 × 1000 + "
          "1000；收敛或提前停止的训练用得更少。粒子群在第一代之前先评价一次全部粒子，其最终训练也计入此处。"},
    Words{"What the swarm gains over one BP run", "粒子群相对单次 BP 的收益"},
    Words{"Test MSE of one textbook BP run over that of PSO-BP, geometric mean over {records:.0f} records. "
          "The paper's is 293. With the paper's noise BP already ends near the noise, and no method can be "
          "much better; at 1 µg the training decides.",
          "单次标准 BP 的测试 MSE 与 PSO-BP 之比，{records:.0f} 份记录的几何平均。论文为 293。在论文的噪声下 "
          "BP 已接近噪声，任何方法都难以更好；噪声为 1 µg 时由训练决定。"},
    Words{"noise, µg", "噪声，µg"},
    Words{"iterations of BP", "BP 的迭代次数"},
    Words{"iterations of PSO-BP", "PSO-BP 的迭代次数"},
    Words{"Unit", "单位"},
    Words{"step", "步"},
    Words{"best fish", "最优个体"},
    Words{"mean of the fish", "鱼群平均"},
    Words{"Bayesian information criterion by hidden units", "各隐层单元数的贝叶斯信息准则"},
    Words{"weighted sum of squares", "加权平方和"},
    Words{"external criterion by number of terms", "各项数的外部准则"},
    Words{"external criterion by layer", "各层的外部准则"},
    Words{"Hidden units tried: RMSE on rows set aside, {unit}", "试用的隐层单元数：留出行的 RMSE，{unit}"},
    Words{"spread", "离散"},
    Words{"chosen", "选定"},
    Words{"Saturated fraction", "饱和比例"},
    Words{"Deviation induced by the network", "网络引起的偏差"},
    Words{"Training epochs", "训练轮次"},
    Words{"Swarm evaluations", "群体计算次数"},
    Words{"Robust scale", "稳健尺度"},
    Words{"Models tried", "试算模型数"},
    Words{"Accelerations are converted from {unit} to g.", "加速度已由 {unit} 换算为 g。"},
    Words{"Figure {number:.0f}: ", "图 {number:.0f}："},
    Words{"Option", "选项"},
};
static_assert(kWords.size() == static_cast<std::size_t>(Label::option) + 1);

}  // namespace

Words words(Label label) noexcept { return kWords[static_cast<std::size_t>(label)]; }

Text text_of(Label label, const std::vector<Figure>& figures) {
  const Words both = words(label);
  if (figures.empty()) return both;
  const Finding holder{.code = Code::verbatim, .figures = figures};
  return {filled(both.en, holder), filled(both.zh, holder)};
}

Text text_of(Label label, const std::string& figure, const Text& words) {
  return {text_of(label, {{figure, words.en}}).en, text_of(label, {{figure, words.zh}}).zh};
}

std::vector<Label> all_labels() {
  std::vector<Label> all;
  for (std::size_t k = 0; k < kWords.size(); ++k) all.push_back(static_cast<Label>(k));
  return all;
}

}  // namespace proofmass
