//! What every law must keep: one test body for each contract, one line for each law.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

mod arbitrary;
mod bumpless;
mod continuous;
mod convergence;
mod laws;
mod limits;
mod plant;
mod precision;

macro_rules! laws {
    ($($law:ident)*) => {$(
        mod $law {
            use crate::laws::law;

            laws!(@contracts $law
                limits::the_limits_are_never_exceeded
                limits::saturation_ends_when_the_setpoint_is_reached
                limits::the_loop_recovers_from_an_output_that_was_not_applied
                bumpless::switching_to_automatic_does_not_move_the_output
                bumpless::manual_output_may_begin_where_automatic_stood
                bumpless::other_settings_do_not_move_the_output
                bumpless::a_return_of_the_measurement_does_not_move_the_output
                precision::f32_is_close_to_f64
                precision::a_constant_measurement_at_the_setpoint_moves_nothing
                precision::a_constant_measurement_brings_the_state_back_to_itself
                precision::a_restored_state_continues_bit_for_bit
                precision::other_units_give_the_same_answer
                arbitrary::any_input_gives_a_finite_output_within_the_limits
                arbitrary::the_loop_returns_to_the_setpoint_after_any_input
                convergence::the_sampled_loop_tends_to_the_continuous_one_in_first_order
                convergence::early_and_late_samples_change_little
            );

            #[test]
            #[ignore = "takes minutes: 1e9 samples"]
            fn a_constant_measurement_at_the_setpoint_moves_nothing_in_1e9_samples() {
                crate::precision::constant_measurement(&law(stringify!($law)), 1_000_000_000);
            }
        }
    )*};
    (@contracts $law:ident $($file:ident::$contract:ident)*) => {$(
        #[test]
        fn $contract() {
            crate::$file::$contract(&law(stringify!($law)));
        }
    )*};
}

laws! {
    p
    pi
    pd
    pd_without_filter
    pid
    pid_with_setpoint_weights
    pd_with_observer
    pid_with_observer
    smith_predictor_1996
    smith_predictor_1999
}

#[test]
fn every_law_is_under_contract() {
    let source = include_str!("main.rs");
    let list = &source[source.find("\nlaws! {\n").unwrap()..];
    for (name, _) in laws::ALL {
        assert!(list.contains(&format!("    {name}\n")), "{name} has no line");
    }
}
