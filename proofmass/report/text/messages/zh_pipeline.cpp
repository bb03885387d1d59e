// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "proofmass/report/text/messages/zh_internal.hpp"

namespace proofmass {
namespace {

constexpr std::array kPipelineMessages{
    ChineseMessage{"no data rows", "没有数据行"},
    ChineseMessage{"at least one", "至少一行"},
    ChineseMessage{"{} has no network of a size to choose", "{} 没有可以选择大小的网络"},
    ChineseMessage{"a search needs at least 2 repeats of each size, got {}",
                   "搜索时每种大小至少重复 2 次，给出的是 {} 次"},
    ChineseMessage{"{}: {}, {} of them used for fitting (split {}), {} needed for {}",
                   "{0}：{1}，其中 {2} 行用于拟合（split {3}），而 {5}需要 {4} 行"},
    ChineseMessage{"the label of a mount in each row, to keep the rows of a mount together",
                   "每行都有安装位置的标签，使同一安装位置的行不被拆开"},
    ChineseMessage{"a column with the label of the mount in each row, to keep the rows of a mount together",
                   "给出每行安装位置标签的列，使同一安装位置的行不被拆开"},
    ChineseMessage{"the label of a mount in each row, for a covariance by mounts",
                   "每行都有安装位置的标签，才能按安装位置求协方差"},
    ChineseMessage{"a column with the label of the mount in each row, for a covariance by mounts",
                   "给出每行安装位置标签的列，才能按安装位置求协方差"},
    ChineseMessage{"covariance: found '{}', but {} has the covariance model alone; {} have it",
                   "covariance：给出的是 '{}'，而 {} 只有 model 协方差；{} 具有该协方差"},
    ChineseMessage{
        "{}: the loss is flat at so many rows of high leverage that the covariance {} cannot be had; "
        "Huber's loss, or the covariance of the model, may do",
        "{}：损失函数在过多的高杠杆行处平坦，不能求得 {} 协方差；可改用 Huber 损失或模型协方差"},
    ChineseMessage{"line {}", "第 {} 行"},
    ChineseMessage{"the mount '{}'", "安装位置 '{}'"},
    ChineseMessage{
        "{}: without {} the other rows cannot identify these terms, so that no covariance can be had by "
        "leaving it out",
        "{}：剔除{}后，其余的行不能辨识这些模型项，因此不能由剔除求得协方差"},
    ChineseMessage{
        "{}: {}, which contradicts the result; the result file was changed, or made by another version",
        "{}：{}，与结果矛盾；结果文件被改动过，或由另一版本生成"},
    ChineseMessage{"its training error is {:.6g}, and that of its coefficients is {:.6g}",
                   "结果所记的训练误差为 {:.6g}，而由其系数算得 {:.6g}"},
    ChineseMessage{"option {} is '{}'", "选项 {} 为 '{}'"},
    ChineseMessage{"no mounts, and option split-by is mount", "没有安装位置，而选项 split-by 为 mount"},
    ChineseMessage{"{} training, {} validation and {} test rows by the options",
                   "按选项应有训练行 {}、验证行 {}、测试行 {}"},
    ChineseMessage{"split must be more than 0 and at most 1, got {}",
                   "split 应大于 0 且不大于 1，给出的是 {}"},
    ChineseMessage{
        "the validation fraction must be at least 0 and less than the training fraction {}, got {}",
        "验证比例应不小于 0 且小于训练比例 {}，给出的是 {}"},
    ChineseMessage{"a split of {} with a validation fraction of {} leaves no training rows of {}",
                   "split 为 {}、验证比例为 {} 时，{} 行中没有剩下训练行"},
    ChineseMessage{"a validation fraction of {} leaves no validation row of {}",
                   "验证比例为 {} 时，{} 行中没有验证行"},
    ChineseMessage{
        "a split of {} leaves none of {} rows to test on: it must be 1, to fit all rows, or at most {}",
        "split 为 {} 时，{} 行中没有剩下测试行：应为 1（拟合全部行），或不大于 {}"},
    ChineseMessage{"whole mounts cannot be set aside: the record has {} and {} parts need one each",
                   "不能按整个安装位置划分：记录有 {} 个安装位置，而 {} 个部分各需一个"},
    ChineseMessage{"a validation fraction of {} sets none of {} rows aside to choose by",
                   "验证比例为 {} 时，{} 行中没有留出用于选择的行"},
    ChineseMessage{"the truth's output is in {}, the record's in {}: they must agree",
                   "真值的输出单位为 {}，记录的输出单位为 {}：两者应相同"},
};

}  // namespace

std::span<const ChineseMessage> chinese_pipeline_messages() noexcept { return kPipelineMessages; }

}  // namespace proofmass
