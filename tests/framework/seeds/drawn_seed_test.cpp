// SPDX-License-Identifier: MIT
// Tests of the digests against the published vectors, and of what the seeds depend on.
#include "seeds/drawn_seed.hpp"
#include "support/catch.hpp"

#include <set>

namespace rigor {

TEST_CASE("seeds: SHA-256 has the values of FIPS 180-4")
{
    REQUIRE(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    REQUIRE(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    REQUIRE(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST_CASE("seeds: HMAC has the values of RFC 4231")
{
    REQUIRE(hmac_sha256(std::string(20, '\x0b'), "Hi There") ==
            "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7");
    REQUIRE(hmac_sha256("Jefe", "what do ya want for nothing?") ==
            "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
    REQUIRE(hmac_sha256(std::string(131, '\xaa'),
                        "Test Using Larger Than Block-Size Key - Hash Key First") ==
            "60e431591ee0b67f0d8a26aacbf5b77f8e0bc6213728c5140546040f0ee37f54");
}

TEST_CASE("seeds: a seed depends on the secret and the submission and the test")
{
    std::set<std::uint32_t> seeds;
    for (const char* secret : {"the secret of one course", "the secret of another one"})
        for (const char* submission : {"0a", "0b", "0c"})
            for (const char* test : {"inertia: law", "inertia: another law"}) {
                const std::uint32_t seed = drawn_seed(seed_key(secret, submission), test);
                REQUIRE(drawn_seed(seed_key(secret, submission), test) == seed);
                seeds.insert(seed);
            }
    REQUIRE(seeds.size() == 2 * 3 * 2);
}

} // namespace rigor
