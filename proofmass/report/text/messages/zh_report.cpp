// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "proofmass/report/text/messages/zh_internal.hpp"

namespace proofmass {
namespace {

constexpr std::array kReportMessages{
    ChineseMessage{"model, hc3 or mount", "model、hc3 或 mount"},
    ChineseMessage{"a number of at least 0", "不小于 0 的数"},
    ChineseMessage{"an interval around the coefficient's value", "包含系数值的区间"},
    ChineseMessage{"a known ending", "已知的终止状态"},
    ChineseMessage{"basis, note or warning", "basis、note 或 warning"},
    ChineseMessage{"the name of a term", "项的名称"},
    ChineseMessage{"a known unit", "已知的单位"},
    ChineseMessage{"each term once", "每项只出现一次"},
    ChineseMessage{"{}, one an identified coefficient", "{}，每个已辨识的系数一行"},
    ChineseMessage{"number", "个数值"},
    ChineseMessage{"numbers", "个数值"},
    ChineseMessage{"{}: not JSON: {}", "{}：不是 JSON：{}"},
    ChineseMessage{"parse error at line {}, column {}: {}", "第 {} 行第 {} 列（{}）"},
    ChineseMessage{"a result file that can be read", "可读的结果文件"},
    ChineseMessage{"{}: {}: found {}, expected {}", "{}：{}：实为 {}，应为{}"},
    ChineseMessage{"the document", "整个文件"},
    ChineseMessage{"an object", "对象"},
    ChineseMessage{"{}: key '{}' is missing", "{}：缺少键 '{}'"},
    ChineseMessage{"an array", "数组"},
    ChineseMessage{"a whole number of at least 0", "不小于 0 的整数"},
    ChineseMessage{"a string", "字符串"},
    ChineseMessage{"true or false", "true 或 false"},
    ChineseMessage{"Ai, Ao or Ap", "Ai、Ao 或 Ap"},
    ChineseMessage{"axes in the order Ai, Ao, Ap", "按 Ai、Ao、Ap 次序排列的轴"},
    ChineseMessage{"at least one axis", "至少一个轴"},
    ChineseMessage{"two numbers", "两个数值"},
    ChineseMessage{"one range for each input", "每个输入一个范围"},
    ChineseMessage{"ranges whose low end is not above the high end", "下限不高于上限的范围"},
    ChineseMessage{"a low end below the high end", "下限低于上限的范围"},
    ChineseMessage{"(inputs + 2) * hidden + 1 numbers", "(inputs + 2) * hidden + 1 个数值"},
};

}  // namespace

std::span<const ChineseMessage> chinese_report_messages() noexcept { return kReportMessages; }

}  // namespace proofmass
