// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/apm2_board.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "simulator/devices/ads7844.hpp"
#include "simulator/devices/at45db.hpp"
#include "simulator/devices/bmp085.hpp"
#include "simulator/devices/gps_receiver.hpp"
#include "simulator/devices/hmc5883l.hpp"
#include "simulator/devices/mpu6000.hpp"
#include "simulator/devices/ms5611.hpp"
#include "simulator/output_file.hpp"

namespace simulator {
namespace {

constexpr int kGpsUsart = 1;

// The airplane moves on at least this often, however quiet its sensors are.
constexpr uint64_t kLongestWait_us = 5000;

// The shield of the first board carries the compass face down, and its encoder the output switch.
WorldOptions worldFor(WorldOptions options, const BoardWiring& wiring) {
    options.compass_upside_down = options.output_switch = wiring.converter_select.has_value();
    return options;
}

// The first board's own loops after a watchdog's reset; the second's is the slow one.
std::string bootProgram(const WorldOptions& options, const BoardWiring& wiring) {
    switch (options.bootloader) {
        case Bootloader::looping:
            return "apm1";
        case Bootloader::slow:
            return "apm2";
        case Bootloader::quick:
            return "quick";
        default:
            return wiring.name;
    }
}

// Signals of the trace, after the eight servos.
enum TraceSignal : size_t { kTracePpm = ServoPulses::kOutputs, kTraceDataReady, kTraceMark };

}  // namespace

AvrBoard::AvrBoard(const std::string& firmware, const WorldOptions& options,
                   const BoardWiring& wiring)
    : wiring_(wiring),
      world_(worldFor(options, wiring)),
      image_(readImage(firmware)),
      spi_line_(options.seed),
      chip_(image_),
      supply_(chip_, world_.supply(), world_.bandGap_v(), options.seed),
      servos_(chip_, wiring_),
      radio_(chip_, world_.radio(), wiring_) {
    chip_.setBootSection(
        readImage(std::string(SIMULATOR_BOOT "/") + bootProgram(options, wiring_) + ".elf"));
    for (int usart = 0; usart < 4; usart++) feeds_.emplace_back(chip_, usart);
    wireSensorBus();
    wireFlash();
    wireConverter();
    chip_.twi().rise(options.i2c_rise_ns);
    wireTwoWire(world_.compass());
    if (wiring_.converter_select) wireTwoWire(world_.barometerOnI2c());
    wireSerial();
    wireOutputs();
    wireMarks();
    chip_.adc().volts = [this](int pin) { return volts(pin); };
    chip_.eeprom().wear(WornCells(options.worn_cells, kEepromBytes, options.seed));
    chip_.on_reset = [this] {
        // a low supply resets twice: when it falls and when it is back
        if (program_runs_) ++restarts_;
        program_runs_ = false;
        restart();
    };
    clears_ = hookWrite<&AvrBoard::begun>(chip_.avr(), kMcusr, this);
    supply_.on_skip = [this](uint64_t now_us) { passTime(now_us); };
    if (wiring_.data_ready) chip_.drive(wiring_.data_ready->port, wiring_.data_ready->bit, false);
    setUsb(false);
    restart();
}

AvrBoard::~AvrBoard() = default;

// Of the pins of a board's parts; each port is listened to once.
void AvrBoard::wireSensorBus() {
    for (const char port : {'A', 'B', 'C', 'G', 'L'})
        chip_.onPort(port, [this] {
            portChanged();
            selectFlash();
            selectConverter();
        });
    chip_.spi().on_exchange = [this](uint8_t mosi) { return exchange(mosi); };
}

void AvrBoard::wireFlash() {
    if (!wiring_.flash_usart) return;
    chip_.usart(*wiring_.flash_usart).on_exchange = [this](uint8_t mosi) {
        return world_.dataflash().transfer(mosi, time_us());
    };
}

void AvrBoard::wireConverter() {
    if (!wiring_.converter_usart) return;
    chip_.usart(*wiring_.converter_usart).on_exchange = [this](uint8_t mosi) {
        return world_.converter().transfer(mosi, time_us());
    };
}

template <class Device>
void AvrBoard::wireTwoWire(Device& device) {
    TwiDevice on_bus;
    on_bus.start = [this, &device](bool read) {
        world_.advanceTo(time_us());
        return device.start(read, time_us());
    };
    on_bus.write = [this, &device](uint8_t byte) {
        const bool acknowledged = device.write(byte, time_us());
        showConversionEnd();
        return acknowledged;
    };
    on_bus.read = [this, &device](bool ack) { return device.read(ack, time_us()); };
    on_bus.stop = [this, &device] { device.stop(time_us()); };
    chip_.twi().connect(Device::kAddress, on_bus);
}

double AvrBoard::volts(int pin) {
    world_.advanceTo(time_us());
    for (const AnalogWire& wire : wiring_.analog) {
        if (wire.pin != pin) continue;
        return wire.factor * world_.analog_v(wire.source, time_us());
    }
    return 0;
}

void AvrBoard::wireSerial() {
    for (int usart = 0; usart < 4; usart++)
        chip_.usart(usart).on_sent = [this, usart](uint8_t byte, uint64_t cycle) {
            sent(usart, byte, cycle);
        };
}

// Outputs 1 to 4. A mission and the camera write the others when they come to it.
bool AvrBoard::flies(char timer, int compare) const {
    constexpr size_t kFlown = 4;
    const auto* const begin = std::begin(wiring_.servos);
    return std::any_of(begin, begin + kFlown, [=](const ServoWire& servo) {
        return servo.timer == timer && servo.compare == compare;
    });
}

void AvrBoard::wireOutputs() {
    for (const ServoWire& servo : wiring_.servos) {
        if (servo.timer == '5') continue;  // the clock's, compared for other reasons too
        chip_.onCompareWrite(servo.timer, [this, timer = servo.timer](int compare) {
            if (flies(timer, compare)) work_.servoWritten(chip_.cycle());
        });
    }
    servos_.on_pulse = [this](int output, double width_us) {
        world_.servoPulse(output, width_us, time_us());
    };
    servos_.on_level = [this](int output, bool high) { trace(output - 1, high); };
    radio_.on_level = [this](bool high) { trace(kTracePpm, high); };
}

void AvrBoard::wireMarks() {
    chip_.on_trace = [this](uint8_t value) {
        work_.trace(value, {chip_.cycle(), chip_.asleepCycles(), chip_.interrupts().cycles()});
        trace(kTraceMark, value);
    };
}

// The chip has been reset and all its timers are gone; the world has not noticed.
void AvrBoard::restart() {
    work_.reset();
    wake_cycle_ = UINT64_MAX;
    planWake();
    radio_.restart();
    for (SerialFeed& feed : feeds_) feed.resume();
    portChanged();
    selectFlash();
    selectConverter();
}

void AvrBoard::showFaults() {
    chip_.twi().fail(world_.faultOf(Faulty::i2c));
    spi_line_.fail(world_.faultOf(Faulty::spi));
}

std::string AvrBoard::flash(const std::string& firmware) {
    try {
        image_ = readImage(firmware);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    chip_.program(image_);
    reset();
    return "";
}

// A jump to itself, in a word of flash that no program uses.
void AvrBoard::hang() {
    constexpr uint32_t kSpare = kBootSection - 2;
    constexpr uint64_t kStart_us = 1000, kBegins_us = 5'000'000;
    avr_t* avr = chip_.avr();
    const auto guarded = [&] { return program_runs_ && (avr->data[kWdtcsr] & kWatchdogOn) != 0; };
    const uint64_t until_us = time_us() + kBegins_us;
    const auto run = [&](uint64_t us) { return time_us() < until_us && runUntil(time_us() + us); };
    while (!guarded())
        if (!run(kStart_us)) return;
    while (chip_.interrupts().running() || !avr->sreg[S_I])
        if (!run(1)) return;
    avr->flash[kSpare] = 0xFF;
    avr->flash[kSpare + 1] = 0xCF;
    avr->pc = kSpare;
    avr->state = cpu_Running;
}

// A bootloader clears the flags of the reset, and so does the program first of all.
void AvrBoard::begun(uint16_t address, uint8_t value) {
    clears_(chip_.avr(), address, value);
    if (chip_.avr()->pc >= kBootSection) return;
    begun_us_ = time_us();
    if (program_runs_) {  // it has jumped to its beginning
        ++restarts_;
        work_.reset();
    }
    program_runs_ = true;
    if (!first_cycle_) first_cycle_ = chip_.cycle();
}

bool AvrBoard::runUntil(uint64_t time_us) {
    radio_.plan();
    showFaults();
    const bool running = supply_.run(time_us);
    world_.advanceTo(this->time_us());
    return running;
}

void AvrBoard::send(int usart, const uint8_t* bytes, size_t size) {
    feeds_.at(usart).send(bytes, size);
}

void AvrBoard::setUsb(bool plugged) {
    if (wiring_.usb_sense) chip_.drive(wiring_.usb_sense->port, wiring_.usb_sense->bit, !plugged);
}

void AvrBoard::setEeprom(const std::vector<uint8_t>& image) { chip_.eeprom().setContents(image); }

bool AvrBoard::pulledLow(const PinName& pin) const {
    return chip_.isOutput(pin.port, pin.bit) && !chip_.outputHigh(pin.port, pin.bit);
}

bool AvrBoard::ledOn(Led led) const {
    const PinName& pin = wiring_.leds[static_cast<size_t>(led)];
    return wiring_.leds_active_low ? pulledLow(pin) : chip_.outputHigh(pin.port, pin.bit);
}

void AvrBoard::portChanged() {
    selectSensors();
    const bool relay = chip_.outputHigh(wiring_.relay.port, wiring_.relay.bit);
    if (relay != world_.relayOn()) world_.relay(relay);
}

// A chip is selected by an output that is low; inputs are pulled up on the board.
void AvrBoard::selectSensors() {
    if (std::exchange(imu_chosen_, chosen(wiring_.imu_select)) != imu_chosen_) {
        world_.advanceTo(time_us());
        world_.imu().select(imu_chosen_, time_us());
    }
    if (std::exchange(barometer_chosen_, chosen(wiring_.barometer_select)) == barometer_chosen_)
        return;
    world_.advanceTo(time_us());
    // The MS5611 does not come up on a bus whose MPU6000 is not held deselected.
    const PinName& imu = *wiring_.imu_select;
    if (barometer_chosen_) barometer_deaf_ = !chip_.outputHigh(imu.port, imu.bit);
    if (!barometer_deaf_) world_.barometer().select(barometer_chosen_, time_us());
}

void AvrBoard::selectFlash() {
    const bool chosen = pulledLow(wiring_.flash_select);
    const bool in_reset = pulledLow(wiring_.flash_reset);
    if (std::exchange(flash_in_reset_, in_reset) != in_reset)
        world_.dataflash().resetPin(in_reset, time_us());
    if (std::exchange(flash_chosen_, chosen) != chosen)
        world_.dataflash().select(chosen, time_us());
}

void AvrBoard::selectConverter() {
    const bool is_chosen = chosen(wiring_.converter_select);
    if (std::exchange(converter_chosen_, is_chosen) == is_chosen) return;
    world_.advanceTo(time_us());
    world_.converter().select(is_chosen);
}

uint8_t AvrBoard::exchange(uint8_t mosi) {
    if (!wiring_.flash_usart)
        return spi_line_.through(world_.dataflash().transfer(mosi, time_us()));
    const bool barometer = barometer_chosen_ && !barometer_deaf_;
    if (imu_chosen_ && barometer_chosen_) contentions_++;
    uint8_t miso = 0xFF;
    world_.imu().clock(chip_.spi().clock_hz());
    if (imu_chosen_) miso &= world_.imu().transfer(mosi, time_us());
    if (barometer) miso &= world_.barometer().transfer(mosi, time_us());
    if (imu_chosen_) {
        showDataReady();
        planWake();  // its sample rate may have been set
    }
    return spi_line_.through(miso);
}

void AvrBoard::showDataReady() {
    const bool ready = world_.imu().interruptPin();
    if (std::exchange(data_ready_, ready) == ready) return;
    if (wiring_.data_ready) chip_.drive(wiring_.data_ready->port, wiring_.data_ready->bit, ready);
    if (ready) work_.sampleReady(chip_.cycle());
    trace(kTraceDataReady, ready);
}

void AvrBoard::showConversionEnd() {
    if (!wiring_.conversion_end) return;
    const bool ended = world_.barometerOnI2c().conversionEnded(time_us());
    if (std::exchange(conversion_ended_, ended) == ended) return;
    chip_.drive(wiring_.conversion_end->port, wiring_.conversion_end->bit, ended);
    if (!ended) planWake();
}

void AvrBoard::sent(int usart, uint8_t byte, uint64_t cycle) {
    const uint64_t at_us = cycle / kCyclesPer_us;
    if (usart == kGpsUsart) {
        world_.advanceTo(at_us);
        world_.gps().receive(byte, chip_.usart(usart).baud(), at_us);
        planWake();
    }
    if (listener_) listener_(usart, byte, at_us);
}

void AvrBoard::feedGps() {
    Usart& usart = chip_.usart(kGpsUsart);
    GpsReceiver& gps = world_.gps();
    while (const auto byte = gps.nextByte(time_us())) {
        if (const auto heard = gps_noise_.through(*byte, gps.baud(), usart.baud()))
            usart.receive(*heard);
    }
}

// The chip is held in reset: what comes to its pins is lost.
void AvrBoard::passTime(uint64_t now_us) {
    world_.advanceTo(now_us);
    radio_.pass(now_us);
    while (world_.gps().nextByte(now_us)) {
    }
}

// When its pin changes; never where there is none.
uint64_t AvrBoard::conversionEnds_us() {
    return wiring_.conversion_end && !conversion_ended_
               ? world_.barometerOnI2c().conversionEnds_us()
               : UINT64_MAX;
}

uint64_t AvrBoard::nextEvent() {
    const uint64_t event =
        std::min({world_.imu().nextSample_us(), world_.gps().nextByte_us(),
                  world_.gps().nextEvent_us(), time_us() + kLongestWait_us, conversionEnds_us()});
    return std::max(event * kCyclesPer_us, chip_.cycle() + 1);
}

void AvrBoard::planWake() {
    const uint64_t next = nextEvent();
    if (next >= wake_cycle_) return;
    wake_cycle_ = next;
    startTimerAt<&AvrBoard::wake>(chip_.avr(), wake_cycle_, this);
}

uint64_t AvrBoard::wake(uint64_t) {
    world_.advanceTo(time_us());
    showFaults();
    showDataReady();
    showConversionEnd();
    feedGps();
    radio_.plan();
    wake_cycle_ = nextEvent();
    return wake_cycle_;
}

void AvrBoard::traceTo(const std::string& path) {
    std::vector<VcdTrace::Signal> signals;
    for (int i = 1; i <= ServoPulses::kOutputs; i++)
        signals.push_back({"servo" + std::to_string(i), 1});
    signals.push_back({"ppm", 1});
    signals.push_back({"data_ready", 1});
    signals.push_back({"trace", 8});
    trace_ = std::make_unique<VcdTrace>(path, signals);
}

void AvrBoard::profileTo(const std::string& path) {
    profile_path_ = path;
    chip_.startProfile();
}

void AvrBoard::closeTrace() {
    if (const auto trace = std::move(trace_)) trace->close();
}

void AvrBoard::closeProfile() {
    if (profile_path_.empty()) return;
    const std::string firmware = std::filesystem::absolute(image_.path).lexically_normal();
    writeFile(profile_path_, chip_.profile()->json({firmware, image_.sha256}, chip_.cycle()));
}

void AvrBoard::trace(size_t signal, unsigned value) {
    if (trace_) trace_->change(signal, value, chip_.cycle());
}

BoardFigures AvrBoard::figures() const {
    BoardFigures figures;
    figures.flash_bytes = image_.flash_bytes;
    figures.ram_static_bytes = image_.ram_static_bytes;
    figures.stack_max_bytes = chip_.stack().maxBytes();
    work_.report(figures);
    // of the program, not of the bootloader that waits for a programmer before it
    const auto cycles = static_cast<double>(chip_.cycle() - first_cycle_.value_or(0));
    if (cycles == 0) return figures;
    figures.cpu_load = 1 - static_cast<double>(chip_.asleepCycles()) / cycles;
    figures.interrupt_load = static_cast<double>(chip_.interrupts().cycles()) / cycles;
    for (int vector = 1; vector < Interrupts::kVectors; vector++) {
        const Interrupts::Count& count = chip_.interrupts().count(vector);
        if (count.runs)
            figures.interrupts.push_back({vector, count.runs, count.max_cycles, count.cycles});
    }
    return figures;
}

}  // namespace simulator
