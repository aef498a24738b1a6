//! The registered rules, one file each.
//!
//! A test (`tests/rules.rs`) keeps the lines below in step with the folder: never edit them by hand.

use super::Entry;

mod dipdt_pd_dalen_di_ruscio;
mod dipdt_pd_mrdp;
mod dipdt_pid_simc;
mod dob_exact;
mod dob_kadam;
mod ifopdt_p_huba_zakova;
mod ifopdt_pd_haalman;
mod ifopdt_pi_huba_zakova;
mod ifopdt_pi_poulin_input;
mod ifopdt_pi_poulin_output;
mod ifopdt_pi_shinskey;
mod ifopdt_pid_imc_o;
mod ifopdt_pid_mcmillan;
mod ifopdt_pid_simc;
mod pd_exact;
mod pd_kadam;
mod pd_mrdp;
mod pd_shinskey_ramp;
mod pd_shinskey_setpoint;
mod pd_visioli_ise;
mod pd_visioli_iste;
mod pd_visioli_itse;
mod pi_simc;
mod pid_ali_majhi;
mod pid_amigo;
mod pid_amigo_freq;
mod pid_arbogast;
mod pid_callender_1;
mod pid_callender_2;
mod pid_chidambaram_sree2003;
mod pid_chr_reg0;
mod pid_chr_reg20;
mod pid_cluett_wang_table;
mod pid_ds_disturbance;
mod pid_ford;
mod pid_imc_chien_fruehauf;
mod pid_isimc;
mod pid_kappatau_14;
mod pid_kappatau_20;
mod pid_luyben1996;
mod pid_mrdp;
mod pid_parr;
mod pid_rotach;
mod pid_shinskey_interacting;
mod pid_shinskey_noninteracting;
mod pid_sree_chidambaram;
mod pid_taguchi_araki;
mod pid_tyreus_luyben;
mod pid_visioli_ise;
mod pid_visioli_iste;
mod pid_visioli_itse;
mod pid_wang_cluett_z0707;
mod pid_wang_cluett_z1;
mod pid_zhang_hinf;
mod pid_zn_no_overshoot;
mod pid_zn_reaction;
mod pid_zn_some_overshoot;
mod pid_zn_ultimate;

/// Every rule.
#[rustfmt::skip]
pub(super) static REGISTRY: &[&Entry] = &[
    &dipdt_pd_dalen_di_ruscio::ENTRY,
    &dipdt_pd_mrdp::ENTRY,
    &dipdt_pid_simc::ENTRY,
    &dob_exact::ENTRY,
    &dob_kadam::ENTRY,
    &ifopdt_p_huba_zakova::ENTRY,
    &ifopdt_pd_haalman::ENTRY,
    &ifopdt_pi_huba_zakova::ENTRY,
    &ifopdt_pi_poulin_input::ENTRY,
    &ifopdt_pi_poulin_output::ENTRY,
    &ifopdt_pi_shinskey::ENTRY,
    &ifopdt_pid_imc_o::ENTRY,
    &ifopdt_pid_mcmillan::ENTRY,
    &ifopdt_pid_simc::ENTRY,
    &pd_exact::ENTRY,
    &pd_kadam::ENTRY,
    &pd_mrdp::ENTRY,
    &pd_shinskey_ramp::ENTRY,
    &pd_shinskey_setpoint::ENTRY,
    &pd_visioli_ise::ENTRY,
    &pd_visioli_iste::ENTRY,
    &pd_visioli_itse::ENTRY,
    &pi_simc::ENTRY,
    &pid_ali_majhi::ENTRY,
    &pid_amigo::ENTRY,
    &pid_amigo_freq::ENTRY,
    &pid_arbogast::ENTRY,
    &pid_callender_1::ENTRY,
    &pid_callender_2::ENTRY,
    &pid_chidambaram_sree2003::ENTRY,
    &pid_chr_reg0::ENTRY,
    &pid_chr_reg20::ENTRY,
    &pid_cluett_wang_table::ENTRY,
    &pid_ds_disturbance::ENTRY,
    &pid_ford::ENTRY,
    &pid_imc_chien_fruehauf::ENTRY,
    &pid_isimc::ENTRY,
    &pid_kappatau_14::ENTRY,
    &pid_kappatau_20::ENTRY,
    &pid_luyben1996::ENTRY,
    &pid_mrdp::ENTRY,
    &pid_parr::ENTRY,
    &pid_rotach::ENTRY,
    &pid_shinskey_interacting::ENTRY,
    &pid_shinskey_noninteracting::ENTRY,
    &pid_sree_chidambaram::ENTRY,
    &pid_taguchi_araki::ENTRY,
    &pid_tyreus_luyben::ENTRY,
    &pid_visioli_ise::ENTRY,
    &pid_visioli_iste::ENTRY,
    &pid_visioli_itse::ENTRY,
    &pid_wang_cluett_z0707::ENTRY,
    &pid_wang_cluett_z1::ENTRY,
    &pid_zhang_hinf::ENTRY,
    &pid_zn_no_overshoot::ENTRY,
    &pid_zn_reaction::ENTRY,
    &pid_zn_some_overshoot::ENTRY,
    &pid_zn_ultimate::ENTRY,
];
