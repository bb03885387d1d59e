// SPDX-License-Identifier: Apache-2.0
// The columns of a record, shared by the reader and the writer.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proofmass/core/dataset.hpp"

namespace proofmass {

enum class Column { Ai, Ao, Ap, E, sigma_E, sigma_Ai, sigma_Ao, sigma_Ap, mount, T, t };

inline constexpr std::array kColumns{Column::Ai,      Column::Ao,       Column::Ap,       Column::E,
                                     Column::sigma_E, Column::sigma_Ai, Column::sigma_Ao, Column::sigma_Ap,
                                     Column::mount,   Column::T,        Column::t};

[[nodiscard]] std::string_view column_name(Column column) noexcept;
[[nodiscard]] std::optional<Column> find_column(std::string_view name) noexcept;

// The column whose standard uncertainty this column holds: E for sigma_E.
[[nodiscard]] std::optional<Column> measured_by(Column sigma) noexcept;

// The numbers of a column in a data set. Not for mount, which holds text.
[[nodiscard]] std::vector<double>& numbers(Dataset& record, Column column);
[[nodiscard]] const std::vector<double>& numbers(const Dataset& record, Column column);

// The unit that the record declares for a column. A sigma column has the unit of its quantity.
[[nodiscard]] Unit& unit_of(Dataset& record, Column column);
[[nodiscard]] const Unit& unit_of(const Dataset& record, Column column);

}  // namespace proofmass
