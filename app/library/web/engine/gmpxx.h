#pragma once

// Replaces GMP's rational numbers of any length.

#include <boost/multiprecision/cpp_int.hpp>

using mpq_class =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

inline int sgn(const mpq_class& number) { return number.sign(); }
