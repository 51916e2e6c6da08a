#pragma once

#include <span>

#include "sim/blocked_contact.hpp"
#include "sim/solvers/bounded/contact/body_contacts.hpp"
#include "sim/solvers/bounded/contact/regions.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim::bounded {

/// One search of what is near, as it is after it.
struct Searched {
  const Layout& layout;
  const BodyContacts& bodies;
  const RowMoves& rows;
  std::span<const ContactPair> pairs;
  Vec3 origin_m;  ///< of the rows' positions
};

/// Returns the pair, which must be among the pairs of the search, by vertices and bodies instead of rows.
BlockedContact blocked_contact(const Searched& searched, const BlockedPair& pair);

/// Returns the same of a row of the cloth that goes further than was searched.
BlockedContact blocked_contact(const Searched& searched, std::size_t row);

}  // namespace taut::sim::bounded
