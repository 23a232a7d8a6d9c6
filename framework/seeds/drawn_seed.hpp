// SPDX-License-Identifier: MIT
// Seeds of random tests that only the owner of a secret can know.
//
//     key  = HMAC(secret, submission)
//     seed = the first 32 bits of HMAC(key, name of the test)
//
// HMAC uses SHA-256 (RFC 2104, FIPS 180-4). The key is a text of 64 hexadecimal digits. Whoever has
// the secret can draw the same seeds again from the same files. Nobody else can compute them, not
// even from the seeds of other submissions or tests, so a table of answers to known cases is
// useless.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rigor {

/// The environment variable that passes the key of a submission to the test program.
inline constexpr const char* seed_key_variable = "RIGOR_SEED_KEY";

/// SHA-256 in hexadecimal digits.
std::string sha256(std::string_view text);

/// HMAC-SHA-256 in hexadecimal digits.
std::string hmac_sha256(std::string_view key, std::string_view message);

/// The key from which the seeds of one submission are computed.
/// @param submission  a digest of the submission's files, and the first seed of the run (--seed)
std::string seed_key(std::string_view secret, std::string_view submission);

/// The first seed of the random cases of a test. @param key  the result of `seed_key`
std::uint32_t drawn_seed(std::string_view key, std::string_view test);

} // namespace rigor
