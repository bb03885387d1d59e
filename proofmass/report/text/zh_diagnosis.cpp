// SPDX-License-Identifier: Apache-2.0
// Faults of a record and of a fit: cause, consequence, remedy.
#include "proofmass/report/text/zh_diagnosis.hpp"

#include <array>

#include "proofmass/report/text/templates_internal.hpp"

namespace proofmass {
namespace {

constexpr std::string_view kChineseRows =
    "少数行偏离很大，其余各行正常。应使用 robust 方法，并检查其列出的可疑行";

constexpr std::string_view kChineseMixed =
    "部分行的输入或输出与其他行的单位不同（相差 9.8 倍或 1000 倍）。应换算为同一单位";

constexpr std::array kChinesePhrases{
    NamedPhrase{"hint", "output_si", "输出的单位似为 m/s²。应注明单位：E[m/s^2]"},
    NamedPhrase{"hint", "inputs_si", "输入的单位似为 m/s²。应注明单位：Ai[m/s^2]"},
    NamedPhrase{"hint", "output_milli", "输出的单位似为 mg。应注明单位：E[mg]"},
    NamedPhrase{"hint", "inputs_milli", "输入的单位似为 mg。应注明单位：Ai[mg]"},
    NamedPhrase{"hint", "output_micro", "输出的单位似为 ug。应注明单位：E[ug]"},
    NamedPhrase{"hint", "output_milli_si", "输出的单位似为 mm/s²。应注明单位：E[mm/s^2]"},
    NamedPhrase{"hint", "output_gal", "输出的单位似为 Gal。应注明单位：E[Gal]"},
    NamedPhrase{"hint", "inputs_gal", "输入的单位似为 Gal。应注明单位：Ai[Gal]"},
    NamedPhrase{"hint", "output_milli_inputs_si",
                "输出的单位似为 mg，输入的单位似为 m/s²。应注明单位：E[mg]、Ai[m/s^2]"},
    NamedPhrase{"hint", "turned",
                "连同 Ko = {ko:.4g} 和 Kp = {kp:.4g} g/g，如同仪表相对于记录的坐标轴转过 {angle:.3g}°，"
                "或输出与另一位置的输入列在同一行。应将输入转过该角度，或将输出移回各自的行"},
    NamedPhrase{"hint", "mixed", kChineseMixed},
    NamedPhrase{"hint", "rows", kChineseRows},
    NamedPhrase{"hint", "undeclared", "E 未注明单位，按 g 处理。应注明单位，如 E[V]"},
    NamedPhrase{"hint", "declared", "E 或输入的单位与记录所注不符，或读错了列"},
    NamedPhrase{"reason", "terms",
                "静态模型中未列入的项能解释其大部分。应改用 full 模型，并去掉不可辨识的项"},
    NamedPhrase{"reason", "rows",
                "少数行偏离很远，其余各行正常{named}。应更正或剔除有误的数据，或使用 robust "
                "方法并检查其列出的可疑行"},
    NamedPhrase{"named", "lines", "：第 {lines} 行"},
    NamedPhrase{"reason", "mixed",
                "部分行的输入或输出与其余各行单位不同，或标度不同（比值为 9.8 或 1000）。现有系数没有意义。"
                "应将各行换算为同一单位；其中沿输入轴的是第 {lines} 行"},
    NamedPhrase{"reason", "unrelated", "输出与输入几乎无关。读错了列，或各行的次序不同"},
    NamedPhrase{"reason", "unknown", "输入只能解释输出的一部分。应画出输出对各输入的关系图"},
    NamedPhrase{"direction", "below", "输出在其输入之下，应将输出列上移同样的行数"},
    NamedPhrase{"direction", "above", "输出在其输入之上，应将输出列下移同样的行数"},
    NamedPhrase{"shape", "step", "{axis} 变号处输出似有 {change:.3g} {unit} 的跳变"},
    NamedPhrase{"shape", "slope", "对正、负 {axis} 的响应似相差 {change:.3g} {unit}/g"},
    NamedPhrase{"shape", "direction", "{axis} 上升所至的行与下降所至的行，输出似相差 {change:.3g} {unit}"},
    NamedPhrase{
        "course", "gradual",
        "在整个记录中变化 {change:.3g} {unit}，为标准误差的 {errors:.3g} 倍（噪声 {scale:.3g} {unit}）。"
        "若各行按试验的先后排列，这就是漂移，会使系数改变：应去掉预热阶段的数据，或重复测量参考位置，"
        "并从输出中扣除漂移"},
    NamedPhrase{"course", "jump",
                "自第 {first:.0f} 行起与此前相差 {change:.3g} {unit}，为标准误差的 {errors:.3g} 倍"
                "（噪声 {scale:.3g} {unit}）。零偏或安装在该处发生了变化，会使系数改变。"
                "应将记录的各段分别辨识，或在各段重复测量参考位置，并从输出中扣除其差"},
    NamedPhrase{
        "course", "stretch",
        "第 {first:.0f} 行至第 {last:.0f} 行与其余各行相差 {change:.3g} {unit}，为标准误差的 {errors:.3g} 倍"
        "（噪声 {scale:.3g} {unit}）。这些行属于另一次安装或另一台仪表，会使系数改变。应单独辨识或剔除"},
    NamedPhrase{
        "course", "factor_gradual",
        "在整个记录中 Ki 变化 {change:.3g} {unit}，为标准误差的 {errors:.3g} 倍。若各行按试验的先后排列，"
        "这就是标度因数的漂移：应待仪表充分预热，或将记录拆分后分别辨识"},
    NamedPhrase{"course", "factor_jump",
                "自第 {first:.0f} 行起 Ki 与此前相差 {change:.3g} {unit}，为标准误差的 {errors:.3g} 倍。"
                "增益、读出量程或仪表在该处发生了变化，Ki 只是平均值。应将记录的各段分别辨识"},
    NamedPhrase{"course", "factor_stretch",
                "第 {first:.0f} 行至第 {last:.0f} 行的 Ki 与其余各行相差 {change:.3g} {unit}，为标准误差的 "
                "{errors:.3g} 倍。这些行的增益不同，或属于另一台仪表，Ki 只是平均值。应单独辨识或剔除"},
    NamedPhrase{"weight", "none", "不起作用"},
    NamedPhrase{"weight", "all", "单独决定系数"},
    NamedPhrase{"shape", "other", "在其范围的各段内大小不同"},
    NamedPhrase{
        "magnitudes", "all_axes",
        "各行的 |A| 为 {least:.5g} 至 {largest:.5g}，按 {read} 读取，而看来是以 {written} 表示的 1 g。"
        "各系数因而差该比值的若干次方。应在表头注明单位，如 Ai[{written}]"},
    NamedPhrase{
        "magnitudes", "one_axis",
        "|Ai| 的最大值在正负两个方向均为 {largest:.5g}，按 {read} 读取，而看来是以 {written} 表示的 1 g。"
        "各系数因而差该比值的若干次方。应在表头注明单位，如 Ai[{written}]"},
    NamedPhrase{
        "magnitudes", "one_of_axes",
        "{axis} 按 {read} 读取，而看来以 {written} 为单位：若如此，整个记录的 |A| 有 {after:.0f} 个值，"
        "否则有 {before:.0f} 个。{axis} 的各系数因而差该比值的若干次方。应在表头注明单位，如 "
        "{axis}[{written}]"},
    NamedPhrase{"size", "power", "2^{bits:.0f} = {turn:.0f}"},
    NamedPhrase{"size", "other", "{turn:.7g} {unit}"},
    NamedPhrase{"within", "rows",
                "相邻行的残差相关（相关系数 {correlation:.2f}，为标准误差的 {errors:.3g} 倍）："
                "输出有漂移，或模型缺项"},
    NamedPhrase{"within", "mounts",
                "同一安装位置内相邻行的残差相关（相关系数 {correlation:.2f}，"
                "为标准误差的 {errors:.3g} 倍），而不同安装位置之间不相关：试验设备的误差（对准、半径、"
                "夹具）会造成这种现象"},
    NamedPhrase{"which", "largest", "最大"},
    NamedPhrase{"which", "smallest", "最小"},
    NamedPhrase{"function", "sine", "正弦"},
    NamedPhrase{"function", "cosine", "余弦"}};

}  // namespace

std::string_view chinese_diagnosis(Code code) noexcept {
  switch (code) {
    case Code::inputs_in_other_unit:
      return "{magnitudes}";
    case Code::inputs_are_angles:
      return "输出随输入的{function}变化（输入视为以 {written} 表示的角度），而不随输入本身变化："
             "输入是分度头的角度。现有系数没有意义。应以该角度的{function}乘以当地重力加速度作为 Ai";
    case Code::inputs_too_large:
      return "加速度高达 {largest:.3g} g（按 {read} 读取），"
             "而加速度计的试验设备不会产生超过 {limit:g} g 的加速度：输入的单位不同，或读错了列。"
             "应在表头注明单位，如 Ai[ug]";
    case Code::output_far_off:
      return "第 {line:.0f} 行的 E 为 {value:g} {unit}，超过其余各行最大值的 {limit:g} 倍"
             "（此类行共 {count:.0f} 行，其间没有中间值）：是过载或缺测标记，或笔误。"
             "系数会由这样的行单独决定。应更正或剔除：第 {lines} 行";
    case Code::sigma_output_far_off:
      return "第 {line:.0f} 行的 sigma_E 为 {value:.3g} {unit}，中位数为 {others:.3g} {unit}"
             "（此类行共 {count:.0f} 行，其间没有中间值）：是缺测标记或笔误。"
             "按 sigma_E 加权时这样的行{weight}。应更正 sigma_E，或剔除：第 {lines} 行";
    case Code::square_larger:
      return "{terms}（{value:.6g} {unit}²）对输出的贡献大于 Ki（{ki:.6g} {unit}）："
             "输出随输入的平方变化，如功率，或失去符号的读数。现有系数不是加速度计的系数。"
             "应指明输出所在的列，或给出原始读数";
    case Code::input_far_off:
      return "第 {line:.0f} 行的 {axis} 为 {value:g} {unit}，"
             "超过其余绝大多数行的 {limit:g} 倍（此类行共 {count:.0f} 行，其间没有中间值）："
             "是缺测标记或笔误。{axis} 的各项会由这样的行单独决定。应更正或剔除：第 {lines} 行";
    case Code::magnitude_unlike_others:
      return "第 {line:.0f} 行的 |A| 为 {value:.7g} {unit}，"
             "其余绝大多数行为 {others:.7g} {unit}（与之不同的共 {count:.0f} 行）：输入可能填写有误。"
             "其他行不能区分的项可能由这样的行单独决定，其值可有任意大的误差。应更正输入或剔除："
             "第 {lines} 行";
    case Code::rows_shifted:
      return "输出与其他行的输入相对应，错开 {shift:.0f} 行：{direction}。现有系数没有意义";
    case Code::output_unsigned:
      return "输出全为同一符号，而将 Ai 为负的各行反号后与输入吻合：仪表或文件丢失了输出的符号。"
             "现有系数没有意义。应记录带符号的输出";
    case Code::output_copies_input:
      return "各行的输出均等于 {axis}：其中一列是另一列的复制，系数不反映任何仪表的特性。"
             "应指明输出所在的列";
    case Code::output_clipped:
      return "输入不同的 {count:.0f} 行具有完全相同的{which}输出 {value:.8g} {unit}：输出在此削波，"
             "以其拟合的系数有误。应剔除这些行，或扩大仪表量程：第 {lines} 行";
    case Code::output_saturated:
      return "输出止于 {value:.6g} {unit}，而由其他行推算，"
             "{count:.0f} 行的输入应使输出达到 {expected:.6g} {unit}：输出在此饱和或折返，"
             "以其拟合的系数有误。应剔除这些行，或扩大仪表量程：第 {lines} 行";
    case Code::output_stuck:
      return "连续 {longest:.0f} 行（第 {first:.0f} 行至第 {last:.0f} 行）的输出与 {value:.8g} {unit} "
             "相差不超过 {spread:.3g} {unit}，"
             "而输入的变化应使其改变 {expected:.3g} {unit}：输出卡滞，以其拟合的系数有误。应剔除这些行";
    case Code::output_repeated:
      return "输入不同的 {count:.0f} 行输出完全相同，均为 {value:.8g} {unit}：读数缺失或未刷新，"
             "以其拟合的系数有误。应剔除这些行：第 {lines} 行";
    case Code::output_held:
      return "输入变化时，输出在相邻行之间重复 {repeats:.0f} 次（最长连续 {longest:.0f} 行，"
             "为 {value:.8g} {unit}，第 {first:.0f} 行至第 {last:.0f} 行）：输出卡滞或被保持，"
             "以其拟合的系数有误。应剔除这些行，或每行重新读取一次仪表";
    case Code::output_wrapped:
      return "按 Ai 的次序，输出有跳变，将 {percent:.3g} % 的行加上 {size} 的整数倍后与输入吻合："
             "有符号的计数被读作无符号数，或计数器、转换器溢出。现有系数没有意义。应按有符号数读取，"
             "扩大计数器的范围，或在辨识前消除跳变";
    case Code::rows_duplicated:
      return "{count:.0f} 行与先前的行重复，"
             "输入和输出均相同（第 {first:.0f} 行重复第 {original:.0f} 行）：重复粘贴的行被计入两次，"
             "标准误差因而偏小。应去掉重复的行：第 {lines} 行";
    case Code::time_backwards:
      return "{total:.0f} 行中有 {count:.0f} 行的 t 倒退：记录经拼接或按其他量排序，时钟被调整，"
             "或 t 中有标记。此时无法判断漂移。应更正 t，或将各行按试验的先后排列：第 {lines} 行";
    case Code::time_standing:
      return "{total:.0f} 行中有 {count:.0f} 行的 t 停滞：行被重复粘贴，或时钟停走：第 {lines} 行";
    case Code::temperature_implausible:
      return "第 {line:.0f} 行的 T 为 {value:g} {unit}（此类行共 {count:.0f} 行），"
             "与其他行相差超过 {limit:g} {unit}，或低于绝对零度：是缺测标记，或单位不同。"
             "此时不判断残差是否随 T 变化。应更正 T 或剔除：第 {lines} 行";
    case Code::scale_factor_negative:
      return "标度因数 Ki 为负（{value:.6g} {unit}）：沿输入轴的加速度增大时输出减小。输入轴方向相反，"
             "或输出引线接反";
    case Code::scale_factor_unlike_one:
      return "标度因数 Ki 为 {value:.6g} g/g，与 1 相差甚远：{hint}";
    case Code::cross_axis_larger:
      return "{terms}（{value:.6g} {unit}）大于 Ki（{ki:.6g} {unit}）：各轴的列互换，"
             "或仪表沿记录所述以外的轴安装。应按实际情况标明各列";
    case Code::cross_axis_large:
      return "{terms} 为 Ki 的 {percent:.3g} %，如同仪表相对于记录的坐标轴转过 {angle:.3g}°，"
             "或输出与另一位置的输入列在同一行。应对准仪表或将输入转过该角度，或将输出移回各自的行";
    case Code::few_degrees_of_freedom:
      return "{rows:.0f} 行只余 {dof:.0f} 个自由度：标准误差本身的不确定度约为 {percent:.0f} %，"
             "失拟也无从显现。应增加数据行或减少项数";
    case Code::gross_misfit:
      return "拟合不能解释输出（R² 为 {r2:.3g}）：{reason}";
    case Code::model_too_short:
      return "残差随模型所缺、而数据行能够辨识的 {count:.0f} 项变化：{terms}（{errors:.3g} 倍标准误差）。"
             "加入这些项，残差标准差将由 {before:.3g} 降至 {after:.3g} {unit}；不加入，"
             "其影响也会混入其他系数。应加入这些项，或改用 full 模型并去掉不可辨识的项";
    case Code::rows_far_off:
      return "{count:.0f} 行偏离拟合过远，不可能是噪声（第 {line:.0f} 行偏离 {residual:.3g} {unit}；"
             "该处残差的尺度为 {scale:.3g} {unit}），并使系数改变。应更正或剔除有误的数据，"
             "或使用 robust 方法：第 {lines} 行";
    case Code::residuals_follow_time:
      return "残差随 t 变化：在整个记录中变化 {change:.3g} {unit}，"
             "为标准误差的 {errors:.3g} 倍（噪声 {scale:.3g} {unit}）。漂移会使系数改变。"
             "应去掉预热阶段的数据，或在试验中重复测量参考位置，并从输出中扣除漂移";
    case Code::residuals_follow_temperature:
      return "残差随 T 变化：在 T 的范围内变化 {change:.3g} {unit}，"
             "为标准误差的 {errors:.3g} 倍（噪声 {scale:.3g} {unit}）。漂移会使系数改变。"
             "应待温度稳定后测试，或从输出中扣除温度的影响";
    case Code::residuals_follow_order:
      return "残差随行的次序变化：{course}";
    case Code::residuals_follow_mount:
      return "残差随安装位置变化，{total:.0f} 个安装位置中有 {count:.0f} 个如此："
             "在 {mount} 处残差的平均值为 {mean:.3g} {unit}，偏离零 {errors:.3g} 倍标准误差。"
             "试验设备的误差（对准、半径、夹具）会造成这种现象。这类误差为同一安装位置的各行所共有，"
             "而标准误差以各行独立为前提，因而偏小";
    case Code::residuals_follow_inputs:
      return "残差随 {axis} 变化，且静态模型的各项都不能描述：{shape}。残差标准差为 {before:.3g} {unit}，"
             "扣除这一变化后为 {after:.3g} {unit}。读数装置换量程、死区或迟滞会造成这种现象，"
             "此时 {axis} 的各系数只是平均值。应检查读数装置，将各段范围分别辨识，或使用 hybrid 方法";
    case Code::scale_factor_follows_time:
      return "标度因数随 t 变化：在整个记录中 Ki 变化 {change:.3g} {unit}，为标准误差的 {errors:.3g} 倍。"
             "所得 Ki 只是整个记录的平均值。应待仪表充分预热，或将记录拆分后分别辨识";
    case Code::scale_factor_follows_temperature:
      return "标度因数随 T 变化：在 T 的范围内 Ki 变化 {change:.3g} {unit}，"
             "为标准误差的 {errors:.3g} 倍。应待温度稳定后测试，或从输出中扣除温度的影响";
    case Code::scale_factor_follows_order:
      return "标度因数随行的次序变化：{course}";
    case Code::scale_factor_follows_mount:
      return "各安装位置的标度因数不同，{total:.0f} 个安装位置中有 {count:.0f} 个如此："
             "在 {mount} 处 Ki 相差 {mean:.3g} {unit}，为标准误差的 {errors:.3g} 倍。安装半径有误，"
             "或仪表在更换安装位置时被更换或调整，会造成这种现象";
    case Code::alignment_follows_mount:
      return "各安装位置对垂直于输入轴的加速度响应不同，{total:.0f} 个安装位置中有 {count:.0f} 个如此："
             "在 {mount} 处 {terms} 相差 {mean:.3g} {unit}，为标准误差的 {errors:.3g} 倍。"
             "仪表在安装位置上未对准会造成这种现象（1 mrad 相当于横向加速度的 1e-3）。应重新对准，"
             "或按该角度修正此安装位置的输入";
    case Code::residuals_correlated:
      return "{within}。标准误差以各行独立为前提，因而偏小。应查明漂移的来源，"
             "或以留出的行和安装位置的误差为准";
    case Code::sigma_inputs_unused:
      return "未使用 sigma_A... 各列：{method} 视输入为准确值。"
             "输入的不确定度可解释残差方差的 {percent:.3g} %。eiv 计入这些不确定度";
    case Code::sigma_output_uneven:
      return "sigma_E 与残差不相称：在 sigma_E 不小于 {limit:.3g} {unit} 的 {count:.0f} 行中，"
             "残差为其 {large:.3g} 倍，在其余各行中为 {small:.3g} 倍。按 sigma_E 加权会偏重有误的行，"
             "由其得到的标准误差也不正确。应检查 sigma_E 的单位和各行的值";
    default:
      return {};
  }
}

std::string_view chinese_diagnosis_phrase(std::string_view figure, std::string_view word) noexcept {
  for (const NamedPhrase& one : kChinesePhrases) {
    if (one.figure == figure && one.word == word) return one.phrase;
  }
  return {};
}

}  // namespace proofmass
