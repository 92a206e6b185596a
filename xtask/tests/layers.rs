//! Layers of the project: the crates that each crate may use.
//!
//! ARCHITECTURE.md explains them. Planned crates are already listed here, so that they follow the rules from their
//! first version.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use std::collections::{BTreeMap, BTreeSet};

use camino::{Utf8Path, Utf8PathBuf};
use cargo_metadata::{DependencyKind, Metadata, MetadataCommand, Package};

/// Crates that analyse programs.
const ANALYSIS: &[&str] =
    &["val3-fmt", "val3-analysis", "val3-check", "val3-diff", "val3-merge", "val3-ide", "val3-lsp", "val3-mcp"];

/// Crates that run programs.
const RUNTIME: &[&str] = &["val3-bytecode", "val3-vm", "val3-machine", "val3-debug", "val3-trace", "val3-view"];

/// Crates that connect both.
const BRIDGES: &[&str] = &["val3-compile", "val3-session", "val3-service", "val3-suite", "val3-dap", "val3"];

/// Packages that implement a protocol or serve connections.
const PROTOCOL_PACKAGES: &[&str] =
    &["rmcp", "tower-lsp", "lsp-types", "lsp-server", "dap", "dapts", "tokio", "axum", "hyper", "hyper-util"];

/// Packages that serve the page of a run, which only the command may use: val3-view defines the page's messages, but
/// does not serve them.
const PAGE_PACKAGES: &[&str] = &["tokio", "axum", "hyper", "hyper-util"];

/// Returns each workspace crate's direct dependencies, without test dependencies.
fn dependencies(metadata: &Metadata) -> BTreeMap<&str, BTreeSet<&str>> {
    let own = |package: &'_ Package| metadata.workspace_members.contains(&package.id);
    metadata
        .packages
        .iter()
        .filter(|package| own(package))
        .map(|package| (package.name.as_str(), normal(package)))
        .collect()
}

fn normal(package: &Package) -> BTreeSet<&str> {
    let kept = package.dependencies.iter().filter(|dependency| dependency.kind != DependencyKind::Development);
    kept.map(|dependency| dependency.name.as_str()).collect()
}

/// Returns the crates of the workspace that `name` reaches.
fn reached<'a>(name: &'a str, all: &BTreeMap<&'a str, BTreeSet<&'a str>>) -> BTreeSet<&'a str> {
    let mut reached = BTreeSet::new();
    let mut open = vec![name];
    while let Some(name) = open.pop() {
        let direct = all.get(name).into_iter().flatten().filter(|dependency| all.contains_key(*dependency));
        open.extend(direct.filter(|dependency| reached.insert(**dependency)));
    }
    reached
}

fn metadata() -> Metadata {
    MetadataCommand::new().no_deps().exec().unwrap()
}

#[track_caller]
fn assert_none(found: BTreeSet<&str>, rule: &str) {
    assert!(found.is_empty(), "{rule}: {found:?}");
}

/// Checks that `name` depends only on `allowed` crates, and on no forbidden package.
fn check_only(name: &str, allowed: &[&str], forbidden_packages: &[&str]) {
    let metadata = metadata();
    let all = dependencies(&metadata);
    let Some(direct) = all.get(name) else { return };
    let is_allowed = |name: &str| allowed.contains(&name) || !all.contains_key(name);
    let wrong = direct.iter().filter(|name| !is_allowed(name) || forbidden_packages.contains(name));
    assert_none(wrong.copied().collect(), &format!("{name} may not depend on"));
}

#[test]
fn syntax_knows_text_alone() {
    check_only("val3-syntax", &[], &["salsa", "serde", "serde_json", "clap", "tokio", "camino"]);
}

#[test]
fn geometry_knows_numbers_alone() {
    check_only("val3-geometry", &[], &["salsa", "rowan", "serde", "serde_json", "clap", "tokio", "camino"]);
}

#[test]
fn kinematics_knows_geometry_and_lines() {
    check_only("val3-kinematics", &["val3-geometry", "val3-lines"], &["salsa", "rowan", "clap", "tokio", "camino"]);
}

