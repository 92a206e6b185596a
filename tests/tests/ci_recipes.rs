//! The recipes in docs/src/ci.md for services without an action install a release from a mirror, and run it.
#![cfg(target_os = "linux")]
#![allow(clippy::disallowed_methods, clippy::unwrap_used, reason = "scripts run on real files, and a test may stop")]

use std::fs;
use std::process::Output;

use crate::scratch::{Scratch, TAG, error, text};
use camino::Utf8Path;

/// Archive that all recipes download.
const ARCHIVE: &str = "val3-1.2.3-x86_64-unknown-linux-musl";

/// Returns the first code block below a heading of the page.
fn recipe(heading: &str) -> String {
    let page = fs::read_to_string(Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/src/ci.md")).unwrap();
    let (_, section) = page.split_once(&format!("## {heading}\n")).unwrap();
    section.split("```").nth(1).unwrap().split_once('\n').unwrap().1.to_owned()
}

/// Returns the commands in the entries `before_script` and `script` of GitLab.
fn gitlab() -> String {
    let recipe = recipe("GitLab");
    let mut is_script = false;
    let mut commands = String::new();
    for line in recipe.lines() {
        if let Some(command) = line.strip_prefix("    - ").filter(|_| is_script) {
            commands += &format!("{command}\n");
        } else {
            is_script = ["before_script:", "script:"].contains(&line.trim());
        }
    }
    commands
}

/// Returns the block in the first step of Azure Pipelines.
fn azure() -> String {
    let recipe = recipe("Azure Pipelines");
    let (_, block) = recipe.split_once("- bash: |\n").unwrap();
    block.lines().take_while(|line| line.starts_with("      ")).map(|line| format!("{}\n", line.trim())).collect()
}

/// Returns the first script of Jenkins.
fn jenkins() -> String {
    recipe("Jenkins").split("'''").nth(1).unwrap().to_owned()
}

/// Runs a script like a service, in a temporary folder.
fn run(scratch: &Scratch, script: &str, environment: &[(&str, &str)]) -> Output {
    let project = scratch.path("project");
    fs::create_dir_all(&project).unwrap();
    let mut command = scratch.command("bash");
    command.args(["-e", "-c", script]).current_dir(&project).env("VAL3_VERSION", "1.2.3").env("VAL3", ARCHIVE);
    command.env("CI_PROJECT_DIR", &project).env("TMPDIR", scratch.path(""));
    command.env("AGENT_TEMPDIRECTORY", scratch.path("")).env("WORKSPACE_TMP", scratch.path("agent"));
    command.envs(environment.iter().copied()).output().unwrap()
}

fn released() -> Scratch {
    let scratch = Scratch::new();
    scratch.release_as(ARCHIVE, "echo released \"$@\"");
    scratch
}

fn check(script: &str, marks: &[&str]) {
    let scratch = released();
    let output = run(&scratch, script, &[]);
    assert!(output.status.success(), "{output:?}");
    let printed = text(&output.stdout);
    for mark in marks {
        assert!(printed.contains(mark), "{mark}: {printed}");
    }
    scratch.shell(&format!("echo more >>releases/{TAG}/{ARCHIVE}.tar.gz"));
    let output = run(&scratch, script, &[]);
    assert!(!output.status.success() && !text(&output.stdout).contains("released"), "{output:?}");
    let output = run(&scratch, script, &[("VAL3_RELEASES", "file:///nowhere")]);
    assert!(!output.status.success() && error(&output).contains("nowhere"), "{output:?}");
}

#[test]
fn gitlab_checks_and_tests() {
    check(&gitlab(), &[&format!("{ARCHIVE}.tar.gz: OK"), "released check .", "released test ."]);
}

#[test]
fn gitlab_fails_after_all_reports() {
    let scratch = released();
    scratch.release_as(ARCHIVE, "echo released \"$@\"; exit 1");
    let output = run(&scratch, &gitlab(), &[]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stdout).contains("released test ."), "{output:?}");
}

#[test]
fn azure_puts_the_command_on_the_path() {
    check(&azure(), &[&format!("{ARCHIVE}.tar.gz: OK"), "##vso[task.prependpath]"]);
    assert!(azure().ends_with("echo \"##vso[task.prependpath]$PWD/$archive\"\n"));
}

#[test]
fn jenkins_unpacks_into_the_folder_on_the_path() {
    let scratch = released();
    assert!(run(&scratch, &jenkins(), &[]).status.success());
    assert!(scratch.path(&format!("agent/{ARCHIVE}/val3")).is_file());
    assert!(recipe("Jenkins").contains("PATH = \"${WORKSPACE_TMP}/${VAL3}:${PATH}\""));
    check(&jenkins(), &[&format!("{ARCHIVE}.tar.gz: OK")]);
}
