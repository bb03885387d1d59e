// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/zh.hpp"

#include <string_view>

#include "proofmass/report/text/language.hpp"
#include "proofmass/report/text/sentence.hpp"
#include "proofmass/report/text/templates_internal.hpp"
#include "proofmass/report/text/zh_diagnosis.hpp"

namespace proofmass {

// As in English.
std::string_view chinese_template(Code code) noexcept {
  switch (code) {
    case Code::verbatim:
      return "{text}";
    case Code::term_without_column:
    case Code::term_input_zero:
    case Code::term_aliased:
    case Code::term_beyond_rows:
    case Code::term_hidden_by_rounding:
    case Code::term_hidden_by_uncertainty:
    case Code::term_left_out:
    case Code::term_without_expansion:
      break;  // see chinese_reason
    case Code::record_decoded:
      return "记录不是 UTF-8 编码：按 {encoding} 读取";
    case Code::record_preamble_skipped:
      return "已跳过表头之前的 {count:.0f} 行：第 {lines} 行";
    case Code::record_header_in_comment:
      return "第 {lines} 行是注释行，已作为表头读取";
    case Code::record_units_line:
      return "第 {lines} 行已作为各列的单位读取";
    case Code::record_units_in_cells:
      return "单位取自单元格，共 {count:.0f} 行";
    case Code::record_unit_in_name:
      return "列名 {column} 的末尾已作为单位 {unit} 读取";
    case Code::record_units_assumed:
      return "{columns} 未注明单位，按 {unit} 处理";
    case Code::record_decimal_comma:
      return "数值以逗号作小数点";
    case Code::record_fullwidth:
      return "全角标点和全角数字已按 ASCII 字符读取";
    case Code::record_numbers_converted:
      return "{count:.0f} 行的数值含有全角数字、Unicode 负号或空格，或 Fortran 式指数（1.5D+00），"
             "已按通常写法读取：第 {lines} 行";
    case Code::record_times_converted:
      return "t 列的时刻或日期已换算为自首行起的秒数";
    case Code::record_labels_with_mark:
      return "{count:.0f} 个以 # 开头的行具有一行数据应有的数值，已作为数据行读取：第 {lines} 行";
    case Code::record_comments_skipped:
      return "已跳过数据之间的 {count:.0f} 个注释行：第 {lines} 行";
    case Code::record_empty_rows_skipped:
      return "已跳过 {count:.0f} 个字段全空的行：第 {lines} 行";
    case Code::record_headers_skipped:
      return "已跳过 {count:.0f} 个重复的表头：第 {lines} 行";
    case Code::record_overloads_left_out:
      return "{count:.0f} 行因仪表标明数值超量程而未采用：第 {lines} 行";
    case Code::record_column_unusable:
      return "未使用 {column} 列：{total:.0f} 行中有 {count:.0f} 行在该列没有数值";
    case Code::record_columns_ignored:
      return "文件中有 {count:.0f} 列未使用：{columns}";
    case Code::record_end_mark:
      return "已略去文件末尾的 Ctrl-Z 字符";
    case Code::inputs_collinear:
      return "输入共线（病态）：方差膨胀因子大于 {limit:g}（{inflated}）。这些系数的标准误差偏大；"
             "增加安装位置可使其减小";
    case Code::terms_apart_by_rounding:
      return "设计矩阵的某些列仅相差其自身大小的 {separation:.0e}。若记录的输入修约得同样粗略，"
             "则这些项只靠修约误差相区分，其值没有意义";
    case Code::rounding_costs_digits:
      return "各列归一化后的条件数为 {condition:.1e}：舍入误差约使 16 位有效数字损失 {digits:.0f} 位";
    case Code::white_noise_assumed:
      return "标准误差假定输入准确，输出噪声为白噪声且各行方差相同";
    case Code::errors_by_rows:
      return "标准误差由逐行剔除时系数的变化求得（HC3）：适用于各行独立、方差任意的噪声，并假定输入准确";
    case Code::errors_by_mounts:
      return "标准误差由逐个剔除 {count:.0f} 个安装位置时系数的变化求得（CR3）："
             "适用于各安装位置之间独立的任何误差；区间的自由度为 {dof:.0f}";
    case Code::sigma_output_unused:
      return "未使用 sigma_E：{method} 对所有行赋予相同的权";
    case Code::test_error_larger:
      return "测试误差（{test:.3g} {unit}）为训练误差（{train:.3g} {unit}）的 {ratio:.3g} 倍："
             "模型不能推广到其他数据。应检查测试集与训练集是否包含相同的安装位置和加速度水平";
    case Code::left_out_exactly:
      return "全部数据行均参与拟合；留一法误差是以其余各行的拟合预测该行的误差（精确值）";
    case Code::left_out_in_one_step:
      return "全部数据行均参与拟合；留一法误差是以其余各行的拟合预测该行的误差（保持各行的权不变，"
             "由全部数据的拟合一步求得，因而略偏小）";
    case Code::rows_not_left_out:
      return "{total:.0f} 行中有 {count:.0f} 行不能留出：去掉该行后，其余各行不足以确定各系数";
    case Code::mounts_not_left_out:
      return "{total:.0f} 个安装位置中有 {count:.0f} 个不能留出：去掉该安装位置后，"
             "其余数据不足以确定各系数";
    case Code::weights_from_sigma:
      return "权取记录中的 1 / sigma_E²";
    case Code::weights_from_model:
      return "权由残差按约束极大似然法求得：sigma² = s0² + s1² |A|²，s0 = {s0:.5g} {unit}，"
             "s1 = {s1:.5g} {unit}/g，|A| 由 {axes} 计算";
    case Code::variance_does_not_grow:
      return "残差不随 |A| 增大，或各行的 |A| 相同：所有行的权相等，结果与 ols 相同";
    case Code::scaling_unused:
      return "标准误差未按 chi²/dof 缩放：权来自残差而不是 sigma_E，此时 chi² 必然等于自由度";
    case Code::sigma_output_taken:
      return "chi²/dof 为 {ratio:.5g}（sigma_E 正确时约为 1 ± {spread:.2g}）；标准误差直接采用 sigma_E；"
             "若按 chi²/dof 缩放，将为现值的 {factor:.5g} 倍";
    case Code::sigma_output_scaled:
      return "chi²/dof 为 {ratio:.5g}（sigma_E 正确时约为 1 ± {spread:.2g}）；标准误差已按其缩放；"
             "若直接采用 sigma_E，将为现值的 {factor:.5g} 倍";
    case Code::sigma_output_too_small:
      return "残差超过 sigma_E 所允许的大小（chi²/dof 为 {ratio:.5g}）：sigma_E 偏小、模型缺项，"
             "或存在离群值。以 sigma_E 为依据的标准误差因而偏小";
    case Code::sigma_output_too_large:
      return "残差小于 sigma_E 所示的大小（chi²/dof 为 {ratio:.5g}）：sigma_E 偏大，"
             "以其为依据的标准误差也偏大";
    case Code::rows_without_weight:
      return "{total:.0f} 行中有 {count:.0f} 行的 sigma_E 远大于其他行，实际上不起作用：不计入自由度";
    case Code::weighted_noise_assumed:
      return "标准误差假定输入准确，输出噪声相互独立且方差如所给；残差标准差由所有行等权计算";
    case Code::sigma_inputs_replaced:
      return "输入的不确定度采用所给的常数，不用记录中的各 sigma 列";
    case Code::sigma_output_replaced:
      return "输出的不确定度采用所给的常数，不用记录中的 sigma_E";
    case Code::uncertainties_taken:
      return "标准误差直接采用所给的不确定度；残差为由其预计的 {factor:.3g} 倍";
    case Code::uncertainties_scaled:
      return "标准误差只采用所给不确定度之间的比例，并乘以残差与其预计值之比 {factor:.3g}";
    case Code::total_least_squares_biased:
      return "总体最小二乘对幂次项和乘积项有偏：它假定各回归量的误差相互独立、均值为零且各行相同。"
             "偏差与输入噪声的平方成正比；eiv 没有这种偏差";
    case Code::independent_errors_assumed:
      return "标准误差假定输入和输出的误差在各行之间、各轴之间相互独立；多行共有的误差（半径、"
             "失准角、设备转速）未作修正";
    case Code::huber_loss:
      return "Huber 损失函数，k = {tuning:g}";
    case Code::bisquare_loss:
      return "Tukey 双权损失函数，c = {tuning:g}";
    case Code::student_loss:
      return "学生 t 分布的似然函数，自由度为 {tuning:.4g}（{origin}），尺度为 {scale:.5g} {unit}";
    case Code::outlying_rows:
      return "{total:.0f} 行中有 {count:.0f} 行超出 {limit:g} 倍稳健尺度；"
             "稳健尺度（残差绝对值的中位数 / 0.6745）为 {scale:.5g} {unit}";
    case Code::scale_at_resolution:
      return "输出落在间隔为 {step:.5g} {unit} 的格点上，"
             "半数以上的残差小于其修约误差（{rounding:.3g} {unit}，即间隔 / sqrt(12)）。"
             "稳健尺度按每个残差分布在一个间隔之内计算，否则相差一个间隔的行会被当作离群值";
    case Code::scale_at_rounding:
      return "半数以上的残差不超过舍入误差；稳健尺度取为 {scale:.2g} {unit}";
    case Code::scale_doubtful:
      return "稳健尺度不可信：它是最集中的半数残差所得尺度的 {over_shortest_half:.3g} 倍，"
             "而由 60 % 分位数所得为其 {quantile_ratio:.3g} 倍（拟合正常时两者都接近 1）。"
             "可能有近半数的行是离群值，或数据行分为两组：拟合结果、标准误差和可疑行列表都可能有误。"
             "应画出残差图，并拆分记录或剔除坏行";
    case Code::robust_errors_asymptotic:
      return "标准误差为渐近值（Huber 1981），前提是输入准确，输出噪声相互独立且各行服从同一对称分布；"
             "残差标准差完全计入离群值";
    case Code::terms_chosen:
      return "按{criterion}从 {total:.0f} 项中选出 {count:.0f} 项（均方根 {value:.6g} {unit}）：{terms}";
    case Code::choice_taken_as_given:
      return "系数由选定的项在全部训练行上作普通最小二乘得到。其标准误差视选项为既定，"
             "未计入选项本身的不确定度：未选入的系数只是较小，并非已知为零";
    case Code::layers_grown:
      return "由 {inputs:.0f} 个输入构成的二次神经元网络，取第 {layer:.0f} 层的最优者，"
             "按{criterion}选定（均方根 {value:.6g} {unit}）";
    case Code::layers_expanded:
      return "在训练行上，网络的均方根误差为 {network:.4g} {unit}，"
             "其按模型项的展开式（用于预测）为 {expansion:.4g} {unit}";
    case Code::layers_beyond_terms:
      return "网络在 21 个模型项以外的部分为 {beyond_all:.4g} {unit}（训练行上的均方根），"
             "在所要求的项以外的部分为 {beyond_asked:.4g} {unit}";
    case Code::layers_without_errors:
      return "二次网络的系数没有标准误差；combi 形式的系数有";
    case Code::layers_short_of_optimum:
      return "展开式在训练行上的均方根误差为同样各项最小二乘的 {ratio:.3g} 倍，其系数也相应较差。"
             "宜改用 ols 或 combi 形式";
    case Code::pairs_discarded:
      return "{count:.0f} 对输入没有生成神经元，因为数据行不能区分其六个回归量；"
             "{total:.0f} 对生成了神经元";
    case Code::search_short_of_optimum:
      return "搜索终止时 {terms} 与最小二乘解相差 {distance:.2g} 倍标准误差（相差最大的系数），"
             "均方根残差为最小二乘的 {ratio:.6g} 倍；ols 可直接得到最小二乘解";
    case Code::search_errors_added:
      return "标准误差由最小二乘的标准误差（输入准确，"
             "输出噪声为白噪声且各行方差相同）与到最小二乘解的距离按方和根合成；搜索本身不给出标准误差";
    case Code::coefficients_projected:
      return "系数是网络在模型项上的最小二乘投影";
    case Code::coefficients_expanded:
      return "系数是网络在零比力处的泰勒展开：没有标准误差，三阶项远不如投影可靠";
    case Code::expansion_differs:
      return "泰勒展开与投影之差超过三倍标准误差的项：{terms}";
    case Code::network_misfit:
      return "网络的残差标准差为最小二乘（取数据行能区分的全部模型项）的 {ratio:.3g} 倍："
             "这是失拟而不是白噪声，因此标准误差、置信区间、t 和 p 均不成立。应增加隐层单元或起点，"
             "或改用最小二乘";
    case Code::network_above_rounding:
      return "取数据行能区分的全部模型项作最小二乘，只剩舍入误差，而网络的残差大于舍入误差："
             "这是失拟而不是白噪声，因此标准误差、置信区间、t 和 p 均不成立";
    case Code::network_moves_coefficients:
      return "网络的失拟使系数改变 {induced:.3g} {unit}（各行的均方根），"
             "大于噪声的影响（{typical:.3g} "
             "{unit}）：标准误差已计入该差值。增加隐含层节点数或使用最小二乘更为准确";
    case Code::network_errors_compared:
      return "标准误差由同一数据行、相同模型项的最小二乘标准误差与两者系数之差合成："
             "该差值反映网络不能描述的部分；假定输入准确、白噪声方差相同";
    case Code::structure_beyond_terms:
      return "记录中含有所要求的模型项不能描述的规律，来自传感器或试验设备，由与模型项并列的网络预测。"
             "系数是模型项与网络之和在记录各行上对模型项的最小二乘投影；在这些行之间，"
             "输出可能不同于仅由系数算得的值";
    case Code::hidden_choice_ignored:
      return "标准误差假定输入准确、白噪声方差相同；未计入隐层单元数由同一批数据行选定的影响";
    case Code::inputs_in_other_unit:
    case Code::inputs_are_angles:
    case Code::inputs_too_large:
    case Code::output_far_off:
    case Code::sigma_output_far_off:
    case Code::square_larger:
    case Code::input_far_off:
    case Code::magnitude_unlike_others:
    case Code::rows_shifted:
    case Code::output_unsigned:
    case Code::output_copies_input:
    case Code::output_clipped:
    case Code::output_saturated:
    case Code::output_held:
    case Code::output_stuck:
    case Code::output_repeated:
    case Code::output_wrapped:
    case Code::rows_duplicated:
    case Code::time_backwards:
    case Code::time_standing:
    case Code::temperature_implausible:
    case Code::scale_factor_negative:
    case Code::scale_factor_unlike_one:
    case Code::cross_axis_larger:
    case Code::cross_axis_large:
    case Code::few_degrees_of_freedom:
    case Code::gross_misfit:
    case Code::rows_far_off:
    case Code::model_too_short:
    case Code::residuals_follow_time:
    case Code::residuals_follow_temperature:
    case Code::residuals_follow_order:
    case Code::residuals_follow_mount:
    case Code::residuals_follow_inputs:
    case Code::scale_factor_follows_time:
    case Code::scale_factor_follows_temperature:
    case Code::scale_factor_follows_order:
    case Code::scale_factor_follows_mount:
    case Code::alignment_follows_mount:
    case Code::residuals_correlated:
    case Code::sigma_inputs_unused:
    case Code::sigma_output_uneven:
      return chinese_diagnosis(code);
    case Code::inputs_outside_range:
      return "{total:.0f} 行中有 {count:.0f} 行超出辨识时的输入范围（首处为第 {line:.0f} 行）："
             "这些行的预测属于外推";
    case Code::other_plan_named:
      return "记录注明由 {named} 仿真得到，而所给真值为 {plan}：与真值的偏差可能没有意义。"
             "应给出该记录自己的仿真计划";
    case Code::inputs_unlike_plan:
      return "记录的加速度为 {least:.4g} 至 {largest:.4g} g，"
             "真值所属计划的加速度为 {from:.4g} 至 {to:.4g} g";
    case Code::outputs_unlike_plan:
      return "记录的输出与真值之差为其噪声所能解释的 {ratio:.3g} 倍（取各行的中位数）："
             "真值可能属于另一记录，与真值的偏差因而没有意义。应给出仿真该记录所用的计划";
  }
  return "";
}

std::string_view chinese_scale_of_few_rows() noexcept {
  return "数据行仅比项数多 {spare:.0f}，稳健尺度难以检验：若离群行较多，拟合结果、"
         "标准误差和可疑行列表都可能有误而没有警告。数据行数至少应比项数多 {enough:.0f}";
}

std::string_view chinese_phrase(std::string_view figure, std::string_view word) noexcept {
  if (figure == "criterion") {
    if (word == "press") return " PRESS 准则（{rows:.0f} 行）";
    if (word == "regularity") return "正则性准则（{rows:.0f} 行中的 {second:.0f} 行用于检验）";
    if (word == "unbiasedness") return "无偏性准则（分为 {first:.0f} 行和 {second:.0f} 行两半）";
  }
  if (figure == "origin") {
    if (word == "given") return "给定";
    if (word == "default") return "默认";
    if (word == "estimated") return "估计";
  }
  return chinese_diagnosis_phrase(figure, word);
}

std::string chinese(const Finding& finding) {
  const bool few_rows = finding.code == Code::scale_doubtful && has_figure(finding, "spare");
  const std::string_view words = few_rows ? chinese_scale_of_few_rows() : chinese_template(finding.code);
  if (!words.empty()) return filled(words, finding, chinese_phrase, Language::zh);
  std::string text = join_names({finding.terms.begin(), finding.terms.begin() + !finding.terms.empty()}) +
                     " 不可辨识：" + chinese_reason(finding);
  const bool aliased = finding.code == Code::term_aliased || finding.code == Code::term_hidden_by_rounding ||
                       finding.code == Code::term_hidden_by_uncertainty;
  if (!aliased || finding.terms.size() < 2) return text;
  return text + "；其影响全部计入 " +
         listed_names({finding.terms.begin() + 1, finding.terms.end()}, Language::zh) + " 的值";
}

}  // namespace proofmass
