//! The board: an LM3S6965 with its OLED panel on the first serial port (SSI0), as QEMU's `lm3s6965evb` wires it.
//!
//! | pin | what |
//! |---|---|
//! | port A, 2 and 5 | SSI0's clock and output |
//! | port C, 7 | the panel's data/command: high for data |
//! | port D, 0 | the panel's select: high, for the memory card on the same bus takes the other level |

use super::ssd0323::Bus;
use register::Register;

/// SSI0 and the panel's two pins.
#[derive(Debug)]
pub(crate) struct PanelPort(());

impl PanelPort {
    /// Clocks the port and its pins, and selects the panel. Taking the core's peripherals, of which there is one set,
    /// makes sure that there is one such port.
    pub(crate) fn new(_core: cortex_m::Peripherals) -> Self {
        const PORTS_A_C_D: u32 = 1 << 0 | 1 << 2 | 1 << 3;
        const SSI0: u32 = 1 << 4;

        Register::CLOCK_GATES_1.set(SSI0);
        Register::CLOCK_GATES_2.set(PORTS_A_C_D);

        Register::PORT_A_ALTERNATE_FUNCTION.set(SERIAL_PINS);
        Register::PORT_A_DIGITAL_ENABLE.set(SERIAL_PINS);
        Register::PORT_C_DIRECTION.set(DATA_COMMAND_PIN);
        Register::PORT_C_DIGITAL_ENABLE.set(DATA_COMMAND_PIN);
        Register::PORT_D_DIRECTION.set(SELECT_PIN);
        Register::PORT_D_DIGITAL_ENABLE.set(SELECT_PIN);

        // 8 bits a frame, clock idle high and sampled on its second edge, the clock divided by 4.
        Register::SSI0_CONTROL_1.write(0);
        Register::SSI0_CLOCK_PRESCALE.write(4);
        Register::SSI0_CONTROL_0.write(0b1100_0111);
        Register::SSI0_CONTROL_1.write(1 << 1);

        Register::PORT_D_SELECT_PIN.write(SELECT_PIN);
        Self(())
    }

    /// Sends bytes and returns once the last one is on the wire: only then may the data/command pin change.
    fn send(&mut self, bytes: impl Iterator<Item = u8>) {
        const ROOM_TO_SEND: u32 = 1 << 1;
        const RECEIVED: u32 = 1 << 2;
        const BUSY: u32 = 1 << 4;

        // The port receives while it sends, though the panel says nothing: what comes in is thrown away, for a port
        // whose receive queue is full stops (in QEMU) or reports an overrun (on the chip).
        let discard_received = || {
            while Register::SSI0_STATUS.read() & RECEIVED != 0 {
                Register::SSI0_DATA.read();
            }
        };
        for byte in bytes {
            while Register::SSI0_STATUS.read() & ROOM_TO_SEND == 0 {}
            Register::SSI0_DATA.write(byte.into());
            discard_received();
        }
        while Register::SSI0_STATUS.read() & BUSY != 0 {}
        discard_received();
    }
}

impl Bus for PanelPort {
    fn command(&mut self, bytes: &[u8]) {
        Register::PORT_C_DATA_COMMAND_PIN.write(0);
        self.send(bytes.iter().copied());
    }

    fn data(&mut self, bytes: impl Iterator<Item = u8>) {
        Register::PORT_C_DATA_COMMAND_PIN.write(DATA_COMMAND_PIN);
        self.send(bytes);
    }
}

const SERIAL_PINS: u32 = 1 << 2 | 1 << 5;
const DATA_COMMAND_PIN: u32 = 1 << 7;
const SELECT_PIN: u32 = 1 << 0;

/// The only unsafe code: reading and writing memory that is a register.
mod register {
    #![allow(unsafe_code, reason = "a memory-mapped register is an address that only a raw pointer reaches")]

    use core::ptr::with_exposed_provenance_mut;

    /// The address of a register of this chip. Outside of this module there are no others than those below.
    #[derive(Debug, Clone, Copy)]
    pub(super) struct Register(usize);

    impl Register {
        pub(super) const CLOCK_GATES_1: Self = Self(0x400F_E104);
        pub(super) const CLOCK_GATES_2: Self = Self(0x400F_E108);

        pub(super) const PORT_A_ALTERNATE_FUNCTION: Self = Self(PORT_A + 0x420);
        pub(super) const PORT_A_DIGITAL_ENABLE: Self = Self(PORT_A + 0x51C);
        pub(super) const PORT_C_DIRECTION: Self = Self(PORT_C + 0x400);
        pub(super) const PORT_C_DIGITAL_ENABLE: Self = Self(PORT_C + 0x51C);
        pub(super) const PORT_D_DIRECTION: Self = Self(PORT_D + 0x400);
        pub(super) const PORT_D_DIGITAL_ENABLE: Self = Self(PORT_D + 0x51C);

        // A port's data register lies at 256 addresses; the address says which pins a write changes.
        pub(super) const PORT_C_DATA_COMMAND_PIN: Self = Self(PORT_C + (super::DATA_COMMAND_PIN as usize) * 4);
        pub(super) const PORT_D_SELECT_PIN: Self = Self(PORT_D + (super::SELECT_PIN as usize) * 4);

        pub(super) const SSI0_CONTROL_0: Self = Self(SSI0);
        pub(super) const SSI0_CONTROL_1: Self = Self(SSI0 + 0x04);
        pub(super) const SSI0_DATA: Self = Self(SSI0 + 0x08);
        pub(super) const SSI0_STATUS: Self = Self(SSI0 + 0x0C);
        pub(super) const SSI0_CLOCK_PRESCALE: Self = Self(SSI0 + 0x10);

        pub(super) fn read(self) -> u32 {
            // SAFETY: the address is one of the constants above: an aligned 32-bit register of this chip, which no
            // Rust object overlaps. Reading them has no effect on memory.
            unsafe { with_exposed_provenance_mut::<u32>(self.0).read_volatile() }
        }

        pub(super) fn write(self, value: u32) {
            // SAFETY: as for `read`; none of them starts a transfer to memory.
            unsafe { with_exposed_provenance_mut::<u32>(self.0).write_volatile(value) }
        }

        /// Sets these bits and leaves the others as they are.
        pub(super) fn set(self, bits: u32) {
            self.write(self.read() | bits);
        }
    }

    const PORT_A: usize = 0x4000_4000;
    const PORT_C: usize = 0x4000_6000;
    const PORT_D: usize = 0x4000_7000;
    const SSI0: usize = 0x4000_8000;
}
