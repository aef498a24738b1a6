//! The registered rules, one file each.
//!
//! A test (`tests/rules.rs`) keeps the lines below in step with the folder: never edit them by hand.

use super::Entry;

mod dob_kadam;
mod p_chr_servo0;
mod p_haalman;
mod p_labview;
mod p_mrdp;
mod p_viteckova_overshoot;
mod p_zn_reaction;
mod p_zn_ultimate;
mod pd_kadam;
mod pi_ah1995;
mod pi_ah2002;
mod pi_amigo;
mod pi_amigo_freq;
mod pi_averaging;
mod pi_callender_1;
mod pi_callender_2;
mod pi_chr_reg0;
mod pi_chr_reg20;
mod pi_cluett_wang_table;
mod pi_di_ruscio;
mod pi_fruehauf1993;
mod pi_gpm_exact;
mod pi_hay;
mod pi_hazebroek;
mod pi_kappatau_14;
mod pi_kappatau_20;
mod pi_kookos;
mod pi_labview;
mod pi_lambda_imc;
mod pi_maxki_ms;
mod pi_mrdp;
mod pi_odwyer2001;
mod pi_ogawa;
mod pi_oppelt_moros;
mod pi_parr;
mod pi_penner_126;
mod pi_penner_20;
mod pi_pole_placement_nodelay;
mod pi_poulin_1999;
mod pi_poulin_input;
mod pi_poulin_output;
mod pi_rotach;
mod pi_shamsuzzoha_skogestad;
mod pi_shinskey_1988;
mod pi_shinskey_1994;
mod pi_simc;
mod pi_skogestad2001_ms14;
mod pi_skogestad2001_ms17;
mod pi_skogestad2001_ms20;
mod pi_sym_opt;
mod pi_taguchi_araki;
mod pi_tyreus_luyben;
mod pi_wolfe_1;
mod pi_wolfe_2;
mod pi_zn_reaction;
mod pi_zn_ultimate;
mod pid_ali_majhi;
mod pid_sree_chidambaram;
mod pid_wang_cluett_z0707;
mod pid_wang_cluett_z1;

/// Every rule.
#[rustfmt::skip]
pub(super) static REGISTRY: &[&Entry] = &[
    &dob_kadam::ENTRY,
    &p_chr_servo0::ENTRY,
    &p_haalman::ENTRY,
    &p_labview::ENTRY,
    &p_mrdp::ENTRY,
    &p_viteckova_overshoot::ENTRY,
    &p_zn_reaction::ENTRY,
    &p_zn_ultimate::ENTRY,
    &pd_kadam::ENTRY,
    &pi_ah1995::ENTRY,
    &pi_ah2002::ENTRY,
    &pi_amigo::ENTRY,
    &pi_amigo_freq::ENTRY,
    &pi_averaging::ENTRY,
    &pi_callender_1::ENTRY,
    &pi_callender_2::ENTRY,
    &pi_chr_reg0::ENTRY,
    &pi_chr_reg20::ENTRY,
    &pi_cluett_wang_table::ENTRY,
    &pi_di_ruscio::ENTRY,
    &pi_fruehauf1993::ENTRY,
    &pi_gpm_exact::ENTRY,
    &pi_hay::ENTRY,
    &pi_hazebroek::ENTRY,
    &pi_kappatau_14::ENTRY,
    &pi_kappatau_20::ENTRY,
    &pi_kookos::ENTRY,
    &pi_labview::ENTRY,
    &pi_lambda_imc::ENTRY,
    &pi_maxki_ms::ENTRY,
    &pi_mrdp::ENTRY,
    &pi_odwyer2001::ENTRY,
    &pi_ogawa::ENTRY,
    &pi_oppelt_moros::ENTRY,
    &pi_parr::ENTRY,
    &pi_penner_126::ENTRY,
    &pi_penner_20::ENTRY,
    &pi_pole_placement_nodelay::ENTRY,
    &pi_poulin_1999::ENTRY,
    &pi_poulin_input::ENTRY,
    &pi_poulin_output::ENTRY,
    &pi_rotach::ENTRY,
    &pi_shamsuzzoha_skogestad::ENTRY,
    &pi_shinskey_1988::ENTRY,
    &pi_shinskey_1994::ENTRY,
    &pi_simc::ENTRY,
    &pi_skogestad2001_ms14::ENTRY,
    &pi_skogestad2001_ms17::ENTRY,
    &pi_skogestad2001_ms20::ENTRY,
    &pi_sym_opt::ENTRY,
    &pi_taguchi_araki::ENTRY,
    &pi_tyreus_luyben::ENTRY,
    &pi_wolfe_1::ENTRY,
    &pi_wolfe_2::ENTRY,
    &pi_zn_reaction::ENTRY,
    &pi_zn_ultimate::ENTRY,
    &pid_ali_majhi::ENTRY,
    &pid_sree_chidambaram::ENTRY,
    &pid_wang_cluett_z0707::ENTRY,
    &pid_wang_cluett_z1::ENTRY,
];
