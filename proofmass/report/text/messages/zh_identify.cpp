// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "proofmass/report/text/messages/zh_internal.hpp"

namespace proofmass {
namespace {

constexpr std::array kIdentifyMessages{
    ChineseMessage{"unknown method '{}'; expected one of {}{}", "未知的方法 '{}'；应为下列之一：{}{}"},
    ChineseMessage{"the result of {} comes without its network, which alone predicts",
                   "{} 的结果不含网络，而只有网络才能预测"},
    ChineseMessage{"a column with the specific force that the term {} needs", "项 {} 所需的比力列"},
    ChineseMessage{"{}: the inputs cannot identify {} of the {} asked for: {}. Fit without them, ask for "
                   "fewer terms, or test in more mounts",
                   "{0}：在所要求的 {2}中，输入不能辨识 {1} "
                   "项：{3}。请不拟合这些项、减少所要求的项，或在更多安装位置上试验"},
    ChineseMessage{"{} to fit", "{}可供拟合"},
    ChineseMessage{"at least {}, one more than the {} asked for ({})",
                   "至少 {} 行，比所要求的 {}多一行（{}）"},
    ChineseMessage{"a value of at most {:.0g} in size", "绝对值不大于 {} 的数值"},
    ChineseMessage{"values up to {:.3g}", "最大为 {} 的数值"},
    ChineseMessage{"values whose largest is between {:.0g} and {:.0g}", "最大值在 {} 与 {} 之间的数值"},
    ChineseMessage{"an output that varies with the input", "随输入变化的输出"},
    ChineseMessage{"{} in every row", "每行都是 {}"},
    ChineseMessage{"no terms to identify; ask for at least one", "没有要辨识的项；请至少要求一项"},
    ChineseMessage{
        "the record's values are so large or so small that the coefficients or their variances overflow",
        "记录的数值过大或过小，系数或其方差溢出"},
    ChineseMessage{"hybrid needs K0 among the terms: its network has a constant of its own",
                   "hybrid 的项中必须有 K0：其网络自有常数项"},
    ChineseMessage{"an initial particle has {} weights, expected {}", "初始粒子有 {} 个权值，应为 {} 个"},
    ChineseMessage{"{} initial positions for a swarm of {} particles",
                   "给出了 {} 个初始位置，而粒子群只有 {} 个粒子"},
    ChineseMessage{"{} found no network with a finite error", "{} 没有得到误差有限的网络"},
    ChineseMessage{"{} could not be trained: training ended in the first epoch, and the network as it "
                   "started explains nothing of the output (R² {:.3g} on the training rows)",
                   "{} 不能训练：训练在第一个轮次终止，而初始网络完全不能解释输出（训练行的 R² 为 {}）"},
    ChineseMessage{"hidden: a search has no end here; expected a number of hidden units",
                   "hidden：此处不能搜索；应给出隐层单元数"},
    ChineseMessage{"training row", "个训练行"},
    ChineseMessage{"training rows", "个训练行"},
    ChineseMessage{"at least {}: a {}-{}-1 network has {}", "至少 {} 个：{}-{}-1 网络有 {}"},
    ChineseMessage{"weight", "个权值"},
    ChineseMessage{"weights", "个权值"},
    ChineseMessage{"a column with the specific force along an axis that the network takes as input",
                   "网络输入轴的比力列"},
    ChineseMessage{"more than {}", "大于 {}"},
    ChineseMessage{"at least {}", "不小于 {}"},
    ChineseMessage{"{} and less than {}", "{}且小于 {}"},
    ChineseMessage{"{} and at most {}", "{}且不大于 {}"},
    ChineseMessage{"from {} to {}", "{} 至 {}"},
    ChineseMessage{"a whole number of {}", "{}的整数"},
    ChineseMessage{"a whole number {}", "{}的整数"},
    ChineseMessage{"a number of {}", "{}的数值"},
    ChineseMessage{"a number {}", "{}的数值"},
    ChineseMessage{"{}, or {}", "{}，或 {}"},
    ChineseMessage{"one of {}", "下列之一：{}"},
    ChineseMessage{"interrupted during orthogonal distance regression", "在正交距离回归中被中断"},
    ChineseMessage{"eiv did not converge: the uncertainties given may be too large for these data, or the "
                   "iterations too few",
                   "eiv 没有收敛：所给的不确定度对这些数据可能过大，或迭代次数太少"},
    ChineseMessage{"interrupted before the iteration", "在迭代之前被中断"},
    ChineseMessage{"interrupted before the least-squares solution", "在求最小二乘解之前被中断"},
    ChineseMessage{"interrupted during the robust fit", "在稳健拟合中被中断"},
    ChineseMessage{"{}: so many rows lost their weight that the rest hardly determine the terms; a loss that "
                   "keeps weight, or fewer terms, may do",
                   "{}：失去权的行太多，其余各行难以确定各项；可改用保留权的损失函数，或减少项"},
    ChineseMessage{"{}: too many rows lie where the loss is flat (mean slope of psi {:.2g}) for a usable "
                   "fit; a larger constant of the loss, or Huber's loss, may do",
                   "{}：太多的行处在损失函数平坦之处（psi 的平均斜率为 "
                   "{}），不能得到可用的拟合；可增大损失函数的常数，或改用 Huber 损失函数"},
    ChineseMessage{"tls has no generic solution: by the uncertainties given, some combination of the "
                   "regressors is no larger than its own error; give smaller ones or fewer terms, or use eiv",
                   "tls "
                   "没有通常意义的解：按所给的不确定度，回归量的某个组合不大于其自身的误差；请给出较小的不确"
                   "定度、减少项，或改用 eiv"},
    ChineseMessage{"interrupted before total least squares", "在总体最小二乘之前被中断"},
    ChineseMessage{"{} cannot convert the uncertainty of the output, which is referred to the input, to {} "
                   "without the term Ki: give a column sigma_E",
                   "{} 在没有项 Ki 时不能把折算到输入的输出不确定度换算为 {}：请给出列 sigma_E"},
    ChineseMessage{"the uncertainty of the output", "输出的不确定度"},
    ChineseMessage{"the uncertainty of the inputs", "输入的不确定度"},
    ChineseMessage{"{} is {:.3g} g, expected {:.0g} to {:.0g} g", "{}为 {} g，应为 {} 至 {} g"},
    ChineseMessage{"a standard uncertainty of 1e-30 to 1e30, or zero", "1e-30 至 1e30 的标准不确定度，或零"},
    ChineseMessage{"a standard uncertainty above zero, of 1e-30 to 1e30",
                   "大于零的标准不确定度，1e-30 至 1e30"},
    ChineseMessage{
        "the uncertainty of the output: a column sigma_E in the record, or a constant referred to the input",
        "输出的不确定度：记录中的列 sigma_E，或折算到输入的常数"},
    ChineseMessage{
        "the uncertainty of at least one input that the model uses, above zero: columns sigma_Ai, sigma_Ao, "
        "sigma_Ap in the record, or a constant for all axes; where inputs are exact, use ols",
        "模型所用输入中至少一个的不确定度，且大于零：记录中的列 "
        "sigma_Ai、sigma_Ao、sigma_Ap，或各轴共用的常数；输入准确时请用 ols"},
    ChineseMessage{"{}; and {}", "{}；以及{}"},
    ChineseMessage{"{} needs {}", "{} 需要{}"},
    ChineseMessage{"{} takes the uncertainty of the output in g, and the output does not change with the "
                   "input: its scale factor is zero",
                   "{} 采用以 g 为单位的输出不确定度，而输出不随输入变化：其标度因数为零"},
    ChineseMessage{
        "{}: the {} of {} rows that have weight cannot identify {}. Fit without them, ask for fewer terms, "
        "or look at the rows that have no weight",
        "{0}：{2} 行中有权的 {1} 行不能辨识 {3}。请不拟合这些项、减少所要求的项，或检查没有权的行"},
    ChineseMessage{"{}: {} of {} rows {} weight beside the others, too few for {}; at least one more than "
                   "the terms is needed: ask for fewer terms, or look at the rows that have no weight",
                   "{0}：{2} 行中只有 {1} 行{3}权，不足以确定 "
                   "{4}；行数至少须比项数多一：请减少所要求的项，或检查没有权的行"},
    ChineseMessage{"has", "有"},
    ChineseMessage{"have", "有"},
    ChineseMessage{
        "a column with the standard uncertainty of E in each row; or let the residuals decide the weights",
        "给出每行 E 的标准不确定度的列；或由残差决定权"},
    ChineseMessage{"interrupted before the weighted least-squares solution", "在求加权最小二乘解之前被中断"},
    ChineseMessage{"interrupted in the search for terms", "在选择项的过程中被中断"},
    ChineseMessage{
        "{}: leaving one row out cannot judge terms that one row alone identifies (its leverage is 1); "
        "measure such positions again, ask for fewer terms, or use ols, which does not choose terms",
        "{}：有的项仅由一行辨识（其杠杆值为 "
        "1），留一法不能评判；请重测这些位置、减少所要求的项，或改用不选择项的 ols"},
    ChineseMessage{"; criterion press needs no such division", "；press 准则不需要这样划分"},
    ChineseMessage{"at least {} in each part that the criterion divides the training rows into{}",
                   "准则所划分的训练行的每一部分至少 {} 行{}"},
    ChineseMessage{"a part of {}, which the criterion sets apart, cannot identify {}{}",
                   "准则所划分的一部分（{}）不能辨识 {}{}"},
    ChineseMessage{"the neurons of gmdh form mia take two inputs, and the terms use one; ask for terms of "
                   "another axis, or for form combi",
                   "gmdh 的 mia 形式的神经元有两个输入，而各项只用一个；请要求另一轴的项，或采用 combi 形式"},
    ChineseMessage{"interrupted while growing layers", "在逐层生长时被中断"},
    ChineseMessage{"no quadratic neuron can be fitted: the rows cannot tell apart 1, u, v, u*v, u^2 and v^2 "
                   "of any two inputs, or one row alone identifies one of these, so that leaving it out "
                   "cannot judge it; form combi may do",
                   "不能拟合任何二次神经元：数据行不能区分任意两个输入的 1、u、v、u*v、u^2 和 "
                   "v^2，或其中之一仅由一行辨识，因而不能以留一法评判；可改用 combi 形式"},
};

}  // namespace

std::span<const ChineseMessage> chinese_identify_messages() noexcept { return kIdentifyMessages; }

}  // namespace proofmass