#[test]
fn moves_know_poses_and_configurations_alone() {
    check_only("val3-moves", &["val3-geometry", "val3-kinematics"], &["salsa", "rowan", "clap", "tokio", "camino"]);
}

#[test]
fn collision_knows_poses_alone() {
    check_only("val3-collision", &["val3-geometry"], &["salsa", "rowan", "clap", "tokio", "camino"]);
}

#[test]
fn schemas_know_no_crate_of_the_project() {
    check_only("val3-schema", &[], &["salsa", "rowan", "clap", "tokio", "camino"]);
}

#[test]
fn soap_knows_messages_alone() {
    check_only("val3-soap", &[], &["salsa", "rowan", "clap", "tokio", "camino", "axum", "hyper"]);
}

#[test]
fn lang_knows_no_tree() {
    check_only("val3-lang", &["val3-geometry", "val3-kinematics", "val3-moves"], &["salsa", "rowan", "clap", "tokio"]);
}

#[test]
fn data_files_know_trees_and_types() {
    check_only(
        "val3-data",
        &["val3-syntax", "val3-lang"],
        &["salsa", "rowan", "serde", "serde_json", "clap", "tokio", "camino"],
    );
}

#[test]
fn files_know_no_other_crate() {
    check_only("val3-files", &[], &["salsa", "rowan", "serde", "clap", "tokio"]);
}

#[test]
fn controllers_know_files_alone() {
    check_only("val3-controller", &["val3-files"], &["salsa", "rowan", "clap", "tokio"]);
}

#[test]
fn lines_know_text_alone() {
    check_only("val3-lines", &[], &["salsa", "rowan", "serde", "serde_json", "clap", "tokio", "camino"]);
}

#[test]
fn the_adapter_knows_runs_and_no_transport() {
    let below = [
        "val3-debug",
        "val3-geometry",
        "val3-lang",
        "val3-machine",
        "val3-motion",
        "val3-schema",
        "val3-session",
        "val3-view",
        "val3-vm",
    ];
    check_only("val3-dap", &below, &["salsa", "rowan", "clap", "tokio", "camino"]);
}

#[test]
fn the_service_knows_runs_and_no_transport() {
    let below = [
        "val3-bytecode",
        "val3-debug",
        "val3-geometry",
        "val3-kinematics",
        "val3-lang",
        "val3-machine",
        "val3-moves",
        "val3-session",
        "val3-soap",
        "val3-vm",
    ];
    check_only("val3-service", &below, &["salsa", "rowan", "clap", "tokio", "camino", "quick-xml"]);
}

#[test]
fn reports_of_coverage_know_counts_alone() {
    check_only("val3-coverage", &[], &["salsa", "rowan", "clap", "tokio", "camino"]);
}

#[test]
fn tests_know_controllers_and_no_threads() {
    let below = [
        "val3-analysis",
        "val3-bytecode",
        "val3-cell",
        "val3-coverage",
        "val3-debug",
        "val3-geometry",
        "val3-lang",
        "val3-lines",
        "val3-machine",
        "val3-plot",
        "val3-session",
        "val3-trace",
    ];
    check_only("val3-suite", &below, &["salsa", "rowan", "clap", "rayon", "tokio", "camino"]);
}

/// Configurations, arms, assembled texts and scenarios have lines, because their errors are shown unchanged.
#[test]
fn below_the_editor_features_there_are_no_columns() {
    let metadata = metadata();
    let files = ["val3-config", "val3-kinematics", "val3-bytecode", "val3-suite"];
    let above = ["val3-compile", "val3-session", "val3-lsp", "val3"];
    let all = dependencies(&metadata);
    let counting = all
        .iter()
        .filter(|(name, direct)| direct.contains("val3-lines") && ![&files[..], &above].concat().contains(name));
    assert_none(counting.map(|(name, _)| *name).collect(), "may not count lines");
}

#[test]
fn modbus_knows_a_file_and_no_signal() {
    check_only("val3-modbus", &["val3-syntax"], &["salsa", "serde", "clap", "tokio", "camino"]);
}

