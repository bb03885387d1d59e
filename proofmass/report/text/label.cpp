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
    Words{"Language", "语言"},
    Words{"Contents", "目录"},
    Words{"Verdict", "结论"},
    Words{"All {count:.0f} terms of the model are identified, and no test of record and fit gave a warning.",
          "模型的 {count:.0f} 项全部可辨识，对数据与拟合的各项检验均未给出警告。"},
    Words{"{count:.0f} of {total:.0f} terms of the model are identified, and no test of record and fit gave "
          "a warning; the other terms are listed with the reason.",
          "模型 {total:.0f} 项中有 {count:.0f} "
          "项可辨识，对数据与拟合的各项检验均未给出警告；其余各项及原因见下文。"},
    Words{"{warnings:.0f} {warnings:?warning is|warnings are} to be settled before the coefficients are "
          "used; {count:.0f} of {total:.0f} terms of the model are identified.",
          "使用系数之前须先处理 {warnings:.0f} 条警告；模型 {total:.0f} 项中有 {count:.0f} 项可辨识。"},
    Words{"No coefficient is identified.", "没有可辨识的系数。"},
    Words{"Warning", "警告"},
    Words{"Note", "说明"},
    Words{"Basis", "依据"},
    Words{"Findings", "检验结果"},
    Words{"No test of the record and the fit found anything.", "对数据与拟合的各项检验均未发现异常。"},
    Words{"Shown in", "见图"},
    Words{"Coefficients", "系数"},
    Words{"Term", "项"},
    Words{"Reads", "读数"},
    Words{"Value", "值"},
    Words{"Standard error", "标准误差"},
    Words{"95 % interval", "95 % 置信区间"},
    Words{"From zero", "相对零点"},
    Words{"Terms that are not identified", "不可辨识的项"},
    Words{"Reason", "原因"},
    Words{"Referred to input (divided by Ki)", "折算到输入（除以 Ki）"},
    Words{"Errors by part", "各部分误差"},
    Words{"Part", "部分"},
    Words{"Rows", "行数"},
    Words{"training", "训练"},
    Words{"validation", "验证"},
    Words{"test", "测试"},
    Words{"leave one out", "留一法"},
    Words{"leave one mount out", "逐安装位置留一法"},
    Words{"MAPE is over the rows whose output is at least 1 % of its range.",
          "MAPE 只统计输出不小于其变化范围 1 % 的行。"},
    Words{"All rows were fitted.", "全部数据行均用于拟合。"},
    Words{"The test rows took no part in fitting, scaling or stopping.",
          "测试行未参与拟合、归一化与停止判断。"},
    Words{"How the computation ended", "计算如何结束"},
    Words{"Residual standard deviation", "残差标准差"},
    Words{"Degrees of freedom", "自由度"},
    Words{"Adjusted R²", "调整后 R²"},
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
    Words{"{what}, {unit}", "{what}，{unit}"},
    Words{"order of rows", "行序"},
    Words{"row", "行号"},
    Words{"time", "时间"},
    Words{"temperature", "温度"},
    Words{"mount", "安装位置"},
    Words{"Distribution of the residuals", "残差分布"},
    Words{"Histogram of the residuals and normal curve", "残差直方图与正态曲线"},
    Words{"rows in each bin", "每组行数"},
    Words{"residuals", "残差"},
    Words{"normal distribution of the same mean and standard deviation", "同均值、同标准差的正态分布"},
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
    Words{"RMSE, {unit}", "均方根误差，{unit}"},
    Words{"best particle", "最优粒子"},
    Words{"mean of the swarm", "粒子群平均"},
    Words{"fitness: RMSE, {unit}", "适应度：均方根误差，{unit}"},
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
          "每点为一行数据。没有点的方向和量级未经试验。"},
    Words{"Influence of single rows", "单行的影响"},
    Words{"Leverage and studentised residual", "杠杆值与学生化残差"},
    Words{"leverage", "杠杆值"},
    Words{"studentised residual", "学生化残差"},
    Words{"Cook's distance of each row", "各行的 Cook 距离"},
    Words{"Cook's distance", "Cook 距离"},
    Words{"Rows of the largest influence", "影响最大的行"},
    Words{"Line", "文件行"},
    Words{"Nonlinearity", "非线性"},
    Words{"Identified nonlinearity along Ai", "沿 Ai 辨识出的非线性"},
    Words{"nonlinearity, {unit}", "非线性，{unit}"},
    Words{"The terms of Ai alone without bias and scale factor: {names}.",
          "仅含 Ai 的各项（不含零偏与标度因数）：{names}。"},
    Words{"95 % confidence", "95 % 置信带"},
    Words{"Record and settings", "数据与设置"},
    Words{"Record", "数据文件"},
    Words{"SHA-256 of the record", "数据文件的 SHA-256"},
    Words{"Rows", "行数"},
    Words{"{total:.0f}: {training:.0f} training, {validation:.0f} validation, {test:.0f} test",
          "{total:.0f}：训练 {training:.0f}，验证 {validation:.0f}，测试 {test:.0f}"},
    Words{"Units", "单位"},
    Words{"acceleration {acceleration}, output {output}", "加速度 {acceleration}，输出 {output}"},
    Words{"Ranges fitted", "拟合范围"},
    Words{"{axis} from {low:.6g} to {high:.6g} g", "{axis}：{low:.6g} 至 {high:.6g} g"},
    Words{"Method", "方法"},
    Words{"Model", "模型"},
    Words{"Seed", "随机种子"},
    Words{"Version", "版本"},
    Words{"Date of this report", "报告日期"},
    Words{"Reading of the record", "数据读取"},
    Words{"Nothing was skipped, converted or assumed.", "没有跳过、换算或假定任何内容。"},
    Words{"Options", "选项"},
    Words{"Figures of rows are absent: {why}", "未绘制逐行图形：{why}"},
    Words{"the record {file} is not where it was.", "原位置没有数据文件 {file}。"},
    Words{"the record {file} has changed since: its SHA-256 differs.",
          "数据文件 {file} 此后有改动：SHA-256 不同。"},
    Words{"the result names no file of its record.", "结果未注明数据文件。"},
    Words{"Figures show {count:.0f} of {total:.0f} rows: evenly spaced ones and besides all extremes, that "
          "is the largest residuals, the most influence and the ends of each axis. Counts and scores are "
          "over all rows.",
          "图中显示 {total:.0f} 行中的 {count:.0f} "
          "行：等间隔抽取，并保留全部极值，即最大残差、最大影响和各轴两端。计数与误差统计针对全部行。"},
    Words{"Made by Proofmass {version}", "由 Proofmass {version} 生成"},
    Words{"Save image", "保存图像"},
    Words{"Methods", "方法"},
    Words{"Truth", "真值"},
    Words{"left out", "未选入"},
    Words{"not identifiable", "不可辨识"},
    Words{"Cost", "代价"},
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
    Words{"Ended", "结束方式"},
};
static_assert(kWords.size() == static_cast<std::size_t>(Label::ended) + 1);

}  // namespace

Words words(Label label) noexcept { return kWords[static_cast<std::size_t>(label)]; }

Text text_of(Label label, const std::vector<Figure>& figures) {
  const Words both = words(label);
  if (figures.empty()) return both;
  const Finding holder{.code = Code::verbatim, .figures = figures};
  return {filled(both.en, holder), filled(both.zh, holder)};
}

std::vector<Label> all_labels() {
  std::vector<Label> all;
  for (std::size_t k = 0; k < kWords.size(); ++k) all.push_back(static_cast<Label>(k));
  return all;
}

}  // namespace proofmass
