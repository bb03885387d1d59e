// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "proofmass/report/text/messages/zh_internal.hpp"

namespace proofmass {
namespace {

constexpr std::array kCoreMessages{
    ChineseMessage{"expected {}", "应为{}"},
    ChineseMessage{"found '{}', expected {}", "实为 '{}'，应为{}"},
    ChineseMessage{"{}: {}", "{}：{}"},
    ChineseMessage{"{}:{}", "{} 第 {} 行"},
    ChineseMessage{"key '{}'", "键 '{}'"},
    ChineseMessage{"column '{}'", "列 '{}'"},
    ChineseMessage{"cannot open {}: {}", "不能打开 {}：{}"},
    ChineseMessage{"cannot write '{}': {}", "不能写入 '{}'：{}"},
    ChineseMessage{"output error", "输出错误"},
    ChineseMessage{"the SHA-256 of the cryptographic library failed", "密码库计算 SHA-256 失败"},
    ChineseMessage{"more than {} MiB", "超过 {} MiB"},
    ChineseMessage{"{} {}", "{} {}"},
    ChineseMessage{"term", "项"},
    ChineseMessage{"terms", "项"},
    ChineseMessage{"row", "行"},
    ChineseMessage{"rows", "行"},
    ChineseMessage{"; did you mean {}?", "；是否想写 {}？"},
    ChineseMessage{"interrupted", "已中断"},
    ChineseMessage{"the term {} was not among those to identify", "项 {} 不在要辨识的各项之中"},
    ChineseMessage{"unknown term '{}'; expected linear, quadratic, paper, full, or names among {}",
                   "未知的项 '{}'；应为 linear、quadratic、paper、full，或从下列名称中选取：{}"},
    ChineseMessage{"term '{}' is listed twice", "项 '{}' 列出了两次"},
};

}  // namespace

std::span<const ChineseMessage> chinese_core_messages() noexcept { return kCoreMessages; }

}  // namespace proofmass
