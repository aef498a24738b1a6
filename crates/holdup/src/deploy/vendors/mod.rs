//! The registered blocks, one file each.
//!
//! A test (`tests/vendors`) keeps the lines below in step with the folder: never edit them by hand.

use super::conversion::Vendor;

mod abb_800xa_pidcc;
mod arduino_pid_v1;
mod beckhoff_ctrl_pid;
mod codesys_util_pid;
mod emerson_deltav_series;
mod emerson_deltav_standard;
mod esphome_pid;
mod ge_pid_isa;
mod honeywell_experion;
mod honeywell_interactive;
mod klipper_heater;
mod omron_pidat;
mod rockwell_pide_dependent;
mod rockwell_pide_independent;
mod schneider_pidff;
mod siemens_pid_compact;
mod yokogawa_centum;

/// Every block.
#[rustfmt::skip]
pub(super) static REGISTRY: &[&Vendor] = &[
    &abb_800xa_pidcc::ENTRY,
    &arduino_pid_v1::ENTRY,
    &beckhoff_ctrl_pid::ENTRY,
    &codesys_util_pid::ENTRY,
    &emerson_deltav_series::ENTRY,
    &emerson_deltav_standard::ENTRY,
    &esphome_pid::ENTRY,
    &ge_pid_isa::ENTRY,
    &honeywell_experion::ENTRY,
    &honeywell_interactive::ENTRY,
    &klipper_heater::ENTRY,
    &omron_pidat::ENTRY,
    &rockwell_pide_dependent::ENTRY,
    &rockwell_pide_independent::ENTRY,
    &schneider_pidff::ENTRY,
    &siemens_pid_compact::ENTRY,
    &yokogawa_centum::ENTRY,
];
