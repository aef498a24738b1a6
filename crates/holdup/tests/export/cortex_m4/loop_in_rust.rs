//! The Rust exports on the emulated Cortex-M4: no standard library, no allocation.
#![no_std]

pub mod exported;

use exported::Controller;
use holdup_control::{Input, Mode};

type Real = f64;
type Bits = u64;

/// As in `firmware.h`.
#[repr(C)]
pub struct Told {
    kind: u32,
    padding: u32,
    words: [u64; 9],
}

/// As in `firmware.h`.
#[repr(C)]
#[derive(Default)]
pub struct Answer {
    is_update: u32,
    limited: u32,
    status: u32,
    padding: u32,
    manipulated_variable: u64,
    wanted: u64,
    load_estimate: u64,
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}

fn number(word: u64) -> Real {
    Real::from_bits(word as Bits)
}

fn bits(value: Real) -> u64 {
    value.to_bits() as u64
}

fn input(words: &[u64; 9]) -> Input<Real> {
    Input {
        sample_period: number(words[0]),
        setpoint: number(words[1]),
        controlled_variable: (words[2] != 0).then(|| number(words[3])),
        feed_forward: number(words[4]),
        applied: (words[5] != 0).then(|| number(words[6])),
        mode: match words[7] {
            0 => Mode::Automatic,
            1 => Mode::Manual(number(words[8])),
            _ => Mode::Hold,
        },
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn run(next: extern "C" fn(&mut Told) -> bool, say: extern "C" fn(&Answer)) {
    let mut controller: Option<Controller> = None;
    let mut told = Told { kind: 0, padding: 0, words: [0; 9] };
    while next(&mut told) {
        let words = &told.words;
        let mut answer = Answer::default();
        match (told.kind as u8, &mut controller) {
            (b'd', _) => continue,
            (b'u', Some(controller)) => {
                let output = controller.step(&input(words));
                answer.is_update = 1;
                answer.limited = output.limited as u32;
                answer.status = output.status as u32;
                answer.manipulated_variable = bits(output.manipulated_variable);
                answer.wanted = bits(output.wanted);
                answer.load_estimate = bits(output.load_estimate.unwrap_or(0.0));
            }
            (kind, _) => {
                controller = if kind == b'o' {
                    Controller::switched_on(number(words[0])).ok()
                } else {
                    Controller::at_rest(number(words[0]), number(words[1]), number(words[2])).ok()
                };
                answer.status = u32::from(controller.is_some());
            }
        }
        say(&answer);
    }
}
