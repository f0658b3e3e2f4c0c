// SPDX-License-Identifier: GPL-3.0-or-later
// The board behind the tool: the firmware itself, on the tests' EEPROM. Everything that is read
// from or written into an image goes through the firmware's own store and upload.
#pragma once
#include "storage/eeprom_map.hpp"
#include "toolchain/mission_tool/document.hpp"
#include "toolchain/mission_tool/image.hpp"

namespace mission_tool {

// Power on with this EEPROM: parameters are loaded, so that ranges are this airplane's.
void powerUp(const Image& image);
// The same, and on until the firmware has found its mission. Throws WrongInput when the EEPROM is
// neither blank nor this firmware's.
void boot(const Image& image, const std::string& name);

// The mission stored in the image. Throws WrongInput when it is not this firmware's, or holds none.
Document storedMission(const Image& image, const std::string& name);

// The image after the document has been uploaded to a board that holds `onto`.
Image uploaded(const Document& document, const Image& onto, const std::string& onto_name);

constexpr size_t kMaxItems = storage::kRecordSlots;

}  // namespace mission_tool
