//! Recordings repeat runs without the options and the actions of the recorded run.

use crate::support::{CommandOutput, Folder};

/// Records a run with `options`, and repeats it in another folder without options.
#[track_caller]
fn repeated(listing: &str, options: &[&str]) -> [CommandOutput; 2] {
    let (here, elsewhere) = (Folder::with(listing), Folder::with(listing));
    for folder in [&here, &elsewhere] {
        folder.write("day.toml", "power = true\nmonitor_speed = 40\n[[at]]\nt = 0.5\nkeys = \"12{Return}\"\n");
    }
    let recorded = here.val3(&[&["run", "--events", "run.jsonl"], options].concat());
    elsewhere.write("run.jsonl", &here.read("run.jsonl"));
    [recorded, elsewhere.val3(&["run", "--replay", "run.jsonl", "--events", "again.jsonl"])]
}

#[track_caller]
fn is_repeated(listing: &str, options: &[&str]) {
    let [recorded, repeated] = repeated(listing, options);
    assert_eq!((&repeated.stdout, repeated.code), (&recorded.stdout, recorded.code), "{repeated:?}");
    assert!(!repeated.stderr.contains("differs"), "{repeated:?}");
}

#[test]
fn the_folder_of_the_application_is_no_difference() {
    is_repeated("num nA\nnum nL[3]\nprogram start()\nbegin\n  nA=nL[9]\nend\nprogram stop()\nbegin\nend\n", &[]);
    is_repeated("bool bGo\nprogram start()\nbegin\n  wait(bGo)\nend\nprogram stop()\nbegin\nend\n", &[]);
}

#[test]
fn the_date_of_a_run_in_real_time_is_repeated() {
    let listing = "program start()\nbegin\n  ? getDate(\"%y-%m-%d %H:%M:%S\")\nend\nprogram stop()\nbegin\nend\n";
    is_repeated(listing, &["--time", "real"]);
}

#[test]
fn actions_and_options_are_repeated() {
    let listing = "num nKey\nnum nStep\nprogram start()\nbegin\n  nKey=get(nStep)\n  ? nStep\n  ? getMonitorSpeed()\n  ? isPowered()\n  \
                   ? nKey\nend\nprogram stop()\nbegin\nend\nprogram other()\nbegin\n  ? \"other\"\nend\n";
    is_repeated(listing, &["--script", "day.toml"]);
    is_repeated(listing, &["--keys", "34{Return}", "--set", "nKey=5", "--power", "--monitor-speed", "20"]);
    is_repeated(listing, &["--program", "other"]);
    let [_, repeated] = repeated(listing, &["--script", "day.toml"]);
    assert!(repeated.stdout.starts_with("12\n40\n"), "{repeated:?}");
}
