//! Execution: `cargo bench --bench run`. In comparison with Lua and CPython: `cargo xtask metrics --run`.
//!
//! Targets: 0.8 times the run time of Lua 5.4 (geometric mean over the programs), at most 1.5 times for each program,
//! an hour of waiting in 0.2 s, and an hour of motion with its trace in 5 s: `val3 run --arm TX2-90 --trace FILE
//! benches/programs/moving`. Counting lines and branches for coverage reduces the speed by less than 30 %.

#![allow(missing_docs, reason = "benchmarks are named by their functions")]
#![allow(clippy::expect_used, clippy::panic, reason = "an application that fails measures nothing")]

use std::sync::Arc;

use camino::Utf8Path;
use divan::Bencher;
use val3_analysis::system::Disk;
use val3_bytecode::Image;
use val3_machine::controller::{Controller, RunStatus};
use val3_machine::devices::{Devices, Libraries};
use val3_machine::event::EventKind;
use val3_machine::files::{ControllerPath, LibraryFiles, Roots};
use val3_session::{Application, CodeForm, Pace};
use xtask::metrics::running::PROGRAMS;

/// Controller time of a line in ns, the default of `val3 run`.
const LINE: u64 = 2000;

fn main() {
    divan::main();
}

/// No program here loads a library.
struct NoLibraries;

impl Libraries for NoLibraries {
    fn image(&mut self, path: &ControllerPath, _: LibraryFiles) -> Result<Arc<Image>, String> {
        Err(format!("no library {path}"))
    }
}

/// Each application of `benches/programs`, without the time to compile it.
#[divan::bench(args = PROGRAMS, sample_count = 5, sample_size = 1)]
fn application(bencher: Bencher<'_, '_>, name: &str) {
    let image = compiled(name);
    bencher.with_inputs(|| Arc::clone(&image)).bench_local_values(run);
}

/// The same applications with counters of lines and branches.
#[divan::bench(args = PROGRAMS, sample_count = 5, sample_size = 1)]
fn counted_application(bencher: Bencher<'_, '_>, name: &str) {
    let image = application_of(name).compile_as(CodeForm::Counted).expect("the application has no faults");
    bencher.with_inputs(|| Arc::clone(&image)).bench_local_values(run);
}

/// Moves for an hour without a pause, like `val3 run` without a trace. A trace needs half as much time again.
#[divan::bench(sample_count = 3, sample_size = 1)]
fn an_hour_of_motion(bencher: Bencher<'_, '_>) {
    let image = compiled("moving");
    bencher.with_inputs(|| Arc::clone(&image)).bench_local_values(run);
}

fn compiled(name: &str) -> Arc<Image> {
    application_of(name).compile().expect("the application has no faults")
}

fn application_of(name: &str) -> Application {
    let manifest = Utf8Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("programs/{name}/{name}.pjx"));
    Application::open(&Disk, &manifest, None).expect("the application can be read")
}

/// Runs the application, and returns the line that it has logged.
fn run(image: Arc<Image>) -> Option<String> {
    let devices = Devices::new(Roots::default(), Box::new(NoLibraries));
    let mut controller =
        Controller::new(devices, image, "Disk://main".to_owned(), LINE).expect("memory for the application");
    controller.start("start").expect("a program start");
    let mut logged = None;
    loop {
        let step = controller.step();
        for event in controller.devices.take_events() {
            match event.kind {
                EventKind::Log { text, .. } => logged = Some(text),
                EventKind::Error { code, .. } => panic!("run-time error {code}"),
                _ => {}
            }
        }
        match step {
            RunStatus::Finished => return logged,
            RunStatus::Waiting(wake) if Pace::default().wait(&mut controller, wake).is_some() => {}
            RunStatus::Waiting(_) | RunStatus::Stuck | RunStatus::Unsupported => panic!("the application does not end"),
            _ => {}
        }
    }
}
