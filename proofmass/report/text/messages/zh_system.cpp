// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "proofmass/report/text/messages/zh_internal.hpp"

namespace proofmass {
namespace {

constexpr std::array kSystemMessages{
    ChineseMessage{"No such file or directory", "没有该文件或文件夹"},
    ChineseMessage{"no such file or directory", "没有该文件或文件夹"},
    ChineseMessage{"Permission denied", "没有权限"},
    ChineseMessage{"permission denied", "没有权限"},
    ChineseMessage{"Is a directory", "这是文件夹"},
    ChineseMessage{"is a directory", "这是文件夹"},
    ChineseMessage{"Not a directory", "路径的某一部分不是文件夹"},
    ChineseMessage{"not a directory", "路径的某一部分不是文件夹"},
    ChineseMessage{"File exists", "文件已存在"},
    ChineseMessage{"File name too long", "文件名太长"},
    ChineseMessage{"file name too long", "文件名太长"},
    ChineseMessage{"Input/output error", "输入输出错误"},
    ChineseMessage{"input/output error", "输入输出错误"},
    ChineseMessage{"No space left on device", "磁盘空间不足"},
    ChineseMessage{"Disk quota exceeded", "超出磁盘配额"},
    ChineseMessage{"File too large", "文件太大"},
    ChineseMessage{"Read-only file system", "文件系统只读"},
    ChineseMessage{"Operation not permitted", "不允许此操作"},
    ChineseMessage{"operation not permitted", "不允许此操作"},
    ChineseMessage{"Invalid argument", "参数无效"},
    ChineseMessage{"Too many open files", "打开的文件太多"},
    ChineseMessage{"too many open files", "打开的文件太多"},
    ChineseMessage{"Too many levels of symbolic links", "符号链接层数太多"},
    ChineseMessage{"too many levels of symbolic links", "符号链接层数太多"},
    ChineseMessage{"No such device or address", "没有该设备或地址"},
    ChineseMessage{"no such device or address", "没有该设备或地址"},
    ChineseMessage{"Device or resource busy", "设备或资源正忙"},
    ChineseMessage{"Text file busy", "程序文件正在运行"},
    ChineseMessage{"Broken pipe", "管道已断开"},
    ChineseMessage{"Bad file descriptor", "文件描述符无效"},
};

}  // namespace

std::span<const ChineseMessage> chinese_system_messages() noexcept { return kSystemMessages; }

}  // namespace proofmass
