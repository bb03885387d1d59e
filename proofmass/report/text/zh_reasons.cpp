// SPDX-License-Identifier: Apache-2.0
// Why a term is not identified.
#include <fmt/format.h>

#include "proofmass/report/text/sentence.hpp"
#include "proofmass/report/text/zh.hpp"

namespace proofmass {
namespace {

std::string in_chinese(std::string_view words, const Finding& finding) {
  return filled(words, finding, nullptr, Language::zh);
}

// The names of the terms that the first is aliased with.
std::string chinese_others(const Finding& finding) {
  return listed_names({finding.terms.begin() + 1, finding.terms.end()}, Language::zh);
}

std::string chinese_aliased(const Finding& finding) {
  if (finding.terms.size() < 2) return "与其他项混叠";
  const auto product = info(finding.terms.front()).product;
  const TermList others(finding.terms.begin() + 1, finding.terms.end());
  if (others == TermList{Term::K0}) return fmt::format("与 K0 混叠，因为 {} 在各行中相同", product);
  if (others.size() == 1) {
    return fmt::format("与 {} 混叠，因为在这些行中 {} 与 {} 成正比", chinese_others(finding), product,
                       info(others.front()).product);
  }
  std::string products;
  for (const Term other : others) products.append(products.empty() ? "" : "、").append(info(other).product);
  return fmt::format("与 {} 混叠，因为在这些行中 {} 是 {} 的线性组合", chinese_others(finding), product,
                     products);
}

std::string chinese_hidden_by_rounding(const Finding& finding) {
  if (finding.terms.size() < 2)
    return in_chinese("其输入不大于输入的修约误差，输入的修约间隔为 {step:.2g} g", finding);
  return fmt::format("在记录的分辨力之内与 {} 混叠，", chinese_others(finding)) +
         in_chinese(
             "因为输入的修约间隔为 {step:.2g} g，这些项之间的差别不超过修约误差。"
             "应以更多位数记录输入，或在更多的加速度水平上测试",
             finding);
}

std::string chinese_hidden_by_uncertainty(const Finding& finding) {
  if (finding.terms.size() < 2) return in_chinese("其输入不大于输入的不确定度 {sigma:.2g} g", finding);
  return fmt::format("在输入的不确定度之内与 {} 混叠，", chinese_others(finding)) +
         in_chinese(
             "因为该不确定度为 {sigma:.2g} g，这些项之间的差别不超过这样大小的误差。"
             "应更准确地测量输入，或在更多的加速度水平上测试",
             finding);
}

std::string why_in_chinese(const Finding& finding) {
  switch (finding.code) {
    case Code::term_without_column:
      return in_chinese("记录中没有 {column} 列", finding);
    case Code::term_input_zero:
      return in_chinese("{product} 在各行中均为零", finding);
    case Code::term_aliased:
      return chinese_aliased(finding);
    case Code::term_beyond_rows:
      return in_chinese("{rows:.0f} 行不能确定多于 {rows:.0f} 个项", finding);
    case Code::term_hidden_by_rounding:
      return chinese_hidden_by_rounding(finding);
    case Code::term_hidden_by_uncertainty:
      return chinese_hidden_by_uncertainty(finding);
    case Code::term_left_out:
      return in_chinese("搜索中未选入：不含该项时准则为 {without:.6g} {unit}，含该项时为 {with:.6g} {unit}",
                        finding);
    case Code::term_without_expansion:
      return "|Ai|*Ai 在零处没有泰勒展开；应使用投影";
    default:
      return chinese(finding);
  }
}

}  // namespace

std::string chinese_reason(const Finding& finding) {
  const std::string text = why_in_chinese(finding);
  return has_figure(finding, "total")
             ? text + in_chinese("（就 {total:.0f} 行中有权的 {count:.0f} 行而言）", finding)
             : text;
}

}  // namespace proofmass
