//! System commands that steps of `test` start, and their installation on Debian and Ubuntu.

use std::env;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use anyhow::bail;

use crate::node;
use crate::project;

/// Software on the system that steps require.
struct Requirement {
    steps: &'static [&'static str],
    purpose: &'static str,
    /// Debian packages that contain the software.
    packages: &'static [&'static str],
    is_met: fn(&'static [&'static str]) -> bool,
}

const REQUIREMENTS: &[Requirement] = &[
    Requirement {
        steps: &["dependencies", "workflows", "hooks", "reports", "python", "editors"],
        purpose: "Python, which installs tools below target",
        packages: &["python3", "python3-venv"],
        is_met: |_| node::python().is_some(),
    },
    Requirement {
        steps: &["python"],
        purpose: "an FTP server",
        packages: &["vsftpd"],
        is_met: |_| is_system_command("vsftpd"),
    },
    Requirement {
        steps: &["coverage"],
        purpose: "readers of reports",
        packages: &["lcov", "libxml2-utils"],
        is_met: |_| ["genhtml", "xmllint"].iter().all(|command| starts(command)),
    },
    Requirement {
        steps: &["editors"],
        purpose: "editors, a browser, and a compiler for native modules",
        packages: &[
            "chromium-headless-shell",
            "emacs-nox",
            "elpa-dap-mode",
            "elpa-eglot",
            "elpa-lsp-mode",
            "fonts-dejavu-core",
            "g++",
            "kakoune",
            "libkf5syntaxhighlighting-tools",
            "make",
            "ripgrep",
            "vim-ale",
            "vim-nox",
            "xz-utils",
        ],
        is_met: are_installed,
    },
    Requirement {
        steps: &["tests", "hooks"],
        purpose: "the download of releases",
        packages: &["curl"],
        is_met: |_| starts("curl"),
    },
];

/// Returns the packages that the named steps need and the machine does not have. Prints a line on each group.
///
/// # Errors
/// Packages are missing, and this user or system cannot install them with apt-get.
pub fn missing(steps: &[&str]) -> anyhow::Result<Vec<&'static str>> {
    let needed = REQUIREMENTS.iter().filter(|requirement| requirement.steps.iter().any(|step| steps.contains(step)));
    let missing: Vec<_> = needed.filter(|requirement| !(requirement.is_met)(requirement.packages)).collect();
    let packages: Vec<&str> = missing.iter().flat_map(|requirement| requirement.packages).copied().collect();
    let listed: String = missing.iter().map(|requirement| line(requirement, steps)).collect();
    if packages.is_empty() {
        return Ok(packages);
    }
    if !can_install() {
        bail!("{}", refusal(&listed, &packages, &affected(&missing, steps)));
    }
    eprint!("will install with apt-get:\n{listed}");
    Ok(packages)
}

/// Installs Debian packages.
///
/// # Errors
/// `apt-get` fails.
pub fn install(packages: &[&str]) -> anyhow::Result<()> {
    if packages.is_empty() {
        return Ok(());
    }
    apt_get(&["update", "-qq"])?;
    apt_get(&[&["install", "-qq", "-y", "--no-install-recommends"], packages].concat())
}

fn apt_get(arguments: &[&str]) -> anyhow::Result<()> {
    let mut command = Command::new("apt-get");
    command.args(arguments).env("DEBIAN_FRONTEND", "noninteractive").stdin(Stdio::null()).stdout(Stdio::null());
    project::succeed(&mut command)
}

/// Formats a requirement with its packages and the steps that need it.
fn line(requirement: &Requirement, steps: &[&str]) -> String {
    let needing: Vec<&str> = requirement.steps.iter().filter(|step| steps.contains(step)).copied().collect();
    format!("  {} ({}), for: {}\n", requirement.packages.join(" "), requirement.purpose, needing.join(", "))
}

/// Returns the steps that need a missing requirement.
fn affected<'s>(missing: &[&Requirement], steps: &[&'s str]) -> Vec<&'s str> {
    let mut affected = steps.to_vec();
    affected.retain(|step| missing.iter().any(|requirement| requirement.steps.contains(step)));
    affected
}

fn refusal(listed: &str, packages: &[&str], steps: &[&str]) -> String {
    format!(
        "steps need packages that are not installed, and only root on Debian or Ubuntu can install them here:\n{listed}\
         help: apt-get install --no-install-recommends {}\n\
         help: leave the steps out: cargo xtask test --without {}",
        packages.join(" "),
        steps.join(" ")
    )
}

/// Whether this user can install Debian packages.
fn can_install() -> bool {
    let user = Command::new("id").arg("-u").output();
    user.is_ok_and(|output| output.stdout.trim_ascii() == b"0") && starts("apt-get") && starts("dpkg-query")
}

fn starts(command: &str) -> bool {
    Command::new(command).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// Whether a command exists that users do not start, and which therefore may be outside of their `PATH`.
fn is_system_command(command: &str) -> bool {
    let path = env::var_os("PATH").unwrap_or_default();
    let mut folders = env::split_paths(&path).chain([PathBuf::from("/usr/sbin")]);
    folders.any(|folder| folder.join(command).is_file())
}

fn are_installed(packages: &'static [&'static str]) -> bool {
    let query =
        Command::new("dpkg-query").args(["--show", "--showformat", "${db:Status-Status}\n"]).args(packages).output();
    query.is_ok_and(|output| {
        let states = String::from_utf8_lossy(&output.stdout);
        output.status.success() && states.lines().all(|state| state == "installed")
    })
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_refusal_names_packages_and_the_steps_to_leave_out() {
        let steps = ["tests", "reports", "coverage"];
        let groups = ["python3", "lcov"];
        let missing = REQUIREMENTS.iter().filter(|requirement| groups.contains(&requirement.packages[0]));
        let missing: Vec<&Requirement> = missing.collect();
        let packages: Vec<&str> = missing.iter().flat_map(|requirement| requirement.packages).copied().collect();
        let listed: String = missing.iter().map(|requirement| line(requirement, &steps)).collect();
        expect![[r#"
            steps need packages that are not installed, and only root on Debian or Ubuntu can install them here:
              python3 python3-venv (Python, which installs tools below target), for: reports
              lcov libxml2-utils (readers of reports), for: coverage
            help: apt-get install --no-install-recommends python3 python3-venv lcov libxml2-utils
            help: leave the steps out: cargo xtask test --without reports coverage"#]]
        .assert_eq(&refusal(&listed, &packages, &affected(&missing, &steps)));
    }

    #[test]
    fn steps_of_cargo_need_nothing() {
        assert_eq!(missing(&["format", "clippy", "documentation"]).unwrap(), Vec::<&str>::new());
    }
}
