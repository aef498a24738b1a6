//! The registered rules, one file each.
//!
//! A test (`tests/rules.rs`) keeps the lines below in step with the folder: never edit them by hand.

use super::Entry;

mod dipdt_pd_dalen_di_ruscio;
mod dipdt_pd_mrdp;
mod dipdt_pid_simc;
mod dob_exact;
mod dob_huba_p;
mod dob_kadam;
mod dob_zhong_normey_rico;
mod ifopdt_p_huba_zakova;
mod ifopdt_pd_haalman;
mod ifopdt_pi_huba_zakova;
mod ifopdt_pi_poulin_input;
mod ifopdt_pi_poulin_output;
mod ifopdt_pi_shinskey;
mod ifopdt_pid_imc_o;
mod ifopdt_pid_mcmillan;
mod ifopdt_pid_simc;
mod ladrc1;
mod msp_matausek_micic_1996;
mod msp_matausek_micic_1999;
mod p_chr_servo0;
mod p_haalman;
mod p_labview;
mod p_mrdp;
mod p_viteckova_overshoot;
mod p_zn_reaction;
mod p_zn_ultimate;
mod pd_exact;
mod pd_kadam;
mod pd_mrdp;
mod pd_shinskey_ramp;
mod pd_shinskey_setpoint;
mod pd_visioli_ise;
mod pd_visioli_iste;
mod pd_visioli_itse;
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
mod sp_astrom_hang_lim;
mod sp_fsp_normey_rico;

/// Every rule.
#[rustfmt::skip]
pub(super) static REGISTRY: &[&Entry] = &[
    &dipdt_pd_dalen_di_ruscio::ENTRY,
    &dipdt_pd_mrdp::ENTRY,
    &dipdt_pid_simc::ENTRY,
    &dob_exact::ENTRY,
    &dob_huba_p::ENTRY,
    &dob_kadam::ENTRY,
    &dob_zhong_normey_rico::ENTRY,
    &ifopdt_p_huba_zakova::ENTRY,
    &ifopdt_pd_haalman::ENTRY,
    &ifopdt_pi_huba_zakova::ENTRY,
    &ifopdt_pi_poulin_input::ENTRY,
    &ifopdt_pi_poulin_output::ENTRY,
    &ifopdt_pi_shinskey::ENTRY,
    &ifopdt_pid_imc_o::ENTRY,
    &ifopdt_pid_mcmillan::ENTRY,
    &ifopdt_pid_simc::ENTRY,
    &ladrc1::ENTRY,
    &msp_matausek_micic_1996::ENTRY,
    &msp_matausek_micic_1999::ENTRY,
    &p_chr_servo0::ENTRY,
    &p_haalman::ENTRY,
    &p_labview::ENTRY,
    &p_mrdp::ENTRY,
    &p_viteckova_overshoot::ENTRY,
    &p_zn_reaction::ENTRY,
    &p_zn_ultimate::ENTRY,
    &pd_exact::ENTRY,
    &pd_kadam::ENTRY,
    &pd_mrdp::ENTRY,
    &pd_shinskey_ramp::ENTRY,
    &pd_shinskey_setpoint::ENTRY,
    &pd_visioli_ise::ENTRY,
    &pd_visioli_iste::ENTRY,
    &pd_visioli_itse::ENTRY,
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
    &sp_astrom_hang_lim::ENTRY,
    &sp_fsp_normey_rico::ENTRY,
];
