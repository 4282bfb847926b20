/// Names of procedures that the control has and this run does not execute.
#pragma once

#include <string_view>

namespace siemens {

/// Cycles of the control that are not executed here.
bool is_foreign_cycle(std::string_view name);

/// E_DR(…), E_MI_PL(…), E_PS_CIR(…): what a work step of ShopMill drills and mills, and where.
bool is_shopmill_step(std::string_view name);

/// What is missing of a procedure that changes the path; empty: the name is none of these.
std::string_view not_executed(std::string_view name);

}  // namespace siemens
