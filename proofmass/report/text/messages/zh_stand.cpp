// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "proofmass/report/text/messages/zh_internal.hpp"

namespace proofmass {
namespace {

constexpr std::array kStandMessages{
    ChineseMessage{"a readable TOML file", "可读的 TOML 文件"},
    ChineseMessage{"TOML: {}", "TOML 格式：{}"},
    ChineseMessage{"an integer", "整数"},
    ChineseMessage{"a list of finite numbers", "由有限数值组成的列表"},
    ChineseMessage{"a table", "表"},
    ChineseMessage{"a list of tables", "由表组成的列表"},
    ChineseMessage{"one of the keys {}", "下列键之一：{}"},
    ChineseMessage{"Student noise with 2 or fewer degrees of freedom has no standard deviation to record",
                   "自由度不大于 2 的学生 t 噪声没有可记录的标准差"},
    ChineseMessage{"numbers beyond double precision in simulated row {}",
                   "仿真的第 {} 行有超出双精度范围的数值"},
    ChineseMessage{"coefficients, inputs and noise of plausible size", "大小合理的系数、输入和噪声"},
    ChineseMessage{"a simulation needs at least one row", "仿真至少需要一行"},
    ChineseMessage{"a simulation needs either a range of specific force or mounts and levels",
                   "仿真需要比力的范围，或者安装位置和加速度水平"},
    ChineseMessage{"a simulation by mounts needs at least one mount and one level",
                   "按安装位置仿真时，至少需要一个安装位置和一个加速度水平"},
    ChineseMessage{"a number that is not negative", "非负的数值"},
    ChineseMessage{"a table of coefficients, such as Ki = 1.0", "由系数组成的表，例如 Ki = 1.0"},
    ChineseMessage{"a coefficient's name among {}", "下列系数名之一：{}"},
    ChineseMessage{"at least one coefficient", "至少一个系数"},
    ChineseMessage{"a number above zero", "大于零的数值"},
    ChineseMessage{"the largest specific force, in g", "最大比力，单位为 g"},
    ChineseMessage{"a number above zero and not below minimum_g", "大于零且不小于 minimum_g 的数值"},
    ChineseMessage{"three numbers, along IA, OA and PA, not all zero",
                   "沿 IA、OA 和 PA 的三个数值，不得全为零"},
    ChineseMessage{"the mount's name", "安装位置的名称"},
    ChineseMessage{"a name without separators, quotes, # and control characters",
                   "不含分隔符、引号、# 和控制字符的名称"},
    ChineseMessage{"the direction of the centripetal specific force in (IA, OA, PA)",
                   "向心比力在 (IA, OA, PA) 中的方向"},
    ChineseMessage{"a list of at least one level, in g", "至少含一个加速度水平的列表，单位为 g"},
    ChineseMessage{"levels that are not negative", "非负的加速度水平"},
    ChineseMessage{"a name that no other mount has", "与其他安装位置不同的名称"},
    ChineseMessage{"a table with minimum_g and maximum_g, or with levels_g and mounts",
                   "含有 minimum_g 和 maximum_g，或含有 levels_g 和 mounts 的表"},
    ChineseMessage{"a list of mounts, for there are levels_g", "由安装位置组成的列表，因为给出了 levels_g"},
    ChineseMessage{"at least one mount", "至少一个安装位置"},
    ChineseMessage{"a fraction from 0 to 1", "0 至 1 的比例"},
    ChineseMessage{"degrees of freedom above zero", "大于零的自由度"},
    ChineseMessage{"three numbers, along IA, OA and PA", "沿 IA、OA 和 PA 的三个数值"},
    ChineseMessage{"numbers that are not negative", "非负的数值"},
    ChineseMessage{"a known unit, such as g, m/s^2, mA or V", "已知的单位，例如 g、m/s^2、mA 或 V"},
    ChineseMessage{"a unit of acceleration: {}", "加速度的单位：{}"},
    ChineseMessage{"a unit of an accelerometer's output, such as g, mA or V",
                   "加速度计输出的单位，例如 g、mA 或 V"},
    ChineseMessage{"no scale factor with an output in units of acceleration",
                   "空：输出以加速度为单位时不需要标度因数"},
    ChineseMessage{"the scale factor, output_unit per g", "标度因数，单位为 output_unit 每 g"},
    ChineseMessage{"false, for Student noise with 2 or fewer degrees of freedom has no deviation",
                   "false，因为自由度不大于 2 的学生 t 噪声没有标准差"},
    ChineseMessage{"the number of rows", "行数"},
    ChineseMessage{"a number of rows from 1 to 100000000", "1 至 100000000 的行数"},
    ChineseMessage{"an integer that is not negative", "非负的整数"},
};

}  // namespace

std::span<const ChineseMessage> chinese_stand_messages() noexcept { return kStandMessages; }

}  // namespace proofmass
