#pragma once

// Whole numbers of any length, where GMP is not to be had.

#include <boost/multiprecision/cpp_int.hpp>

using mpz_class =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

inline int sgn(const mpz_class& number) { return number.sign(); }
