// names.h — the names of blocks and dialects that this room uses on every page.
#pragma once

#include "nc/block.h"
#include "nc/dialect.h"
#include "nc/effects.h"
#include "nc/modal_functions.h"
#include "nc/number_text.h"
#include "nc/parameters.h"
#include "nc/program_lines.h"
#include "nc/quoted.h"
#include "nc/tables.h"

namespace kadr::write {

// Blocks
using nc::bit;
using nc::Block;
using nc::Invocation;
using nc::is_arc;
using nc::kArcSlots;
using nc::kCenterSlots;
using nc::kMaxArguments;
using nc::kMaxInvocations;
using nc::kReadSlots;
using nc::kSlots;
using nc::kTargetSlots;
using nc::programmed_in;
using nc::Slot;
using nc::slot_name;
using nc::SlotMask;

// What functions are
using nc::Dimension;
using nc::Effect;
using nc::EffectKind;
using nc::Fact;
using nc::FrameChange;
using nc::Function;
using nc::Group;
using nc::has_fact;
using nc::info;
using nc::kGroups;
using nc::ModalFunctions;
using nc::Parameter;
using nc::parameter_of;
using nc::quoted;

// Dialects
using nc::Address;
using nc::AddressId;
using nc::ArcError;
using nc::BlockNumbers;
using nc::CodeStart;
using nc::Constraint;
using nc::Deferred;
using nc::Dialect;
using nc::DialectTables;
using nc::Example;
using nc::Form;
using nc::FormId;
using nc::FormWord;
using nc::IncrementalFrame;
using nc::kNoAddress;
using nc::kNoForm;
using nc::LengthAxis;
using nc::PointRule;
using nc::ProgramInfo;
using nc::Refusal;
using nc::Rules;

// Numbers
using nc::append_number;
using nc::NumberFault;
using nc::NumberFormat;
using nc::quantity_words;
using nc::text_decimals;
using nc::text_scale;
using nc::TextUnits;

}  // namespace kadr::write
