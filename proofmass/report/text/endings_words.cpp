// SPDX-License-Identifier: Apache-2.0
#include "proofmass/report/text/endings.hpp"

namespace proofmass {

Words ending_words(EndingCode code) noexcept {
  switch (code) {
    case EndingCode::verbatim:
      return {"{text}", "{text}"};
    case EndingCode::start_not_finite:
      return {"the sum of squares at the start is not finite", "起点处的平方和不是有限值"};
    case EndingCode::stopped_by_observer:
      return {"stopped by the observer", "由监视程序中止"};
    case EndingCode::stopped_on_request:
      return {"stopped on request", "应要求中止"};
    case EndingCode::distance_iterations_spent:
      return {
          "the {iterations:.0f} iterations allowed are spent, the last step was {length:.1e} standard "
          "deviations long",
          "允许的 {iterations:.0f} 次迭代已用完，最后一步的步长为标准差的 {length:.1e} 倍"};
    case EndingCode::distance_step_short:
      return {"the last step was {length:.1e} standard deviations long, at or below {limit:.1e}",
              "最后一步的步长为标准差的 {length:.1e} 倍，不超过限值 {limit:.1e}"};
    case EndingCode::distance_stands_still:
      return {
          "the sum of squares {sum:.6g} no longer falls, and the step that remains, {length:.1e} standard "
          "errors long, would lower it by {reduction:.1e} only",
          "平方和 {sum:.6g} 不再下降，剩余的一步（标准误差的 {length:.1e} 倍）只能使其再降低 "
          "{reduction:.1e}"};
    case EndingCode::distance_no_step:
      return {"no step reduces the sum of squares {sum:.6g} up to damping {damping:.1g}",
              "阻尼增至 {damping:.1g} 仍没有能使平方和 {sum:.6g} 下降的步"};
    case EndingCode::distance_runs_away:
      return {
          "the coefficients grow without end, together {significance:.1e} standard errors from zero, "
          "while the sum of squares tends to {sum:.6g}: the inputs are too uncertain to tell how the "
          "output depends on them",
          "各系数无限增大（合计偏离零 {significance:.1e} 倍标准误差），而平方和趋于 {sum:.6g}："
          "输入的不确定度过大，无法判断输出与输入的关系"};
    case EndingCode::distance_other_start:
      return {"start {start:.0f} of {total:.0f} gave this, the best result: the first start ended elsewhere",
              "此为 {total:.0f} 个起点中第 {start:.0f} 个得到的最好结果，第一个起点收敛到别处"};
    case EndingCode::distance_local_minimum:
      return {
          "this minimum is a local one: the sum of squares, {sum:.6g} here, tends to {beyond:.6g} where "
          "the coefficients grow without end",
          "此极小值是局部极小：此处平方和为 {sum:.6g}，而在系数无限增大的方向上趋于 {beyond:.6g}"};
    case EndingCode::reweighting_converged:
      return {
          "converged after {count:.0f} reweightings: the last moved no fitted value by more than "
          "{step:.1e} of the scale",
          "经 {count:.0f} 次重新加权收敛：最后一次加权使拟合值的变化不超过尺度的 {step:.1e} 倍"};
    case EndingCode::reweighting_spent:
      return {
          "stopped at the limit of iterations after {count:.0f} reweightings: the last moved no fitted "
          "value by more than {step:.1e} of the scale",
          "经 {count:.0f} 次重新加权后达到迭代上限：最后一次加权使拟合值的变化不超过尺度的 {step:.1e} 倍"};
    case EndingCode::variance_converged:
      return {
          "converged after {count:.0f} rounds: the growing fraction of the variance is {fraction:.6g} "
          "and moved by {step:.1e}",
          "经 {count:.0f} 轮收敛：方差中随加速度增大的部分占 {fraction:.6g}，最后一轮变化 {step:.1e}"};
    case EndingCode::variance_spent:
      return {
          "stopped at the limit of rounds after {count:.0f} rounds: the growing fraction of the variance "
          "is {fraction:.6g} and moved by {step:.1e}",
          "经 {count:.0f} 轮后达到轮数上限：方差中随加速度增大的部分占 {fraction:.6g}，"
          "最后一轮变化 {step:.1e}"};
    case EndingCode::swarm_at_target:
      return {"best value {value:.6g} is at or below the target {target:.6g}",
              "最优值 {value:.6g} 已不高于目标值 {target:.6g}"};
    case EndingCode::swarm_stalled:
      return {"no better value in {iterations:.0f} iterations", "连续 {iterations:.0f} 次迭代未得到更优值"};
    case EndingCode::swarm_spent:
      return {"all {iterations:.0f} iterations spent", "{iterations:.0f} 次迭代已全部用完"};
    case EndingCode::descent_at_target:
      return {"sum of squares {sum:.6g} is at or below the target {target:.6g}",
              "平方和 {sum:.6g} 已不高于目标值 {target:.6g}"};
    case EndingCode::descent_stalled:
      return {"less than {reduction:.1g} relative reduction over {epochs:.0f} epochs",
              "{epochs:.0f} 个轮次内的相对下降量小于 {reduction:.1g}"};
    case EndingCode::descent_no_step:
      return {"no step reduces the sum of squares up to damping {damping:.3g}",
              "阻尼增至 {damping:.3g} 仍没有能使平方和下降的步"};
    case EndingCode::descent_polished:
      return {"polished by {steps:.0f} Gauss-Newton steps", "再以 {steps:.0f} 步高斯—牛顿法精修"};
    case EndingCode::epochs_spent:
      return {"the epochs allowed are spent", "允许的训练轮次已用完"};
    case EndingCode::gradient_small:
      return {"gradient {gradient:.3g} is at or below {limit:.3g}",
              "梯度 {gradient:.3g} 已不大于限值 {limit:.3g}"};
    case EndingCode::residuals_orthogonal:
      return {"no column of the Jacobian has a cosine above {limit:.3g} with the residuals",
              "雅可比矩阵各列与残差夹角的余弦均不大于 {limit:.3g}"};
    case EndingCode::weights_perturbed:
      return {"{count:.0f} perturbations, the last {idle:.0f} without gain",
              "共扰动 {count:.0f} 次，最后 {idle:.0f} 次没有改善"};
    case EndingCode::validation_stalled:
      return {"validation error did not improve in {epochs:.0f} {epochs:?epoch|epochs}",
              "验证误差连续 {epochs:.0f} 个轮次没有改善"};
    case EndingCode::layers_stalled:
      return {
          "layer {layer:.0f} lowers the criterion from {before:.4g} to {after:.4g}, less than the "
          "{percent:g} % asked for",
          "第 {layer:.0f} 层使准则由 {before:.4g} 降至 {after:.4g}，低于要求的 {percent:g} %"};
    case EndingCode::layers_spent:
      return {"all {layers:.0f} layers are grown", "允许的 {layers:.0f} 层已全部生成"};
    case EndingCode::layers_without_pair:
      return {"no pair of layer {layer:.0f} could be fitted", "第 {layer:.0f} 层没有可拟合的输入对"};
    case EndingCode::normal_equations:
      return {
          "solved directly by normal equations in twice the working precision: {rows:.0f} rows, "
          "{count:.0f} {count:?coefficient|coefficients}",
          "由双倍工作精度的正规方程直接求解：{rows:.0f} 行数据、{count:.0f} 个系数"};
    case EndingCode::weighted_normal_equations:
      return {
          "solved directly by normal equations in twice the working precision: {rows:.0f} weighted rows, "
          "{count:.0f} {count:?coefficient|coefficients}",
          "由双倍工作精度的正规方程直接求解：{rows:.0f} 行加权数据、{count:.0f} 个系数"};
    case EndingCode::singular_values:
      return {
          "solved directly by QR and SVD: {rows:.0f} rows, {count:.0f} {count:?coefficient|coefficients}, "
          "gap of the singular values {gap:.3g}",
          "由 QR 分解和奇异值分解直接求解：{rows:.0f} 行数据、{count:.0f} 个系数，奇异值间隔 {gap:.3g}"};
    case EndingCode::after_iterations:
      return {"after {iterations:.0f} {iterations:?iteration|iterations} {parts}",
              "经 {iterations:.0f} 次迭代：{parts}"};
    case EndingCode::subsets_searched:
      return {"{count:.0f} models computed of the {total:.0f} there are",
              "在全部 {total:.0f} 个模型中计算了 {count:.0f} 个"};
    case EndingCode::subsets_proven:
      return {"the bound rules out that any other is better", "由界可知其余模型都不会更优"};
    case EndingCode::subsets_not_proven:
      return {"a better one may exist, for the search was not exhaustive",
              "未作穷举搜索，可能存在更优的模型"};
    case EndingCode::fish_swarm:
      return {"fish swarm: {parts}", "鱼群：{parts}"};
    case EndingCode::evaluations:
      return {"{count:.0f} evaluations", "共计算目标函数 {count:.0f} 次"};
    case EndingCode::particle_swarm:
      return {"swarm: {parts}", "粒子群：{parts}"};
    case EndingCode::training:
      return {"training: {parts}", "训练：{parts}"};
    case EndingCode::nothing_left:
      return {"nothing is left to gain: {parts}", "已无改善余地：{parts}"};
    case EndingCode::best_candidate:
      return {
          "{parts} ({epochs:.0f} {epochs:?epoch|epochs} of the best of {candidates:.0f} "
          "{candidates:?candidate|candidates})",
          "{parts}（{candidates:.0f} 个候选网络中最优者，训练 {epochs:.0f} 个轮次）"};
    case EndingCode::sizes_compared:
      return {
          "the Bayesian information criterion, less that without a network: {list}; it is least with "
          "{chosen:.0f} {chosen:?hidden unit|hidden units}",
          "贝叶斯信息准则与无网络时之差：{list}；隐层单元为 {chosen:.0f} 个时最小"};
    case EndingCode::sizes_compared_to_limit:
      return {
          "the Bayesian information criterion, less that without a network: {list}; it is least with "
          "{chosen:.0f} {chosen:?hidden unit|hidden units}, the most allowed, and more might lower it "
          "further",
          "贝叶斯信息准则与无网络时之差：{list}；隐层单元为 {chosen:.0f} 个时最小，"
          "这已是允许的最多个数，再增加单元可能更小"};
    case EndingCode::size_compared:
      return {"{units:.0f} {units:?unit|units} {difference:.1f}", "{units:.0f} 个单元时 {difference:.1f}"};
    case EndingCode::network_kept:
      return {"cross-validation keeps the network: rms error at rows left out {ratio:.5g} times that without",
              "经交叉验证保留网络：留出各行的均方根误差为无网络时的 {ratio:.5g} 倍"};
    case EndingCode::network_dropped:
      return {"cross-validation drops the network: rms error at rows left out {ratio:.5g} times that without",
              "经交叉验证舍弃网络：留出各行的均方根误差为无网络时的 {ratio:.5g} 倍"};
    case EndingCode::network_not_judged:
      return {"the network is dropped: too few rows for a cross-validation",
              "数据行数不足以作交叉验证，舍弃网络"};
    case EndingCode::sizes_unfinished:
      return {
          "training used all of its {epochs:.0f} {epochs:?epoch|epochs} with {sizes} hidden "
          "{units:?unit|units}",
          "隐层单元为 {sizes} 个时，训练用完了全部 {epochs:.0f} 个轮次"};
    case EndingCode::units_suffice:
      return {
          "{units:.0f} hidden {units:?unit|units}: the residual is {ratio:.3f} times that of least squares",
          "隐层单元 {units:.0f} 个：残差为最小二乘的 {ratio:.3f} 倍"};
    case EndingCode::units_added:
      return {
          "{units:.0f} hidden units: with {from:.0f} the residual was {before:.3f} times that of least "
          "squares, with {units:.0f} it is {after:.3f} "
          "times",
          "隐层单元 {units:.0f} 个：{from:.0f} 个时残差为最小二乘的 {before:.3f} "
          "倍，{units:.0f} 个时为 "
          "{after:.3f} 倍"};
    case EndingCode::units_in_vain:
      return {
          "{from:.0f} hidden {from:?unit|units}: the residual is {before:.3f} times that of least squares, "
          "and with {units:.0f} it is no less",
          "隐层单元 {from:.0f} 个：残差为最小二乘的 {before:.3f} 倍，增至 {units:.0f} 个亦不减小"};
  }
  return {};
}

}  // namespace proofmass
