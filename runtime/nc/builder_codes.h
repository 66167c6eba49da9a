// builder_codes.h — M functions that mean what the machine's builder has made of them, by their
// numbers: a form for each would be hundreds in every dialect.
#pragma once

#include "nc/tables.h"

namespace kadr::nc {

/// Whether the code is machine_function by its number alone: one of `builder_codes` that neither a
/// form nor a call of the dialect has. So it is written and read.
bool is_builder_code(const DialectTables& tables, AddressId address, double number);

/// Whether a text may have it: the control passes on what it does not have itself, up to
/// `most_builder_code`; also a low one that it leaves free, `M6` of a lathe.
bool is_passed_to_builder(const DialectTables& tables, AddressId address, double number);

/// The one form with which all of them are written.
void add_builder_form(DialectTables& tables);

}  // namespace kadr::nc
