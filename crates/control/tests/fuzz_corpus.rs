//! The corpus of the fuzz target `controller`, replayed, and bytes at random: whatever is set and comes in, the output
//! is finite and within its limits.

#[path = "../../../fuzz/drive/controller.rs"]
mod controller;

use std::path::Path;

use controller::drive;
use proptest::prelude::*;

#[test]
fn the_corpus_keeps_the_output_finite_and_within_its_limits() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/controller");
    let (mut files, mut updates) = (0, 0);
    for entry in std::fs::read_dir(folder).unwrap() {
        updates += drive(&std::fs::read(entry.unwrap().path()).unwrap());
        files += 1;
    }
    // A corpus whose settings were all refused would check nothing.
    assert!(files >= 20 && updates > 10 * files, "{updates} updates in {files} files");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]
    #[test]
    fn random_bytes_keep_the_output_finite_and_within_its_limits(data in prop::collection::vec(any::<u8>(), 0..500)) {
        drive(&data);
    }
}
