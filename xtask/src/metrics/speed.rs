//! Time and memory of the packed binary for a generated workspace.

use std::process::{Child, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use anyhow::{Context, bail};
use camino::Utf8Path;

use crate::{project, workspace};

/// Number of runs. The fastest one counts, because the other ones were disturbed.
const RUNS: usize = 5;

/// Time and memory of a run.
struct Measurement {
    duration: Duration,
    /// Largest resident memory in kB, if the system reports it.
    peak_kilobytes: Option<u64>,
}

/// Generates a workspace of `lines` code lines, checks it, and prints time and memory.
pub(super) fn measure(lines: usize) -> anyhow::Result<()> {
    let folder = project::root().join("target/metrics");
    let code_lines = write_workspace(&folder, lines)?;
    let mut fastest: Option<Measurement> = None;
    for _ in 0..RUNS {
        let run = check(&folder)?;
        if fastest.as_ref().is_none_or(|fastest| run.duration < fastest.duration) {
            fastest = Some(run);
        }
    }
    if let Some(run) = fastest {
        print(code_lines, &run);
    }
    Ok(())
}

pub(super) fn write_workspace(folder: &Utf8Path, lines: usize) -> anyhow::Result<usize> {
    if folder.exists() {
        std::fs::remove_dir_all(folder).with_context(|| format!("cannot clear {folder}"))?;
    }
    workspace::write(folder, &workspace::generate(lines, 1))
}

fn check(folder: &Utf8Path) -> anyhow::Result<Measurement> {
    let started = Instant::now();
    let mut child = std::process::Command::new(project::binary(project::DIST)?)
        .args(["check", "--format", "concise", folder.as_str()])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .context("cannot start val3")?;
    let (status, peak_kilobytes) = watch(&mut child)?;
    if !status.success() {
        bail!("val3 check {folder} ended with {status}: the generated workspace has faults");
    }
    Ok(Measurement { duration: started.elapsed(), peak_kilobytes })
}

/// Waits for the end of the process and polls its memory meanwhile.
fn watch(child: &mut Child) -> anyhow::Result<(ExitStatus, Option<u64>)> {
    let mut peak = None;
    loop {
        peak = peak_kilobytes(child.id()).max(peak);
        if let Some(status) = child.try_wait()? {
            return Ok((status, peak));
        }
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Returns the `VmHWM` of a running process (Linux).
pub(super) fn peak_kilobytes(process: u32) -> Option<u64> {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix(" kB")?.parse().ok()
}

fn print(code_lines: usize, run: &Measurement) {
    let seconds = run.duration.as_secs_f64();
    println!("val3 check, cold, fastest of {RUNS}");
    println!("{code_lines} code lines in {seconds:.3} s: {:.0} code lines/s", code_lines as f64 / seconds);
    match run.peak_kilobytes {
        Some(kilobytes) => println!("peak memory {:.1} MB", kilobytes as f64 / 1000.0),
        None => println!("peak memory unknown on this system"),
    }
}
