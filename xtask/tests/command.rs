//! `cargo install --git ADDRESS val3` finds one package with one command.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use cargo_metadata::MetadataCommand;

#[test]
fn one_package_has_the_command() {
    let metadata = MetadataCommand::new().current_dir(xtask::project::root()).no_deps().exec().unwrap();
    let named: Vec<_> = metadata.packages.iter().filter(|package| package.name.as_str() == "val3").collect();
    assert_eq!(named.iter().map(|package| commands(package)).collect::<Vec<_>>(), [["val3"]]);
    let others = metadata.packages.iter().filter(|package| package.name.as_str() != "val3");
    assert!(others.flat_map(commands).all(|command| command != "val3"));
}

fn commands(package: &cargo_metadata::Package) -> Vec<String> {
    let commands = package.targets.iter().filter(|target| target.is_bin());
    commands.map(|target| target.name.clone()).collect()
}
