// sections.h — what a section of a program has to say by itself, so that an operator can start
// again at its tool.
//
// A section begins behind a tool change. What the program said before it and goes on with (a speed,
// its limit, a coordinate in the plane) is said once more in front of the first block that needs
// it, unless the section has said it until then.
//
// source       the operator's restart at a block: reset, then from this block on
#pragma once

#include <vector>

#include "write/modal.h"

namespace kadr::write {

class Sections {
  public:
    /// is_turret  whether a tool change leaves the spindle turning
    explicit Sections(bool is_turret) : is_turret_(is_turret) {}

    void begin_program() { *this = Sections(is_turret_); }
    void begin_section();
    /// The line has been written that says the work offset.
    void say_offset() { has_said_offset_ = true; }
    bool has_said_offset() const { return has_said_offset_; }
    /// Whether blocks have to be looked at.
    bool owes() const { return owes_speed_ || owes_limit_ || owes_position_ || has_said_offset_; }

    /// Completes the block by what the section lacks, and gives what has to stand in front of it.
    ///
    /// modal  what the text has written so far
    void complete(const WriterModal& modal, std::array<std::size_t, 3> plane, Block& block,
                  std::vector<Block>& before);
    /// Keeps what the block says; of every block.
    void follow(const Block& block);

  private:
    void complete_speed(const WriterModal& modal, Block& block, std::vector<Block>& before) const;
    void complete_position(const WriterModal& modal, std::array<std::size_t, 3> plane, Block& block,
                           std::vector<Block>& before) const;

    bool is_turret_;
    static void drop_offset(const WriterModal& modal, Block& block);

    NumberInForce limit_;  // of the speed, 1/min
    bool owes_speed_ = false;
    bool owes_limit_ = false;
    bool owes_position_ = false;
    bool has_said_offset_ = false;  // and nothing has been done since then that it could act on
};

}  // namespace kadr::write