#[test]
fn config_knows_the_language_alone() {
    check_only("val3-config", &["val3-lang", "val3-lines"], &["salsa", "rowan", "clap", "tokio"]);
}

#[test]
fn analysis_depends_on_syntax_lang_and_config() {
    let below = [
        "val3-cell",
        "val3-files",
        "val3-syntax",
        "val3-lang",
        "val3-config",
        "val3-geometry",
        "val3-kinematics",
        "val3-modbus",
    ];
    check_only("val3-analysis", &below, &["clap", "serde_json", "toml", "tokio"]);
    let below = [&below[..], &["val3-analysis", "val3-motion"]].concat();
    check_only("val3-check", &below, &["clap", "serde_json", "toml", "tokio"]);
}

#[test]
fn comparison_knows_declarations_and_places() {
    let below = ["val3-syntax", "val3-lang", "val3-geometry", "val3-analysis"];
    check_only("val3-diff", &below, &["salsa", "clap", "tokio"]);
}

#[test]
fn merging_knows_trees_and_values() {
    check_only("val3-merge", &["val3-syntax", "val3-lang", "val3-data"], &["salsa", "clap", "tokio", "camino"]);
}

#[test]
fn backups_know_trees_and_the_tables_of_the_language() {
    let forbidden = ["salsa", "rowan", "clap", "tokio", "camino"];
    check_only("val3-backup", &["val3-syntax", "val3-lang"], &forbidden);
}

#[test]
fn layout_knows_trees_and_settings() {
    check_only("val3-fmt", &["val3-syntax", "val3-config"], &["salsa", "clap", "tokio"]);
}

#[test]
fn vm_and_motion_do_not_know_each_other() {
    check_only("val3-vm", &["val3-lang", "val3-bytecode"], &["salsa", "rowan", "tokio"]);
    check_only("val3-motion", &["val3-geometry", "val3-kinematics", "val3-moves"], &["salsa", "rowan", "tokio"]);
}

#[test]
fn the_cell_knows_arms_and_distances() {
    let below = ["val3-collision", "val3-geometry", "val3-kinematics"];
    check_only("val3-cell", &below, &["salsa", "rowan", "clap", "tokio", "parry3d-f64"]);
}

#[test]
fn the_machine_depends_on_the_vm_and_the_arm() {
    let below = [
        "val3-cell",
        "val3-syntax",
        "val3-lang",
        "val3-data",
        "val3-geometry",
        "val3-bytecode",
        "val3-vm",
        "val3-kinematics",
        "val3-motion",
    ];
    check_only("val3-machine", &below, &["salsa", "clap", "tokio"]);
}

#[test]
fn the_debugger_knows_the_controller_and_no_protocol() {
    check_only(
        "val3-debug",
        &["val3-geometry", "val3-lang", "val3-bytecode", "val3-vm", "val3-machine"],
        &["salsa", "serde", "tokio"],
    );
}

#[test]
fn the_view_knows_the_controller_and_no_protocol() {
    let below = [
        "val3-bytecode",
        "val3-cell",
        "val3-debug",
        "val3-geometry",
        "val3-kinematics",
        "val3-lang",
        "val3-machine",
        "val3-motion",
        "val3-syntax",
        "val3-vm",
    ];
    check_only("val3-view", &below, &["salsa", "rowan", "clap", "tokio", "axum"]);
}

#[test]
fn traces_know_the_controller_and_no_file() {
    let below =
        ["val3-geometry", "val3-kinematics", "val3-lang", "val3-machine", "val3-motion", "val3-plot", "val3-vm"];
    check_only("val3-trace", &below, &["salsa", "rowan", "clap", "tokio", "camino"]);
}

#[test]
fn the_two_towers_do_not_touch() {
    let metadata = metadata();
    let all = dependencies(&metadata);
    for (tower, other) in [(ANALYSIS, RUNTIME), (RUNTIME, ANALYSIS)] {
        for name in tower.iter().filter(|name| all.contains_key(**name)) {
            let wrong = reached(name, &all).into_iter().filter(|reached| other.contains(reached)).collect();
            assert_none(wrong, &format!("{name} reaches the other tower"));
        }
    }
}

