#pragma once

#include "app/base/errors.hpp"
#include "app/library/taut.h"
#include "app/models/garment_import.hpp"

namespace taut::library {

/// An argument of a call cannot be used.
struct ArgumentError : app::Formatted<std::invalid_argument> {
  using Formatted::Formatted;
};

/// Throws ArgumentError with the message, unless it holds.
void require(bool holds, const char* message);
/// The same unless the array is there, of the length expected.
void require_room(const void* array, std::size_t found, std::size_t expected);
/// Returns the text. Throws ArgumentError with the message on null.
std::string text_of(const char* text, const char* message);

/// Returns the points as doubles, `expected` of them. Throws ArgumentError on null, on another count, type or
/// stride, and on numbers that are not finite.
std::vector<sim::Vec3> points_from(const TautPoints* points, std::size_t expected);
/// The same for as many as there are; more than can be simulated are refused.
std::vector<sim::Vec3> points_from(const TautPoints* points);

/// Fills an array with the points. Throws ArgumentError as points_from() does.
void put_points(std::span<const sim::Vec3> points, const TautPointsOut* out);

/// Fills in the size, and the bytes where there is a buffer. Throws ArgumentError if they do not fit.
void put_bytes(std::string_view bytes, char* buffer, std::size_t capacity, std::size_t* size);

/// Returns the vector. Throws ArgumentError if a number is not finite.
sim::Vec3 vector_of(double x, double y, double z);

/// Returns the numbers, each below `limit`. Throws ArgumentError.
std::vector<sim::Index> vertices_from(const std::uint32_t* vertices, std::size_t count, std::size_t limit);

/// Returns the mesh as one that is read from a file, cut into triangles but not repaired. Throws
/// ArgumentError on arrays that cannot be used.
app::ImportedModel model_from(const TautMesh* mesh);

}  // namespace taut::library
