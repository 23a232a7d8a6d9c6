// SPDX-License-Identifier: MIT
// A program that never reaches main.
namespace {

int loop()
{
    for (volatile unsigned i = 0;; i = i + 1) {
    }
}

[[maybe_unused]] const int never = loop();

} // namespace
