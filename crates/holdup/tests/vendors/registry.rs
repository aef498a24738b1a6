//! The list of blocks, and what each must say.

use std::path::Path;

use holdup::deploy::conversion::{Weight, Weights, vendors};

use crate::sheets;

#[test]
fn registry_is_in_step_with_its_folder() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/deploy/vendors");
    let mut stems: Vec<String> = std::fs::read_dir(&folder)
        .unwrap()
        .filter_map(|entry| entry.unwrap().file_name().to_str()?.strip_suffix(".rs").map(str::to_owned))
        .filter(|stem| stem != "mod")
        .collect();
    stems.sort();
    let modules: String = stems.iter().fold(String::new(), |all, stem| all + "mod " + stem + ";\n");
    let list: String = stems.iter().fold(String::new(), |all, stem| all + "    &" + stem + "::ENTRY,\n");
    let right = format!(
        "//! The registered blocks, one file each.\n//!\n//! A test (`tests/vendors`) keeps the lines below in step \
         with the folder: never edit them by hand.\n\nuse super::conversion::Vendor;\n\n{modules}\n/// Every block.\n\
         #[rustfmt::skip]\npub(super) static REGISTRY: &[&Vendor] = &[\n{list}];\n"
    );
    let file = folder.join("mod.rs");
    if std::fs::read_to_string(&file).unwrap() != right {
        std::fs::write(&file, right).unwrap();
        panic!(
            "{} was not in step with the folder and has been rewritten: run the tests again",
            file.display()
        );
    }
    let ids: Vec<String> = vendors().iter().map(|vendor| vendor.id.replace('-', "_")).collect();
    assert_eq!(ids, stems, "file name and id differ");
}

#[test]
fn every_block_says_where_its_equation_comes_from_and_uses_no_name_twice() {
    for &vendor in vendors() {
        assert!(!vendor.source.citation.is_empty() && !vendor.source.read.is_empty(), "{}", vendor.id);
        assert!(vendor.equation.contains('=') && !vendor.equation.contains('\n'), "{}", vendor.id);
        if vendor.interacting {
            let free = matches!(vendor.weights, Weights::Choice { free: None, .. })
                || matches!(vendor.weights, Weights::Each { b: Weight::Fixed(_), c: Weight::Fixed(_) });
            assert!(free, "{}: free weights of an interacting block have no ideal form", vendor.id);
        }
    }
    for (vendor, _, _, sheet) in sheets() {
        let mut names: Vec<&str> = sheet.parameters.iter().map(|parameter| parameter.name).collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count, "{}: {names:?}", vendor.id);
    }
}
