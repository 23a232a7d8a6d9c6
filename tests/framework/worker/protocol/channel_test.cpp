// SPDX-License-Identifier: MIT
// The attacks in which a submission takes the place of the worker must know the protocol as it is.
// Otherwise their greeting would be refused, and the rest of the attack would not be tested.
#include "attacks/submissions/protocol/channel_words.hpp"
#include "support/catch.hpp"
#include "worker/protocol/channel.hpp"

namespace rigor {

static_assert(offsetof(ChannelWords, request_size) == offsetof(Channel, request_size));
static_assert(offsetof(ChannelWords, reply) == offsetof(Channel, reply));
static_assert(offsetof(ChannelWords, status) == offsetof(Channel, status));
static_assert(offsetof(ChannelWords, reply_size) == offsetof(Channel, reply_size));
static_assert(offsetof(ChannelWords, streamed) == offsetof(Channel, stream.written));
static_assert(ring_size == Ring::size);
static_assert(stream_start == offsetof(Channel, stream.bytes));
static_assert(payload_start == offsetof(Channel, payload));
static_assert(channel_size == sizeof(Channel));

TEST_CASE("the forged workers of the attacks greet as a worker does")
{
    CHECK(greeting() == contract_fingerprint());
}

} // namespace rigor
