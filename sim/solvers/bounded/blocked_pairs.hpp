#pragma once

#include "sim/blocked_contact.hpp"
#include "sim/solvers/bounded/contact/body_contacts.hpp"
#include "sim/solvers/bounded/contact/regions.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim::bounded {

/// State after a search for near pairs.
struct Searched {
  const Layout& layout;
  const BodyContacts& bodies;
  const RowMoves& rows;
  std::span<const ContactPair> pairs;
  Vec3 origin_m;  ///< origin of the positions
};

/// Returns the blocked contact of a vertex beyond the searchable distance.
BlockedContact blocked_contact(const Searched& searched, std::size_t row);

/// Returns the blocked contact of regions, by vertices and bodies: the blocked pair, or else the cloth vertex that
/// contact moved furthest from its prediction.
BlockedContact blocked_contact(const Searched& searched, const Regions& regions);

}  // namespace taut::sim::bounded
