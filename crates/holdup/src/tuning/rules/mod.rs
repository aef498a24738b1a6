//! The registered rules, one file each.
//!
//! A test (`tests/rules.rs`) keeps the lines below in step with the folder: never edit them by hand.

use super::Entry;

mod dob_exact;
mod dob_kadam;
mod pd_exact;
mod pd_kadam;
mod pi_simc;
mod pid_ali_majhi;
mod pid_sree_chidambaram;
mod pid_wang_cluett_z0707;
mod pid_wang_cluett_z1;

/// Every rule.
#[rustfmt::skip]
pub(super) static REGISTRY: &[&Entry] = &[
    &dob_exact::ENTRY,
    &dob_kadam::ENTRY,
    &pd_exact::ENTRY,
    &pd_kadam::ENTRY,
    &pi_simc::ENTRY,
    &pid_ali_majhi::ENTRY,
    &pid_sree_chidambaram::ENTRY,
    &pid_wang_cluett_z0707::ENTRY,
    &pid_wang_cluett_z1::ENTRY,
];
