// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/signature_hash.hpp"

#include "core/file_state.hpp"
#include "core/seldom.hpp"
#include "crypto/sha256.hpp"
#include "firmware/gcs/signing_store.hpp"

namespace firmware {
namespace gcs {

namespace {

struct Hash {
    HashUser user;
    uint8_t block;
    bool filled;  // the block is in the hash, to be worked on
    crypto::Sha256 sha;
};
core::FileState<Hash> hash{};

// False: the EEPROM is busy.
SELDOM bool fill(const Hashed& bytes) {
    crypto::Sha256& sha = hash.sha;
    uint8_t at = 0;
    if (hash.block == 0) {
        uint8_t key[kKeySize];
        if (readSigningKey(key) != core::Status::ok) return false;
        sha.begin();
        for (; at < kKeySize; ++at) sha.byte(at) = key[at];
    }
    uint8_t from = static_cast<uint8_t>(hash.block * crypto::kBlockSize + at - kKeySize);
    for (; at < crypto::kBlockSize && from < bytes.size; ++at, ++from)
        sha.byte(at) = from < bytes.first_size
                           ? bytes.first[from]
                           : bytes.second[static_cast<uint8_t>(from - bytes.first_size)];
    sha.pad(hash.block, kKeySize + bytes.size);
    return true;
}

}  // namespace

void signatureHashStart() { hash.user = HashUser::nobody; }

HashUser signatureHashUser() { return hash.user; }

Hashing hashSignature(HashUser user, const Hashed& bytes) {
    if (hash.user == HashUser::nobody) {
        hash.block = 0;
        hash.filled = false;
    } else if (hash.user != user) {
        return Hashing::waits;
    } else if (hash.block == crypto::blocksOf(kKeySize + bytes.size)) {
        return Hashing::done;
    }
    if (!hash.filled) {
        if (!fill(bytes)) return Hashing::waits;
        hash.user = user;
        hash.filled = true;
    } else if (hash.sha.quarter()) {
        hash.filled = false;
        ++hash.block;
    }
    return Hashing::works;
}

uint8_t signatureHash(uint8_t at) { return hash.sha.hash(at); }

void releaseSignatureHash(HashUser user) {
    if (hash.user == user) hash.user = HashUser::nobody;
}

}  // namespace gcs
}  // namespace firmware
