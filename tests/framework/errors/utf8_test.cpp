// SPDX-License-Identifier: MIT
#include "errors/utf8.hpp"
#include "support/catch.hpp"

#include <string>

using namespace rigor;

TEST_CASE("utf8: letters and signs of all scripts are plain", "[errors]")
{
    for (const char* text : {"alice", "Zo\u00EB", "Zoe\u0308", "\u0645\u062D\u0645\u062F",
                             "\u674E \u96F7", "\u05E9\u05E8\u05D4", "\u0430lice", "\U0001F600",
                             "a\u00A0b", "\u0600", "\u0645\u06CC\u200C\u062F", "\u2764\uFE0F"})
        CHECK(is_plain_utf8(text));
}

TEST_CASE("utf8: what cannot be seen is no plain text", "[errors]")
{
    for (const char* hidden :
         {"\u00AD", "\u034F",     "\u061C",     "\u115F",     "\u1160",    "\u17B4",
          "\u180B", "\u180F",     "\u200B",     "\u200F",     "\u202A",    "\u202E",
          "\u2060", "\u2066",     "\u206F",     "\u3164",     "\uFEFF",    "\uFFA0",
          "\uFFF9", "\U0001BCA0", "\U0001D173", "\U000E0001", "\U000E0FFF"}) {
        CAPTURE(hidden);
        CHECK(character_size(hidden) == 0);
        CHECK_FALSE(is_plain_utf8("alice" + std::string(hidden)));
    }
}

TEST_CASE("utf8: control characters and other bytes are no plain text", "[errors]")
{
    for (const char* text :
         {"\x1b[31m", "a\nb", "\x7f", "\u0085", "\u2028", "\xff", "\xc0\xaf", "\xed\xa0\x80"})
        CHECK_FALSE(is_plain_utf8(text));
}

TEST_CASE("utf8: blanks have a size and letters have none", "[errors]")
{
    CHECK(blank_size(" a") == 1);
    CHECK(blank_size("\u00A0a") == 2);
    CHECK(blank_size("\u3000") == 3);
    CHECK(blank_size("a ") == 0);
    CHECK(blank_size("") == 0);
}
