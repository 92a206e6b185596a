//! Typical short robot programs in comparison with Lua 5.4: `cargo bench --bench ordinary`. Program names after `--`
//! select programs.
//!
//! A program is a listing (the format of `val3-test`) and a Lua file with the same name in `benches/programs/ordinary`.
//! Global data are globals in Lua, values of user types are tables. The output contains the milliseconds of both,
//! without the time to compile, and the time relative to Lua; the fastest of several runs counts.
//!
//! Target: a geometric mean of 0.8, and no program above 1.5.

#![allow(missing_docs, reason = "benchmarks are named by their functions")]
#![allow(clippy::expect_used, clippy::panic, reason = "a program that fails measures nothing")]
#![allow(clippy::disallowed_methods, reason = "figures for people: the clock, the arguments, a logarithm")]

use std::collections::BTreeMap;
use std::process::Command;
use std::sync::Arc;
use std::time::{SystemTime, UNIX_EPOCH};

use camino::{Utf8Path, Utf8PathBuf};
use tempfile::TempDir;
use val3_analysis::items::project::folder;
use val3_analysis::load::{Workspace, load};
use val3_analysis::system::Disk;
use val3_bytecode::Image;
use val3_machine::controller::{Controller, RunStatus};
use val3_machine::devices::{Devices, Libraries};
use val3_machine::event::EventKind;
use val3_machine::files::{ControllerPath, LibraryFiles, Roots};
use val3_test::Fixture;

/// Duration of a line in ns: the default of `val3 run`.
const LINE: u64 = 2000;

/// Number of runs per program, alternating with Lua.
const RUNS: usize = 7;

fn main() {
    let chosen: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let names = names().into_iter().filter(|name| chosen.is_empty() || chosen.contains(name));
    println!("{:28} {:>9} {:>9} {:>9}", "", "val3 ms", "lua ms", "val3/lua");
    let factors: Vec<f64> = names.map(|name| row(&name)).collect();
    let mean = (factors.iter().map(|factor| factor.ln()).sum::<f64>() / factors.len() as f64).exp();
    println!("{:28} {:>9} {:>9} {mean:9.2}", "geometric mean", "", "");
}

fn programs() -> Utf8PathBuf {
    Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join("programs/ordinary")
}

fn names() -> Vec<String> {
    let files = programs().read_dir_utf8().expect("the folder of the programs");
    let paths = files.map(|entry| entry.expect("an entry of the folder").into_path());
    let listings = paths.filter(|path| path.extension() == Some("val3"));
    let mut names: Vec<String> = listings.filter_map(|path| path.file_stem().map(str::to_owned)).collect();
    names.sort();
    names
}

/// Measures one program and prints its row.
fn row(name: &str) -> f64 {
    let listing = std::fs::read_to_string(programs().join(name).with_extension("val3")).expect("a listing");
    let application = Application::load(&listing);
    let images = application.compiled();
    let (mut val3, mut lua) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..RUNS {
        let started = processor_time();
        let printed = run(&images, &application);
        val3 = val3.min(processor_time() - started);
        let (expected, seconds) = run_lua(name);
        assert_eq!(printed.parse::<f64>(), expected.parse(), "the results of {name}");
        lua = lua.min(seconds);
    }
    let factor = val3 / lua;
    println!("{name:28} {:9.1} {:9.1} {factor:9.2}", val3 * 1e3, lua * 1e3);
    factor
}

/// Returns the processor time of this thread in s, so that other processes do not count. On other systems than Linux,
/// returns the time since the Unix epoch.
fn processor_time() -> f64 {
    let nanoseconds = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let running = nanoseconds.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    let now = || SystemTime::now().duration_since(UNIX_EPOCH).map_or(0.0, |time| time.as_secs_f64());
    running.map_or_else(now, |nanoseconds| nanoseconds / 1e9)
}

/// Returns the output of a Lua program, and its run time in s without the start of the process.
fn run_lua(name: &str) -> (String, f64) {
    let program = programs().join(name).with_extension("lua");
    let timed = format!("local t=os.clock() dofile('{program}') print(os.clock()-t)");
    let output = Command::new("lua5.4").args(["-e", &timed]).output().expect("lua5.4");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).expect("text");
    let (result, seconds) = text.trim_end().rsplit_once('\n').expect("a result and a time");
    (result.to_owned(), seconds.parse().expect("seconds"))
}

/// An application and its libraries, on a temporary disk.
struct Application {
    dir: TempDir,
    workspace: Workspace,
}

impl Application {
    fn load(listing: &str) -> Self {
        let dir = tempfile::tempdir().expect("a folder");
        let root = Utf8Path::from_path(dir.path()).expect("a path of characters");
        for (path, text) in Fixture::parse(listing).files {
            let path = root.join(path);
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
            std::fs::write(path, text).expect("a file");
        }
        let workspace = load(&Disk, &[root.to_owned()]).expect("a workspace");
        Self { dir, workspace }
    }

    fn disk(&self) -> Utf8PathBuf {
        Utf8Path::from_path(self.dir.path()).expect("a path of characters").join("usrapp")
    }

    /// Returns the images of all projects by folder.
    fn compiled(&self) -> BTreeMap<String, Arc<Image>> {
        let db = &self.workspace.db;
        let mut images = BTreeMap::new();
        for project in &self.workspace.projects {
            let name = folder(db, *project).file_name().unwrap_or_default().to_owned();
            if let Ok(image) = val3_compile::compile(db, *project) {
                images.insert(name, Arc::new(image));
            }
        }
        images
    }
}

/// Libraries that are compiled before the program runs.
struct Compiled(BTreeMap<String, Arc<Image>>);

impl Libraries for Compiled {
    fn image(&mut self, path: &ControllerPath, _: LibraryFiles) -> Result<Arc<Image>, String> {
        let name = path.parts().last().ok_or("no library")?.as_str();
        self.0.get(name).cloned().ok_or_else(|| format!("no library {name}"))
    }
}

/// Runs the application, and returns the line that it prints.
fn run(images: &BTreeMap<String, Arc<Image>>, application: &Application) -> String {
    let image = Arc::clone(images.get("main").expect("an application without faults"));
    let mut roots = Roots::default();
    roots.mount("Disk", &application.disk()).expect("a disk");
    let devices = Devices::new(roots, Box::new(Compiled(images.clone())));
    let mut controller =
        Controller::new(devices, image, "Disk://main".to_owned(), LINE).expect("memory for the program");
    controller.start("start").expect("a program start");
    let mut printed = String::new();
    loop {
        let status = controller.step();
        for event in controller.devices.take_events() {
            match event.kind {
                EventKind::Print { text } => printed = text,
                EventKind::Error { code, .. } => panic!("run-time error {code}"),
                _ => {}
            }
        }
        match status {
            RunStatus::Finished => return printed,
            RunStatus::Waiting(Some(wake)) => controller.jump(wake),
            RunStatus::Waiting(None) => panic!("the program does not end"),
            status if status.is_final() => panic!("the program ends with {status:?}"),
            _ => {}
        }
    }
}
