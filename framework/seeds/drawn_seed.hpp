// SPDX-License-Identifier: MIT
// Seeds of random cases that only the owner of a secret can know.
//
//     key  = HMAC(secret, submission)
//     seed = HMAC(key, name of the test)
//
// HMAC uses SHA-256 (RFC 2104, FIPS 180-4). Whoever has the secret can draw the same seeds again
// from the same files. Nobody else can compute them, not even from the seeds of other submissions
// or tests, so a table of answers to known cases is useless.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rigor {

/// The environment variable that hands a key to a test program.
inline constexpr const char* seed_key_variable = "RIGOR_SEED_KEY";

/// SHA-256 in hexadecimal digits.
std::string sha256(std::string_view text);

/// HMAC-SHA-256 in hexadecimal digits.
std::string hmac_sha256(std::string_view key, std::string_view message);

/// The key of one submission's seeds. @param submission  a digest of its files
std::string seed_key(std::string_view secret, std::string_view submission);

/// The first seed of the random cases of a test.
std::uint32_t drawn_seed(std::string_view key, std::string_view test);

} // namespace rigor