#[test]
fn every_crate_has_its_place() {
    let metadata = metadata();
    let below = [
        "val3-geometry",
        "val3-kinematics",
        "val3-collision",
        "val3-cell",
        "val3-moves",
        "val3-motion",
        "val3-plot",
        "val3-coverage",
        "val3-syntax",
        "val3-lang",
        "val3-data",
        "val3-lines",
        "val3-files",
        "val3-controller",
        "val3-schema",
        "val3-modbus",
        "val3-soap",
        "val3-config",
        "val3-backup",
        "val3-test",
        "val3-generate",
        "val3-tests",
        "val3-benches",
        "xtask",
    ];
    let known: BTreeSet<_> = [ANALYSIS, RUNTIME, BRIDGES, &below].into_iter().flatten().copied().collect();
    let strangers = dependencies(&metadata).into_keys().filter(|name| !known.contains(name)).collect();
    assert_none(strangers, "name the crate's place in this test");
}

#[test]
fn only_the_servers_speak_protocols() {
    let metadata = metadata();
    let all = dependencies(&metadata);
    for (name, direct) in all.iter().filter(|(name, _)| !["val3-lsp", "val3-dap", "val3-mcp"].contains(name)) {
        let allowed = if *name == "val3" { PAGE_PACKAGES } else { &[] };
        let is_wrong = |package: &&&str| PROTOCOL_PACKAGES.contains(package) && !allowed.contains(package);
        assert_none(direct.iter().filter(is_wrong).copied().collect(), &format!("{name} may not speak a protocol"));
    }
}

#[test]
fn only_the_binaries_decide_on_threads() {
    let metadata = metadata();
    let binaries = ["val3", "val3-lsp", "val3-benches"];
    for (name, direct) in dependencies(&metadata).iter().filter(|(name, _)| !binaries.contains(name)) {
        assert!(!direct.contains("rayon"), "{name} may not start threads");
    }
}

#[test]
fn fixtures_serve_tests_alone() {
    let metadata = metadata();
    for (name, direct) in dependencies(&metadata) {
        let test_crate = ["val3-tests", "val3-benches"].contains(&name);
        assert!(test_crate || !direct.contains("val3-test"), "{name} ships the fixtures of the tests");
    }
}

#[test]
fn xtask_builds_without_the_toolchain() {
    let metadata = metadata();
    let all = dependencies(&metadata);
    assert_none(reached("xtask", &all), "xtask may not depend on");
}

#[test]
fn no_crate_below_the_binaries_touches_the_system() {
    let metadata = metadata();
    let pure = [
        "val3-geometry",
        "val3-kinematics",
        "val3-collision",
        "val3-cell",
        "val3-moves",
        "val3-motion",
        "val3-syntax",
        "val3-lang",
        "val3-data",
        "val3-lines",
        "val3-schema",
        "val3-modbus",
        "val3-soap",
        "val3-config",
        "val3-backup",
        "val3-dap",
        "val3-check",
        "val3-diff",
        "val3-merge",
        "val3-fmt",
        "val3-ide",
        "val3-trace",
        "val3-vm",
        "val3-kinematics",
        "val3-motion",
    ];
    for package in metadata.packages.iter().filter(|package| pure.contains(&package.name.as_str())) {
        let folder = package.manifest_path.parent().unwrap().join("src");
        let wrong = sources(&folder).into_iter().filter(|path| touches_the_system(path)).collect::<Vec<_>>();
        assert!(wrong.is_empty(), "{} touches files, processes or the network: {wrong:?}", package.name);
    }
}

fn touches_the_system(source: &Utf8Path) -> bool {
    let text = std::fs::read_to_string(source).unwrap();
    ["std::fs", "std::net", "std::process"].iter().any(|module| text.contains(module))
}

fn sources(folder: &Utf8Path) -> Vec<Utf8PathBuf> {
    let entries = folder.read_dir_utf8().unwrap().map(|entry| entry.unwrap().into_path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|path| path.is_dir());
    let nested = folders.iter().flat_map(|folder| sources(folder));
    nested.chain(files.into_iter().filter(|path| path.extension() == Some("rs"))).collect()
}
