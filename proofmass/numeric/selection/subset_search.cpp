// SPDX-License-Identifier: Apache-2.0
#include "proofmass/numeric/selection/subset_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "proofmass/numeric/parallel.hpp"

namespace proofmass {
namespace {

// A small number, because one value may take long when there are many rows.
constexpr std::size_t kReportEvery = 16;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr Subset bit(std::size_t k) { return Subset{1} << k; }

struct Ranked {
  double value = kInfinity;
  Subset subset = 0;
  bool operator<(const Ranked& other) const {
    return std::pair(value, subset) < std::pair(other.value, other.subset);
  }
};

class Explorer {
 public:
  Explorer(const SubsetCriterion& criterion, const SubsetSearchSettings& settings,
           const SubsetSearchObserver& observer)
      : criterion_(criterion), settings_(settings), observer_(observer), best_of_size_(criterion.columns()) {}

  void search_backwards();
  void search_all();
  [[nodiscard]] SubsetSearchResult result() const;

 private:
  [[nodiscard]] Subset all() const {
    return static_cast<Subset>((std::uint64_t{1} << criterion_.columns()) - 1);
  }
  [[nodiscard]] double compute(Subset subset) const {
    const double value = criterion_.value(subset);
    return std::isnan(value) ? kInfinity : std::max(value, settings_.floor);
  }
  void record(Subset subset, double value);
  // Whether every subset with at least this many columns can at best equal one found with fewer: values at
  // the floor cannot be improved.
  [[nodiscard]] bool pointless(std::size_t columns) const;
  void compute_all(const std::vector<Subset>& subsets);
  // Visits the proper subsets of `top` that contain all of the first `fixed` columns of order_.
  void descend(Subset top, std::size_t fixed);
  [[nodiscard]] bool may_hold_better(Subset top) const {
    return criterion_.bound(top) <= least_ * (1.0 + settings_.tolerance);
  }

  const SubsetCriterion& criterion_;
  const SubsetSearchSettings& settings_;
  const SubsetSearchObserver& observer_;
  std::vector<Ranked> best_of_size_;
  std::unordered_map<Subset, double> known_;
  std::vector<std::size_t> order_;
  double least_ = kInfinity;
  std::size_t exhaustive_evaluations_ = 0;
  bool ended_ = false;
  bool proven_ = false;
};

void Explorer::record(Subset subset, double value) {
  known_.emplace(subset, value);
  Ranked& best = best_of_size_[static_cast<std::size_t>(__builtin_popcount(subset)) - 1];
  best = std::min(best, Ranked{value, subset});
  least_ = std::min(least_, value);
  if (observer_ && known_.size() % kReportEvery == 0 && !observer_(known_.size())) ended_ = true;
}

bool Explorer::pointless(std::size_t columns) const {
  if (!(least_ <= settings_.floor)) return false;
  for (std::size_t size = 1; size <= columns; ++size) {
    if (best_of_size_[size - 1].value <= settings_.floor) return true;
  }
  return false;
}

void Explorer::compute_all(const std::vector<Subset>& subsets) {
  for (std::size_t first = 0; first < subsets.size() && !ended_; first += kReportEvery) {
    std::vector<double> values(std::min(kReportEvery, subsets.size() - first));
    parallel_for(values.size(), [&](std::size_t k) { values[k] = compute(subsets[first + k]); });
    for (std::size_t k = 0; k < values.size(); ++k) record(subsets[first + k], values[k]);
  }
}

void Explorer::search_backwards() {
  std::vector<Subset> level{all()};
  compute_all(level);
  for (std::size_t size = criterion_.columns() - 1; size > 0 && !ended_; --size) {
    std::vector<Subset> next;
    for (const Subset parent : level) {
      for (std::size_t k = 0; k < criterion_.columns(); ++k) {
        if ((parent & bit(k)) != 0) next.push_back(parent & ~bit(k));
      }
    }
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    compute_all(next);
    if (ended_) return;
    std::sort(next.begin(), next.end(), [this](Subset a, Subset b) {
      return Ranked{known_.at(a), a} < Ranked{known_.at(b), b};
    });
    next.resize(std::min(next.size(), std::max<std::size_t>(settings_.beam, 1)));
    level = std::move(next);
  }
}

void Explorer::search_all() {
  if (settings_.models == 0 || ended_) return;
  // The columns whose removal raises the criterion most come first: the branches without them are the largest
  // and end at once.
  order_.resize(criterion_.columns());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::vector<double> loss(order_.size(), kInfinity);
  for (const std::size_t k : order_) {
    const auto found = known_.find(all() & ~bit(k));
    if (found != known_.end()) loss[k] = found->second;
  }
  std::stable_sort(order_.begin(), order_.end(),
                   [&](std::size_t a, std::size_t b) { return loss[a] > loss[b]; });
  descend(all(), 0);
  proven_ = !ended_;
}

void Explorer::descend(Subset top, std::size_t fixed) {
  std::size_t kept = 0;  // columns that every subset visited from here on has
  for (std::size_t k = 0; k < fixed; ++k) kept += (top & bit(order_[k])) != 0 ? 1U : 0U;
  for (std::size_t k = fixed; k < order_.size() && !ended_; ++k) {
    const Subset child = top & ~bit(order_[k]);
    if (pointless(kept)) return;
    ++kept;  // from the next round on, column k stays
    if (child == 0 || !may_hold_better(child)) continue;
    if (!known_.contains(child)) {
      if (exhaustive_evaluations_ == settings_.models) ended_ = true;
      if (ended_) return;
      ++exhaustive_evaluations_;
      record(child, compute(child));
    }
    descend(child, k + 1);
  }
}

SubsetSearchResult Explorer::result() const {
  SubsetSearchResult result;
  result.least = least_;
  result.evaluations = known_.size();
  result.proven = proven_;
  for (const Ranked& best : best_of_size_) {
    result.value_of_size.push_back(best.value);
    if (result.best == 0 && best.value <= least_ * (1.0 + settings_.tolerance)) {
      result.best = best.subset;
      result.value = best.value;
    }
  }
  return result;
}

}  // namespace

SubsetSearchResult search_subsets(const SubsetCriterion& criterion, const SubsetSearchSettings& settings,
                                  const SubsetSearchObserver& observer) {
  if (criterion.columns() == 0) throw std::invalid_argument("a search needs columns to choose from");
  Explorer explorer(criterion, settings, observer);
  explorer.search_backwards();
  explorer.search_all();
  return explorer.result();
}

}  // namespace proofmass
