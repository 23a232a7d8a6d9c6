// SPDX-License-Identifier: MIT
// Computes SHA-256 and HMAC by the library Nettle. A seed is the number in the first eight
// hexadecimal digits of a digest.
#include "seeds/drawn_seed.hpp"

#include <array>
#include <nettle/hmac.h>
#include <nettle/sha2.h>

namespace rigor {

namespace {

using Digest = std::array<std::uint8_t, SHA256_DIGEST_SIZE>;

const std::uint8_t* bytes_of(std::string_view text)
{
    return reinterpret_cast<const std::uint8_t*>(text.data());
}

std::string in_hexadecimal(const Digest& digest)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : digest) {
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

} // namespace

std::string sha256(std::string_view text)
{
    sha256_ctx context;
    Digest digest;
    sha256_init(&context);
    sha256_update(&context, text.size(), bytes_of(text));
    sha256_digest(&context, digest.size(), digest.data());
    return in_hexadecimal(digest);
}

std::string hmac_sha256(std::string_view key, std::string_view message)
{
    hmac_sha256_ctx context;
    Digest digest;
    hmac_sha256_set_key(&context, key.size(), bytes_of(key));
    hmac_sha256_update(&context, message.size(), bytes_of(message));
    hmac_sha256_digest(&context, digest.size(), digest.data());
    return in_hexadecimal(digest);
}

std::string seed_key(std::string_view secret, std::string_view submission)
{
    return hmac_sha256(secret, submission);
}

std::uint32_t drawn_seed(std::string_view key, std::string_view test)
{
    return static_cast<std::uint32_t>(std::stoul(hmac_sha256(key, test).substr(0, 8), nullptr, 16));
}

} // namespace rigor
