// SPDX-License-Identifier: Apache-2.0
// Evaluated blocks as text again.
#pragma once

#include <string>

#include "import/pov/entity.h"
#include "import/pov/interpreter.h"

namespace sundog::pov {

/// A sink that prints what it gets as normalised POV-Ray language: no directives but #version, #default and the
/// functions used, every identifier replaced by what it stands for. interpret() reads the same blocks from it. Blocks
/// in which identifiers stood come as a block within a block, which POV-Ray itself knows for objects only.
class FormattingSink : public BlockSink {
public:
    /// Appends to `text`.
    explicit FormattingSink(std::string& text) : text_(text) {}
    void add(Block&& block) override;

private:
    std::string& text_;
    std::uint16_t version_ = 0;
    std::shared_ptr<const Block> defaults_;
    std::vector<std::shared_ptr<const FunctionExpression>> functions_;  ///< Those printed, named Function_0 and on.
};

}  // namespace sundog::pov
