// SPDX-License-Identifier: Apache-2.0
// Objects and their modifiers (POV-Ray reference, section 3.4.5 "Object").
#pragma once

#include <map>
#include <memory>

#include "import/pov/build_context.h"
#include "import/pov/build_items.h"
#include "import/pov/build_node.h"
#include "import/pov/build_texture.h"

namespace sundog::pov {

/// True for keywords of blocks that are objects: shapes, groups, lights, object itself.
bool is_object(Keyword keyword);

/// Reads object blocks, each declared one only once.
class ObjectReader {
public:
    ObjectReader(BuildContext& context, TextureReader& textures) : context_(context), textures_(textures) {}

    /// The object of a block. Errors: InputError.
    NodePointer read(const std::shared_ptr<const Block>& block);
    Node read(const Block& block);

    [[nodiscard]] BuildContext& context() const { return context_; }
    [[nodiscard]] TextureReader& textures() const { return textures_; }

private:
    BuildContext& context_;
    TextureReader& textures_;
    using WeakBlock = std::weak_ptr<const Block>;
    std::map<WeakBlock, NodePointer, std::owner_less<WeakBlock>> read_before_;
};

/// The objects among the items that follow, up to the first item that is none.
std::vector<NodePointer> read_children(ObjectReader& objects, ItemReader& items);

}  // namespace sundog::pov
