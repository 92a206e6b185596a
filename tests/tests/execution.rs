//! Execution of programs: statements, data and parameters (chapter 2), tasks (chapter 5), and the run-time errors that
//! need no arm.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a fault of a test may stop it")]

use expect_test::Expect;
use val3_tests::running::Running;

mod data;
mod data_errors;
mod life_cycle;
mod limits;
mod missing;
mod other_errors;
mod parameters;
mod references;
mod stack;
mod statements;
mod synchronization;
mod synchronous;
mod task_control;
mod task_errors;
mod turns;
mod user_types;
mod waiting;

/// Returns an application's entire output and the error numbers of its tasks. A second run must have the same events.
#[track_caller]
fn run(listing: &str) -> String {
    let [first, second] = [(), ()].map(|()| Running::start(listing).to_the_end());
    assert_eq!(first.events, second.events, "the second run differs");
    first.printed()
}

/// Like [`run`], with a comparison.
#[track_caller]
fn check(listing: &str, expected: Expect) {
    let printed = run(listing);
    // Spaces at the end of a line are invisible.
    expected.assert_eq(&printed.lines().map(|line| format!("{}\n", line.trim_end())).collect::<String>());
}

/// Declarations for each line.
const LOCALS: &str = "  num l_nValue\n  bool l_bFlag\n  string l_sText\n  point l_pPart\n  frame l_fPart\n  tool l_tPart\n  trsf l_trPart\n";

/// Checks `taskStatus` after each of the lines, which are executed by separate tasks: -1 without an error.
///
/// A line can use `LOCALS` and the programs `work`, `take` and `takeAll`.
#[track_caller]
fn errors(data: &str, lines: &[&str], expected: Expect) {
    let programs =
        lines.iter().enumerate().map(|(at, line)| format!("program line{at}()\n{LOCALS}begin\n  {line}\nend\n"));
    let tries = lines.iter().enumerate().map(|(at, line)| {
        let name = line.replace('"', "'").replace("\n ", ";");
        format!(
            "  taskCreate \"line\",100,line{at}()\n  wait(taskStatus(\"line\")!=1)\n  \
             ? toString(\"\",taskStatus(\"line\"))+\" {name}\"\n  taskKill(\"line\")\n"
        )
    });
    let listing = format!(
        "{data}\nprogram work()\nbegin\n  delay(1)\nend\nprogram take(num& x_nValue)\nbegin\nend\n\
         program takeAll(num& x_nValue[])\nbegin\nend\n{}program start()\nbegin\n{}end\n",
        programs.collect::<String>(),
        tries.collect::<String>()
    );
    let printed = run(&listing);
    let printed: Vec<&str> = printed.lines().filter(|line| !line.starts_with("error ")).collect();
    expected.assert_eq(&(printed.join("\n") + "\n"));
}
