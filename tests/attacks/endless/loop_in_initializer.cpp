// SPDX-License-Identifier: MIT
// Never comes to main.
namespace {

int loop()
{
    for (volatile unsigned i = 0;; i = i + 1) {
    }
}

[[maybe_unused]] const int never = loop();

} // namespace
