// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "proofmass/report/text/messages/zh_internal.hpp"

namespace proofmass {
namespace {

constexpr std::array kProgramMessages{
    ChineseMessage{"{}: found '{}', expected a file or folder; ./{} is one of that name",
                   "{}：给出的是 '{}'，应为文件或文件夹；该名称的文件可写作 ./{}"},
    ChineseMessage{"{}: found an empty name, expected a file or folder", "{}：名称为空，应为文件或文件夹"},
    ChineseMessage{"completion: found '{}', expected bash, zsh or fish",
                   "completion：实为 '{}'，应为 bash、zsh 或 fish"},
    ChineseMessage{"--{}: {}", "--{}：{}"},
    ChineseMessage{"--model and --terms both choose the terms: give one of them",
                   "--model 和 --terms 都用来选定项：请只给出其中一个"},
    ChineseMessage{"--terms: found nothing, expected names of terms, as K0,Ki",
                   "--terms：值为空，应为项的名称，例如 K0,Ki"},
    ChineseMessage{"--{} is the former name of --{}: give one of them",
                   "--{} 是 --{} 的旧名：请只给出其中一个"},
    ChineseMessage{"--{} is an option of {}; {} {} not take it", "--{} 是 {} 的选项；{} {}此选项"},
    ChineseMessage{"does", "没有"},
    ChineseMessage{"do", "都没有"},
    ChineseMessage{"--initial-swarm is for one size of network; give --hidden a number with it",
                   "--initial-swarm 只用于一种大小的网络；请同时以 --hidden 给出单元数"},
    ChineseMessage{"nothing", "空"},
    ChineseMessage{"a file of positions that can be read", "可读的位置文件"},
    ChineseMessage{"no position", "没有位置"},
    ChineseMessage{"a line of numbers for each particle", "每个粒子一行数值"},
    ChineseMessage{"interrupted; nothing was written", "已中断；没有写入任何文件"},
    ChineseMessage{"unknown verb '{}', expected one of {}{}", "未知的命令 '{}'，应为下列之一：{}{}"},
    ChineseMessage{"{}{} (see {})", "{}{}（见 {}）"},
    ChineseMessage{"manual: unknown verb '{}'{}", "manual：未知的命令 '{}'{}"},
    ChineseMessage{"interrupted while writing to standard output", "在写标准输出时被中断"},
    ChineseMessage{"cannot write to standard output: {}", "不能写入标准输出：{}"},
    ChineseMessage{"cannot make the folder '{}': {}", "不能建立文件夹 '{}'：{}"},
    ChineseMessage{"'{}' is an input: writing it would destroy it", "'{}' 是输入文件：写入会毁坏它"},
    ChineseMessage{"'{}' is to be written twice: give each output a file of its own",
                   "'{}' 要写两次：请给每个输出各自的文件"},
    ChineseMessage{"cannot write '{}': there is no folder '{}'", "不能写入 '{}'：没有文件夹 '{}'"},
    ChineseMessage{"--out: '{}' is not a folder", "--out：'{}' 不是文件夹"},
    ChineseMessage{"--map: {}", "--map：{}"},
    ChineseMessage{"NAME=COLUMN, as Ai=ax", "名称=列名，例如 Ai=ax"},
    ChineseMessage{"--map: '{}' is given twice", "--map：'{}' 给出了两次"},
    ChineseMessage{"--methods: found an empty name, expected a method before and after every comma",
                   "--methods：名称为空，每个逗号的前后都应有方法名"},
    ChineseMessage{"--methods: '{}' is listed twice", "--methods：'{}' 列出了两次"},
    ChineseMessage{"accelerations or weights beyond all measure", "大得无法计算的加速度或权值"},
    ChineseMessage{"inputs for which the result predicts a finite output", "使结果的预测值有限的输入"},
    ChineseMessage{"standard input can be the result or the inputs, not both",
                   "标准输入可以是结果或输入，不能同时是两者"},
    ChineseMessage{
        "{} is not the record that {} was made from: its SHA-256 is {}, that of the result's record {}; give "
        "that record, or leave the option out for a report without figures of rows",
        "{0} 不是 {1} 所用的记录：其 SHA-256 为 {2}，而结果所用记录的为 "
        "{3}；请给出该记录，或省略此选项而得到不含逐行图的报告"},
    ChineseMessage{"out of memory", "内存不足"},
    ChineseMessage{"internal error: {}", "内部错误：{}"},
    ChineseMessage{"A subcommand is required", "缺少命令"},
    ChineseMessage{"{} is required", "缺少 {}"},
    ChineseMessage{"{}: {} required {} missing", "{0}：缺少 {1} 个 {2} 值"},
    ChineseMessage{"{}: At least {} required but received {}", "{}：至少需要 {} 个值，给出了 {} 个"},
    ChineseMessage{"{}: At Most {} required but received {}", "{}：至多 {} 个值，给出了 {} 个"},
    ChineseMessage{"Expected exactly {} arguments to {}, got {}", "{1} 应有 {0} 个值，给出了 {2} 个"},
    ChineseMessage{"Expected at least {} arguments to {}, got {}", "{1} 至少应有 {0} 个值，给出了 {2} 个"},
    ChineseMessage{"{} was given a disallowed flag override", "{} 不能带值"},
    ChineseMessage{"{}: too many inputs for a flag", "{} 不能带多个值"},
    ChineseMessage{"{}: Should be true/false or a number", "{} 应为 true、false 或数值"},
    ChineseMessage{"Could not convert: {} = {}", "不能转换：{} = {}"},
    ChineseMessage{"The following argument was not expected: {}", "多余的参数：{}"},
    ChineseMessage{"The following arguments were not expected: {}", "多余的参数：{}"},
    ChineseMessage{"{} requires {}", "{} 需要同时给出 {}"},
    ChineseMessage{"{} excludes {}", "{} 不能与 {} 同时给出"},
};

}  // namespace

std::span<const ChineseMessage> chinese_program_messages() noexcept { return kProgramMessages; }

}  // namespace proofmass
