#pragma once

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

/// Returns what is blocked in the regions that were made of the search, by vertices and bodies instead of
/// rows: a pair, or else the row of the cloth that contact moved furthest from where it was expected.
BlockedContact blocked_contact(const Searched& searched, const Regions& regions);

/// Returns the same of a row of the cloth that is further away than can be searched.
BlockedContact blocked_contact(const Searched& searched, std::size_t row);

}  // namespace taut::sim::bounded
