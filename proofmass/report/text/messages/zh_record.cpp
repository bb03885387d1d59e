// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "proofmass/report/text/messages/zh_internal.hpp"

namespace proofmass {
namespace {

constexpr std::array kRecordMessages{
    ChineseMessage{"an empty file", "空文件"},
    ChineseMessage{"a header alone", "只有表头"},
    ChineseMessage{"data rows below it", "表头之下有数据行的文件"},
    ChineseMessage{"nothing but blank lines and comments", "只有空行和注释"},
    ChineseMessage{"a header line that names the columns Ai Ao Ap E", "写有列名 Ai Ao Ap E 的表头行"},
    ChineseMessage{"{}; without one, say which column is which, and the units",
                   "{}；没有表头时，须说明各列的含义和单位"},
    ChineseMessage{"the header above all rows of numbers; line {} looks like one",
                   "位于所有数据行之前的表头；第 {} 行看来是数据行"},
    ChineseMessage{"an encoding that the system's C library can convert", "系统的 C 库能够转换的编码"},
    ChineseMessage{"encoding: {}", "encoding：{}"},
    ChineseMessage{"{} columns", "{} 列"},
    ChineseMessage{"at most {} columns", "至多 {} 列"},
    ChineseMessage{"a column name with matching quotes", "引号成对的列名"},
    ChineseMessage{"a field with matching quotes", "引号成对的字段"},
    ChineseMessage{" (it was to be read as {})", "（要读作 {}）"},
    ChineseMessage{"; '{}' is an angle: with the input axis at that angle from the vertical, Ai = cos(angle) "
                   "and the cross axis sin(angle), in g. Add such columns",
                   "；'{}' 是角度：输入轴与铅垂方向成该角时，Ai = cos(角度)，交叉轴为 sin(角度)，单位为 "
                   "g。请添加这样的列"},
    ChineseMessage{"a column named {}{}; columns are separated by comma, semicolon, tab, | or blanks{}",
                   "名为 {} 的列{}；各列以逗号、分号、制表符、| 或空格分隔{}"},
    ChineseMessage{"one column named {}, not a duplicate", "唯一的名为 {} 的列，不得重复"},
    ChineseMessage{"the unit that the file states, {}", "文件注明的单位 {}"},
    ChineseMessage{
        "cannot rename to '{}'; the columns of a record are Ai, Ao, Ap, E, sigma_E, sigma_Ai, sigma_Ao, "
        "sigma_Ap, mount, T, t",
        "不能改名为 '{}'；记录的列为 Ai、Ao、Ap、E、sigma_E、sigma_Ai、sigma_Ao、sigma_Ap、mount、T、t"},
    ChineseMessage{"column '{}' is renamed twice", "列 '{}' 改名两次"},
    ChineseMessage{"a readable record (a CSV file)", "可读的记录（CSV 文件）"},
    ChineseMessage{"lines of at most {} bytes", "每行至多 {} 字节"},
    ChineseMessage{"text in {}", "{} 编码的文本"},
    ChineseMessage{"text in UTF-8", "UTF-8 编码的文本"},
    ChineseMessage{"lines that end in LF or CRLF, not in CR alone", "以 LF 或 CRLF 而不是单独的 CR 结束的行"},
    ChineseMessage{"text without control characters, not a binary file",
                   "不含控制字符的文本，而不是二进制文件"},
    ChineseMessage{"comma", "逗号"},
    ChineseMessage{"point", "点"},
    ChineseMessage{"numbers whose {} is decimal for certain: here each has three digits after it or none at "
                   "all, as thousands do. Take the {}s out if they part thousands",
                   "能确定{}表示小数的数值：这里其后都是三位数字或没有数字，与千位分隔相同。若{}"
                   "是千位分隔符，请将其删去"},
    ChineseMessage{"a number", "数值"},
    ChineseMessage{"a number, not an empty field", "数值，不能为空"},
    ChineseMessage{"a finite number", "有限的数值"},
    ChineseMessage{"a number within the range of double precision", "双精度范围内的数值"},
    ChineseMessage{"a number with a decimal point, not a decimal comma", "以小数点而不是逗号表示小数的数值"},
    ChineseMessage{"a number with a decimal comma and no point, as in the other rows",
                   "与其他行相同，以逗号表示小数而不含点的数值"},
    ChineseMessage{"a measured value; this is a meter's mark for one beyond its range",
                   "测量值；这是仪表的超量程标记"},
    ChineseMessage{"a number, or one in the unit of the column, {}", "数值，可带该列的单位 {}"},
    ChineseMessage{"a standard uncertainty, which is not negative", "标准不确定度，不得为负"},
    ChineseMessage{"rows under the header of line {}; this looks like another header: put what follows into "
                   "a file of its own",
                   "第 {} 行表头之下的数据行；此行看来是另一个表头：请把其后的内容另存为一个文件"},
    ChineseMessage{"{} as in the header, not {}", "与表头相同的 {}，而不是 {} 个"},
    ChineseMessage{"field", "个字段"},
    ChineseMessage{"fields", "个字段"},
    ChineseMessage{"no unit", "无单位"},
    ChineseMessage{"a unit among {}", "下列单位之一：{}"},
    ChineseMessage{"the unit of {}, [{}], not mixed units", "与 {} 相同的单位 [{}]，不得混用单位"},
    ChineseMessage{"the numbers of a record must be finite", "记录中的数值必须有限"},
    ChineseMessage{"text of a record must fit on one line: '{}'", "记录中的文字必须在一行之内：'{}'"},
    ChineseMessage{"a record needs the column Ai", "记录必须有列 Ai"},
};

}  // namespace

std::span<const ChineseMessage> chinese_record_messages() noexcept { return kRecordMessages; }

}  // namespace proofmass
