//! End-to-end tests of the `val3` command: arguments in, output and exit code out.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "a fault of a test may stop it")]
#![allow(clippy::disallowed_methods, reason = "a thread reads what a command writes")]

mod add_on_programs;
mod add_on_stand_ins;
mod archives;
mod arm;
mod attach;
mod baseline;
mod cell_distances;
mod check;
mod check_contacts;
mod check_motion;
mod configuration;
mod controller;
mod controller_pull;
#[cfg(unix)]
mod damage;
mod dap;
mod dap_client;
mod dap_contacts;
mod dap_overlay;
mod dap_parts;
mod dap_replay;
mod dap_test;
mod dap_torture;
mod diff;
mod diff_git;
#[cfg(unix)]
mod documents;
mod encrypted;
mod eval;
mod explain;
mod faulty_cell;
mod files;
mod fixes;
mod fmt;
mod formats;
mod git;
mod hostile;
mod hostile_cell;
mod idle_lines;
mod info;
mod io_errors;
mod io_library;
mod io_links;
mod killed;
#[cfg(unix)]
mod live;
mod log;
mod loose_files;
mod lsp;
mod manners;
mod mcp;
mod merge;
mod merge_git;
mod modbus;
mod new;
mod one_disk;
mod packaging;
#[cfg(unix)]
mod page_at_end;
mod page_bindings;
#[cfg(unix)]
mod page_clicks;
mod path_faults;
mod peers;
#[cfg(unix)]
mod prompt;
mod redirection;
mod refusal;
#[cfg(target_os = "linux")]
mod replacing;
mod replays;
mod ros;
mod run;
mod run_arms;
mod run_cell;
mod run_conveyors;
mod run_cycles;
mod run_default;
mod run_manual;
mod run_motion;
mod run_parts;
mod run_result;
mod run_scara;
mod run_waits;
mod script_names;
#[cfg(target_os = "linux")]
mod serial;
#[cfg(unix)]
mod serve;
mod serve_record;
mod silencing;
#[cfg(unix)]
mod soap;
mod statistics;
#[cfg(unix)]
mod strangers;
mod support;
#[cfg(unix)]
mod terminal;
mod test_cell;
mod test_command;
mod test_coverage;
mod test_examples;
mod test_exempt;
mod test_failures;
mod test_golden;
mod test_lines;
mod test_motion;
mod test_motion_limits;
mod test_mutate;
mod test_new;
mod test_paths;
mod test_private;
mod test_proof;
mod test_record;
mod test_reports;
mod test_scenarios;
mod test_selection;
mod test_tables;
mod trust;
#[cfg(target_os = "linux")]
mod unreadable;
mod usage;
mod waiting;
mod watch;
