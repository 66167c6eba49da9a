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

    void choose_carrier(const nc::Block& block, const nc::Invocation& invocation, Actions& actions);
    bool takes_carrier(const nc::Block& block, const Actions& actions) const;
    void take_carrier(const nc::Block& block);
    void lay_on_carrier();
    void end_carrier();
    bool leave_carrier();
    Done require_no_carrier(const nc::Block& block, nc::Function function);
    bool is_turned_by_carrier() const;
    bool is_plane_on_carrier() const;
    std::optional<double> carrier_quantity(nc::Quantity quantity, std::int64_t first,
                                           std::int64_t second) const;
    ControlAccess::Write set_carrier(nc::Quantity quantity, std::int64_t first, std::int64_t second,
                                     double value);
    std::optional<std::string> carrier_text(nc::Quantity quantity, std::int64_t number) const;
    ControlAccess::Write set_carrier_text(nc::Quantity quantity, std::int64_t number,
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
