//! `mutations`: how many mistakes in an application its tests find.
//!
//! Each mistake is one small change of a program or of data in a copy of the folder. A mistake is found if `val3 test` fails.
//! Mistakes that the compiler refuses are left out, because no test is needed for them.

mod sites;

use std::collections::BTreeMap;
use std::process::{Command, Output};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{fs, thread};

use anyhow::{Context, bail};
use camino::{Utf8Path, Utf8PathBuf};

use crate::project;
use sites::{Site, sites};

/// The exit code of `val3 test` where a test has failed.
const FAILED: i32 = 1;

/// Options of `mutations`.
#[derive(clap::Args)]
pub struct Arguments {
    /// The folder that is copied: applications and tests, relative to the project
    #[arg(long, default_value = "examples/palletiser")]
    folder: Utf8PathBuf,
    /// The applications that get mistakes, relative to the folder
    #[arg(long, default_values = ["usr/usrapp/palletiser", "usr/usrapp/partBox", "usr/usrapp/partBag"])]
    application: Vec<Utf8PathBuf>,
    /// The tests, relative to the folder
    #[arg(long, default_value = "tests")]
    tests: Utf8PathBuf,
    /// The number of mistakes to try
    #[arg(long, default_value_t = 100)]
    count: usize,
    /// The seed of the choice
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

/// The result of the tests with one mistake.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Verdict {
    Found,
    Missed,
    Refused,
}

/// Prints the mistakes that the tests have missed, and how many they have found.
///
/// # Errors
/// When the tests fail without a mistake, or a file cannot be copied.
pub fn run(arguments: &Arguments) -> anyhow::Result<()> {
    project::succeed(&mut project::cargo(&["build", "--locked", "--package", "val3"]))?;
    let bench = Bench::new(arguments)?;
    let scratch = bench.copy("clean")?;
    let clean = bench.test(&scratch)?;
    if !clean.status.success() {
        bail!("the tests fail without a mistake:\n{}", String::from_utf8_lossy(&clean.stdout));
    }
    let mut sites = Vec::new();
    for application in &arguments.application {
        sites.extend(self::sites(&bench.folder, application)?);
    }
    shuffle(&mut sites, arguments.seed);
    let verdicts = bench.verdicts(&sites, arguments.count)?;
    report(&sites, &verdicts, sites.len());
    Ok(())
}

fn report(sites: &[Site], verdicts: &BTreeMap<usize, Verdict>, all: usize) {
    let count = |verdict| verdicts.values().filter(|found| **found == verdict).count();
    for (number, _) in verdicts.iter().filter(|(_, verdict)| **verdict == Verdict::Missed) {
        if let Some(site) = sites.get(*number) {
            println!("missed: {site}");
        }
    }
    let (found, missed) = (count(Verdict::Found), count(Verdict::Missed));
    println!(
        "{found} of {} mistakes found; {} refused by the compiler; {all} places",
        found + missed,
        count(Verdict::Refused)
    );
}

/// The folder, the tests, and the command that executes them.
struct Bench {
    folder: Utf8PathBuf,
    tests: Utf8PathBuf,
    scratch: Utf8PathBuf,
    val3: Utf8PathBuf,
}

impl Bench {
    fn new(arguments: &Arguments) -> anyhow::Result<Self> {
        let scratch = project::target_folder()?.join("mutations");
        Ok(Self {
            folder: project::root().join(&arguments.folder),
            tests: arguments.tests.clone(),
            scratch,
            val3: project::binary("debug")?,
        })
    }

    /// Tries mistakes in order until `count` of them were executed.
    fn verdicts(&self, sites: &[Site], count: usize) -> anyhow::Result<BTreeMap<usize, Verdict>> {
        let (next, done) = (AtomicUsize::new(0), Mutex::new(BTreeMap::new()));
        let is_complete = || executed(&done) >= count;
        let work = |thread: usize| -> anyhow::Result<()> {
            let scratch = self.copy(&thread.to_string())?;
            while !is_complete() {
                let number = next.fetch_add(1, Ordering::Relaxed);
                let Some(site) = sites.get(number) else { break };
                let verdict = self.verdict(site, &scratch)?;
                if let Ok(mut done) = done.lock() {
                    done.insert(number, verdict);
                }
            }
            Ok(())
        };
        thread::scope(|scope| {
            let workers: Vec<_> = (0..threads()).map(|thread| scope.spawn(move || work(thread))).collect();
            workers.into_iter().try_for_each(|worker| worker.join().unwrap_or_else(|_| bail!("a thread has failed")))
        })?;
        done.into_inner().context("a thread has failed")
    }

    fn verdict(&self, site: &Site, scratch: &Utf8Path) -> anyhow::Result<Verdict> {
        let path = scratch.join(&site.file);
        let text = fs::read_to_string(&path)?;
        fs::write(&path, site.applied(&text))?;
        let output = self.test(scratch);
        fs::write(&path, text)?;
        Ok(match output?.status.code() {
            Some(0) => Verdict::Missed,
            Some(FAILED) => Verdict::Found,
            _ => Verdict::Refused,
        })
    }

    fn test(&self, scratch: &Utf8Path) -> anyhow::Result<Output> {
        let mut command = Command::new(&self.val3);
        command.arg("test").arg(&self.tests).args(["--fail-fast", "--jobs", "1", "--limit", "30"]);
        command.current_dir(scratch).output().with_context(|| format!("cannot start {}", self.val3))
    }

    /// A copy of the folder.
    fn copy(&self, name: &str) -> anyhow::Result<Utf8PathBuf> {
        let target = self.scratch.join(name);
        if target.exists() {
            fs::remove_dir_all(&target)?;
        }
        copy(&self.folder, &target).with_context(|| format!("cannot copy {}", self.folder))?;
        Ok(target)
    }
}

fn executed(done: &Mutex<BTreeMap<usize, Verdict>>) -> usize {
    done.lock().map_or(usize::MAX, |done| done.values().filter(|verdict| **verdict != Verdict::Refused).count())
}

fn threads() -> usize {
    thread::available_parallelism().map_or(1, std::num::NonZero::get)
}

fn copy(from: &Utf8Path, to: &Utf8Path) -> anyhow::Result<()> {
    fs::create_dir_all(to)?;
    for entry in from.read_dir_utf8()? {
        let entry = entry?;
        let target = to.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            copy(entry.path(), &target)?;
        } else {
            fs::copy(entry.path(), target)?;
        }
    }
    Ok(())
}

/// A random order that the seed decides (xorshift, Fisher and Yates).
fn shuffle(sites: &mut [Site], seed: u64) {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    for last in (1..sites.len()).rev() {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        sites.swap(last, usize::try_from(state % (last as u64 + 1)).unwrap_or(0));
    }
}
