// carriers.h — tool carriers that are turned by hand or by a program.
#pragma once

#include "interp/channel_state.h"

namespace kadr::interp {

struct Channel;

/// Tool carriers that are turned by hand or by a program.
class Carriers {
  public:
    explicit Carriers(Channel& channel);
    Carriers(const Carriers&) = delete;
    Carriers& operator=(const Carriers&) = delete;

    /// TCARR, TCOABS, TCOFR: they act with the block.
    void choose_carrier(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    /// Whether the carrier has to be worked out anew: it, its angles, or a tool on it is
    /// programmed.
    bool takes_carrier(const nc::Block& block, const Actions& actions) const;
    /// The tool's lengths lie along the turned carrier.
    void take_carrier(const nc::Block& block);
    /// Frames lie on the carrier's table; no axis moves.
    void lay_on_carrier();
    /// No carrier acts.
    void end_carrier();
    /// The plane that is being swivelled to has its own: the lengths are those of the tool again.
    /// False: no carrier acted.
    bool leave_carrier();
    /// No transformation is switched on beside a carrier.
    Done require_no_carrier(const nc::Block& block, nc::Function function);
    /// Whether a carrier has turned the tool.
    bool is_turned_by_carrier() const;
    /// … and the working plane of the program is square to it.
    bool is_plane_on_carrier() const;
    /// A datum of a carrier by its variable; nothing: there is none.
    std::optional<double> carrier_quantity(nc::SystemQuantity quantity, std::int64_t first,
                                           std::int64_t second) const;
    /// What of a carrier that acts is written counts from its next call on. `$TC_CARR1[0]=0`
    /// forgets all carriers.
    ControlAccess::Write set_carrier(nc::SystemQuantity quantity, std::int64_t first,
                                     std::int64_t second, double value);
    /// The name of a carrier or of one of its axes.
    std::optional<std::string> carrier_text(nc::SystemQuantity quantity, std::int64_t number) const;
    /// Likewise.
    ControlAccess::Write set_carrier_text(nc::SystemQuantity quantity, std::int64_t number,
                                          std::string_view text);

  private:
    std::optional<Carrier> standing_carrier(const nc::Block& block, const CarrierData& data);

    Channel& channel_;
    const machine::Machine& machine_;
    Reporter& reporter_;
    const Modal& modal_;
    const Position& position_;
    control::Frames& frames_;
    ToolCarriers& carriers_;
    ActiveCarrier& carrier_;
    const Orienting& orienting_;
    const Tilting& tilted_plane_;
    const Virtual& virtual_;
    const RadiusCompState& comp_;
    const AxisData& axes_;
};

}  // namespace kadr::interp
