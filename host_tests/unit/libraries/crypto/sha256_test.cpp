// SPDX-License-Identifier: GPL-3.0-or-later
// The examples of FIPS 180-4 (NIST, "Examples with intermediate values") and of the Secure Hash
// Standard's validation list of short messages.
#include "crypto/sha256.hpp"

#include <gtest/gtest.h>

#include <string>

using crypto::Sha256;

namespace {

std::string hashOf(const std::string& message) {
    static Sha256 sha;  // whatever it was used for before
    sha.begin();
    const uint16_t size = static_cast<uint16_t>(message.size());
    for (uint8_t block = 0; block < crypto::blocksOf(size); ++block) {
        for (uint8_t i = 0; i < crypto::kBlockSize; ++i)
            if (block * crypto::kBlockSize + i < size)
                sha.byte(i) = static_cast<uint8_t>(message[block * crypto::kBlockSize + i]);
        sha.pad(block, size);
        uint8_t calls = 1;
        while (!sha.quarter()) ++calls;
        EXPECT_EQ(calls, crypto::kQuarters);
    }
    std::string digits;
    for (uint8_t i = 0; i < 32; ++i) {
        digits += "0123456789abcdef"[sha.hash(i) >> 4];
        digits += "0123456789abcdef"[sha.hash(i) & 15];
    }
    return digits;
}

std::string repeated(int count, char letter) {
    std::string text;
    while (count-- > 0) text += letter;
    return text;
}

TEST(Sha256, hashes_an_empty_message) {
    EXPECT_EQ(hashOf(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, of_one_block) {
    EXPECT_EQ(hashOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, of_two_blocks) {
    EXPECT_EQ(hashOf("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(hashOf("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmn"
                     "hijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu"),
              "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
}

// One byte more than leaves room for the length; and blocks that are full.
TEST(Sha256, of_messages_about_as_long_as_a_block) {
    EXPECT_EQ(hashOf(repeated(55, 'a')),
              "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318");
    EXPECT_EQ(hashOf(repeated(56, 'a')),
              "b35439a4ac6f0948b6d6f9e3c6af0f5f590ce20f1bde7090ef7970686ec6738a");
    EXPECT_EQ(hashOf(repeated(63, 'a')),
              "7d3e74a05d7db15bce4ad9ec0658ea98e3f06eeecf16b4c6fff2da457ddc2f34");
    EXPECT_EQ(hashOf(repeated(64, 'a')),
              "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb");
    EXPECT_EQ(hashOf(repeated(119, 'a')),
              "31eba51c313a5c08226adf18d4a359cfdfd8d2e816b13f4af952f7ea6584dcfb");
    EXPECT_EQ(hashOf(repeated(120, 'a')),
              "2f3d335432c70b580af0e8e1b3674a7c020d683aa5f73aaaedfdc55af904c21c");
}

// The longest that is signed: a key, a frame of 280 bytes, a link and a time.
TEST(Sha256, of_more_than_255_bytes) {
    EXPECT_EQ(hashOf(repeated(319, 'z')),
              "d74b9de445dc3e98b03106b9ddee5658a26bced70d92f2aa04dfb7de59d46958");
}

TEST(Sha256, says_how_many_blocks_a_message_takes) {
    EXPECT_EQ(crypto::blocksOf(0), 1);
    EXPECT_EQ(crypto::blocksOf(55), 1);
    EXPECT_EQ(crypto::blocksOf(56), 2);
    EXPECT_EQ(crypto::blocksOf(119), 2);
    EXPECT_EQ(crypto::blocksOf(120), 3);
}

}  // namespace
