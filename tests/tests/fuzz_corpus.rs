//! The `fuzz` targets with the seeds in their corpus: no panic, and the laws hold. Fuzzing itself needs another
//! compiler.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may fail loudly")]

#[path = "../../fuzz/src/lib.rs"]
#[allow(missing_docs, unreachable_pub, reason = "a crate of another workspace")]
mod fuzz;

use std::collections::BTreeSet;
use std::fs;

use camino::{Utf8Path, Utf8PathBuf};
use fuzz::TARGETS;

fn folder() -> &'static Utf8Path {
    Utf8Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../fuzz"))
}

fn entries(name: &str) -> Vec<Utf8PathBuf> {
    let mut found: Vec<_> =
        folder().join(name).read_dir_utf8().unwrap().map(|entry| entry.unwrap().into_path()).collect();
    found.sort();
    found
}

fn names() -> BTreeSet<String> {
    TARGETS.iter().map(|target| target.name.to_owned()).collect()
}

#[test]
fn every_seed_keeps_the_laws() {
    for target in TARGETS {
        let seeds = entries(&format!("corpus/{}", target.name));
        assert!(!seeds.is_empty(), "{} has no seeds", target.name);
        for seed in seeds {
            println!("{seed}");
            (target.run)(&fs::read(&seed).unwrap());
        }
    }
}

/// Truncated seeds and seeds with another byte at the end are the first inputs of a fuzzer.
#[test]
fn parts_of_seeds_keep_the_laws() {
    for target in TARGETS {
        for seed in entries(&format!("corpus/{}", target.name)) {
            let bytes = fs::read(&seed).unwrap();
            for end in (0..bytes.len()).step_by(bytes.len() / 8 + 1) {
                println!("{seed} up to {end}");
                (target.run)(&bytes[..end]);
                (target.run)(&[&bytes[..end], &[0xff], &bytes[end..]].concat());
            }
        }
    }
}

/// Random programs, with a kilobyte of choices each.
#[test]
fn assists_of_random_programs_keep_the_law() {
    random_choices(0..40).for_each(|choices| fuzz::assists(&choices));
}

/// The same for minutes: to be run after changes of assists.
#[test]
#[ignore = "it takes minutes"]
fn assists_of_many_random_programs_keep_the_law() {
    let failures =
        random_choices(40..4000).filter(|choices| std::panic::catch_unwind(|| fuzz::assists(choices)).is_err());
    assert_eq!(failures.count(), 0, "programs failed");
}

/// Returns a kilobyte of choices for each seed.
fn random_choices(seeds: std::ops::Range<u64>) -> impl Iterator<Item = Vec<u8>> {
    seeds.map(|seed| {
        println!("seed {seed}");
        let mut state = seed;
        let next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state.to_be_bytes()[0]
        };
        std::iter::repeat_with(next).take(1024).collect()
    })
}

#[test]
fn every_target_is_in_all_lists() {
    let files = |folder: &str| -> BTreeSet<String> {
        entries(folder).iter().map(|path| path.file_stem().unwrap().to_owned()).collect()
    };
    assert_eq!(files("fuzz_targets"), names());
    assert_eq!(files("corpus"), names());
    let manifest = fs::read_to_string(folder().join("Cargo.toml")).unwrap();
    let bins: BTreeSet<String> =
        manifest.split("[[bin]]").skip(1).map(|bin| bin.split('"').nth(1).unwrap().to_owned()).collect();
    assert_eq!(bins, names());
    let workflow = fs::read_to_string(folder().join("../.github/workflows/scheduled.yml")).unwrap();
    let matrix = workflow.split("target: [").nth(1).unwrap().split(']').next().unwrap();
    assert_eq!(matrix.split(", ").map(str::to_owned).collect::<BTreeSet<_>>(), names());
}
